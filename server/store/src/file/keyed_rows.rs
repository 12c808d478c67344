//! Rows that have a hash, read on all cores and compared with it.

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::available_parallelism;

use sqlx::{Connection, SqliteConnection};
use tokio::runtime::Handle;
use tokio::sync::mpsc::{UnboundedSender, unbounded_channel};
use tokio::task::JoinSet;

use crate::answers::{result_rows, trades};
use crate::file::opening;
use crate::points::{evaluations, model_runs, study_points};
use crate::queue::{design_rows, engine_rows, estimator_rows, study_rows, sweep_rows};
use crate::store_error::StoreError;

/// Tables whose rows have a hash, with their keys, and the number of rows that are read at once.
const KEYED: [(&str, &str, usize); 8] = [
    ("evaluations", "select key from evaluations", AT_ONCE),
    ("model_runs", "select key from model_runs", AT_ONCE),
    ("start_states", "select key from start_states", 1),
    ("results", "select study from results", 1),
    ("studies", "select id from studies", 1),
    ("sweeps", "select id from sweeps", 1),
    ("estimators", "select id from estimators", 1),
    ("trades", "select distinct spec_sha256 from trades", 1),
];

/// Rows of one question, where it can ask for many: each takes a tenth of a millisecond beside what it reads.
const AT_ONCE: usize = 64;

/// Connections that read at once, each of which holds a row in memory.
const MOST_READERS: usize = 8;

/// Rows of a table that one connection reads at once.
#[derive(Debug)]
struct Group {
    table: &'static str,
    keys: Vec<String>,
}

/// Rows of a database that have a hash.
#[derive(Debug)]
pub(super) struct KeyedRows {
    counts: BTreeMap<&'static str, usize>,
    groups: Vec<Group>,
}

impl KeyedRows {
    /// Lists them.
    ///
    /// # Errors
    /// When the database can't be read.
    pub(super) async fn list(connection: &mut SqliteConnection) -> Result<Self, StoreError> {
        let (mut counts, mut groups) = (BTreeMap::new(), Vec::new());
        for (table, keys, at_once) in KEYED {
            let keys: Vec<String> = sqlx::query_scalar(keys).fetch_all(&mut *connection).await?;
            counts.insert(table, keys.len());
            groups.extend(keys.chunks(at_once).map(|keys| Group {
                table,
                keys: keys.to_owned(),
            }));
        }
        Ok(Self { counts, groups })
    }

    /// Rows by table.
    pub(super) fn counts(&self) -> BTreeMap<&'static str, usize> {
        self.counts.clone()
    }

    /// Reads all of them, and returns those that are damaged, a sentence each, in the order of the tables. Tells `seen` how many it has read, and of how many.
    ///
    /// # Errors
    /// When the database can't be read.
    pub(super) async fn faults(
        self,
        path: &Path,
        seen: &dyn Fn(usize, usize),
    ) -> Result<Vec<String>, StoreError> {
        let (mut done, of) = (0, self.counts.values().sum());
        seen(done, of);
        let (tell, mut told) = unbounded_channel();
        let work = Arc::new(Work {
            path: path.to_owned(),
            groups: self.groups,
            next: AtomicUsize::new(0),
        });
        let cores = available_parallelism().map_or(1, NonZeroUsize::get);
        let mut readers = JoinSet::new();
        // Comparing a result takes milliseconds, for which nobody else's answer should have to wait.
        for _ in 0..cores.min(MOST_READERS).min(work.groups.len()) {
            let (work, tell, runtime) = (Arc::clone(&work), tell.clone(), Handle::current());
            readers.spawn_blocking(move || runtime.block_on(work.read(&tell)));
        }
        drop(tell);
        let mut faults = vec![Vec::new(); work.groups.len()];
        while let Some((place, found)) = told.recv().await {
            done += work.groups[place].keys.len();
            faults[place] = found;
            seen(done, of);
        }
        for ended in readers.join_all().await {
            ended?;
        }
        Ok(faults.concat())
    }
}

/// Work that readers share.
struct Work {
    path: PathBuf,
    groups: Vec<Group>,
    /// Group that nobody has begun.
    next: AtomicUsize,
}

impl Work {
    /// Reads groups as long as there are any and somebody hears of their faults.
    async fn read(&self, tell: &UnboundedSender<(usize, Vec<String>)>) -> Result<(), StoreError> {
        let mut connection = opening::to_read(&self.path).await?;
        let read = async {
            loop {
                let place = self.next.fetch_add(1, Ordering::Relaxed);
                let Some(group) = self.groups.get(place) else {
                    return Ok(());
                };
                let faults = group.faults(&mut connection).await?;
                if tell.send((place, faults)).is_err() {
                    return Ok(());
                }
            }
        };
        let read = read.await;
        connection.close().await?;
        read
    }
}

impl Group {
    async fn faults(&self, connection: &mut SqliteConnection) -> Result<Vec<String>, StoreError> {
        // Of many rows at once only the first that is damaged is told.
        if damage(read(connection, self.table, &self.keys).await)?.is_none() {
            return Ok(Vec::new());
        }
        let mut faults = Vec::new();
        for key in self.keys.chunks(1) {
            faults.extend(damage(read(connection, self.table, key).await)?);
        }
        Ok(faults)
    }
}

/// Reads rows, and compares each with its hash.
async fn read(
    connection: &mut SqliteConnection,
    table: &str,
    keys: &[String],
) -> Result<(), StoreError> {
    match table {
        "evaluations" => return evaluations::find(connection, keys).await.map(drop),
        "model_runs" => return model_runs::find(connection, keys).await.map(drop),
        _ => {}
    }
    for key in keys {
        match table {
            "start_states" => evaluations::find_start(connection, key).await.map(drop),
            "results" => result_rows::check(connection, key).await,
            "studies" => check_study(connection, key).await,
            "sweeps" => check_sweep(connection, key).await,
            "estimators" => estimator_rows::check(connection, key).await,
            _ => trades::newest(connection, key).await.map(drop),
        }?;
    }
    Ok(())
}

/// Words for a row that is damaged; other failures stay.
fn damage(read: Result<(), StoreError>) -> Result<Option<String>, StoreError> {
    match read {
        Ok(()) => Ok(None),
        Err(error @ StoreError::Damaged { .. }) => Ok(Some(error.to_string())),
        Err(error) => Err(error),
    }
}

/// Checks its document, and which evaluations are its points.
async fn check_study(connection: &mut SqliteConnection, id: &str) -> Result<(), StoreError> {
    if let Some(study) = study_rows::find(connection, id).await? {
        study.document()?;
    }
    study_points::of(connection, id).await.map(|_| ())
}

async fn check_sweep(connection: &mut SqliteConnection, id: &str) -> Result<(), StoreError> {
    if let Some(sweep) = sweep_rows::find(connection, id).await? {
        sweep.document()?;
    }
    if let Some(given) = engine_rows::find(connection, id).await? {
        given.report()?;
    }
    design_rows::designs(connection, id, design_rows::ALL)
        .await
        .map(|_| ())
}
