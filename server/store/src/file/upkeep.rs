//! Looking after the database file: whether it is whole, its free pages given back.
//!
//! A check reads a snapshot and may run beside the service.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;
use sqlx::{Connection, SqliteConnection};

use crate::answers::result_rows;
use crate::answers::trades;
use crate::file::condition;
use crate::file::lock::DatabaseLock;
use crate::file::opening::{self, Missing};
use crate::points::crashes;
use crate::points::evaluations;
use crate::points::model_runs;
use crate::points::study_points;
use crate::queue::design_rows;
use crate::queue::engine_rows;
use crate::queue::estimator_rows;
use crate::queue::study_rows;
use crate::queue::sweep_rows;
use crate::seals;
use crate::store_error::StoreError;

/// Findings of a check.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Inspection {
    /// Rows that were read, by table.
    pub rows: BTreeMap<&'static str, usize>,
    /// Faults, a sentence each; none: all is well.
    pub faults: Vec<String>,
}

/// Reads everything: SQLite's own structures, every reference, every hash, and that each study has the points it counts. Tells `seen` how
/// many rows it has read, and of how many.
///
/// # Errors
/// When the database can't be read at all.
pub async fn inspect(
    connection: &mut SqliteConnection,
    seen: &dyn Fn(usize, usize),
) -> Result<Inspection, StoreError> {
    let mut found = Inspection::default();
    let mut tables = Vec::new();
    for (table, keys) in KEYED {
        let keys: Vec<String> = sqlx::query_scalar(keys).fetch_all(&mut *connection).await?;
        found.rows.insert(table, keys.len());
        tables.push((table, keys));
    }
    let (mut done, of) = (0, found.rows.values().sum());
    seen(done, of);
    let verdicts: Vec<String> = sqlx::query_scalar("pragma integrity_check(20)")
        .fetch_all(&mut *connection)
        .await?;
    let damages = verdicts.into_iter().filter(|verdict| verdict != "ok");
    found.faults.extend(damages);
    found.faults.extend(dangling(connection).await?);
    for (table, keys) in tables {
        for keys in keys.chunks(AT_ONCE) {
            // Of many rows at once only the first that is damaged is told.
            if !are_whole(connection, table, keys).await? {
                for key in keys {
                    let read = read(connection, table, key).await;
                    found.faults.extend(damage(read)?);
                }
            }
            done += keys.len();
            seen(done, of);
        }
    }
    found.faults.extend(seals::broken(connection).await?);
    found.faults.extend(short(connection).await?);
    found.faults.extend(gaps(connection).await?);
    Ok(found)
}

/// Tables whose rows have a hash, with their keys.
const KEYED: [(&str, &str); 8] = [
    ("evaluations", "select key from evaluations"),
    ("model_runs", "select key from model_runs"),
    ("start_states", "select key from start_states"),
    ("results", "select study from results"),
    ("studies", "select id from studies"),
    ("sweeps", "select id from sweeps"),
    ("estimators", "select id from estimators"),
    ("trades", "select distinct spec_sha256 from trades"),
];

/// Rows of a table that are read at once, where that can be done: each question takes a tenth of a millisecond beside what it reads.
const AT_ONCE: usize = 64;

/// Whether rows that can be read at once are whole; false where they can't.
async fn are_whole(
    connection: &mut SqliteConnection,
    table: &str,
    keys: &[String],
) -> Result<bool, StoreError> {
    let read = match table {
        "evaluations" => evaluations::find(connection, keys).await.map(drop),
        "model_runs" => model_runs::find(connection, keys).await.map(drop),
        _ => return Ok(false),
    };
    damage(read).map(|damage| damage.is_none())
}

/// Reads a row, and compares it with its hash.
async fn read(connection: &mut SqliteConnection, table: &str, key: &str) -> Result<(), StoreError> {
    let one = || [key.to_owned()];
    match table {
        "evaluations" => evaluations::find(connection, &one()).await.map(drop),
        "model_runs" => model_runs::find(connection, &one()).await.map(drop),
        "start_states" => evaluations::find_start(connection, key).await.map(drop),
        "results" => result_rows::check(connection, key).await,
        "studies" => check_study(connection, key).await,
        "sweeps" => check_sweep(connection, key).await,
        "estimators" => estimator_rows::check(connection, key).await,
        _ => trades::newest(connection, key).await.map(drop),
    }
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

async fn dangling(connection: &mut SqliteConnection) -> Result<Vec<String>, StoreError> {
    let rows: Vec<(String, Option<i64>, String)> =
        sqlx::query_as("select \"table\", rowid, parent from pragma_foreign_key_check limit 20")
            .fetch_all(connection)
            .await?;
    let sentence = |(table, _, parent)| {
        format!("a row of table {table} refers to one of {parent} that isn't there")
    };
    Ok(rows.into_iter().map(sentence).collect())
}

/// Studies that count more points than they have, a sentence each.
async fn short(connection: &mut SqliteConnection) -> Result<Vec<String>, StoreError> {
    let studies = study_points::short(connection, None).await?;
    let sentence = |(id, done, points)| format!("study {id} counts {done} points and has {points}");
    Ok(studies.into_iter().map(sentence).collect())
}

/// Gaps: what a state or a row promises and isn't there.
async fn gaps(connection: &mut SqliteConnection) -> Result<Vec<String>, StoreError> {
    let query = "select 'study ' || id || ' is done and has no result' from studies
             where state = 'done' and not exists (select 1 from results where study = id)
         union all
         select 'study ' || id || ' has ended and its events don''t say so' from studies
             where state in ('done', 'failed', 'cancelled') and coalesce((select kind from events where study = studies.id order by id desc limit 1), '') <> state
         union all
         select 'an event of study ' || study || ' before its event ' || id || ' is missing' from events
             where previous is not (select max(id) from events as earlier where earlier.study = events.study and earlier.id < events.id)
         union all
         select 'the equilibrium from which points of study ' || study || ' start is missing' from study_points p join evaluations e on e.key = p.evaluation
             where ordinal = 0 and e.failure is null and not exists (select 1 from start_states where key = p.evaluation)
         limit 100";
    Ok(sqlx::query_scalar(query).fetch_all(connection).await?)
}

/// Bytes that a copy will have: those of all pages that aren't free.
///
/// # Errors
/// When the database can't be read.
pub async fn used_bytes(connection: &mut SqliteConnection) -> Result<u64, StoreError> {
    let bytes: i64 = sqlx::query_scalar(
        "select (page_count - freelist_count) * page_size
         from pragma_page_count, pragma_freelist_count, pragma_page_size",
    )
    .fetch_one(connection)
    .await?;
    Ok(u64::try_from(bytes).unwrap_or(0))
}

/// Pages, of 4 kB, without which there is no use in taking more in.
const SPARE_PAGES: i64 = 256;

/// Refuses to take more in when the file has nearly grown as far as it may. Asks the connection that writes: the limit is its own.
///
/// # Errors
/// [`StoreError::Full`]; when the database can't be read.
pub async fn check_room(connection: &mut SqliteConnection) -> Result<(), StoreError> {
    let pages: i64 = sqlx::query_scalar(
        "select max_page_count - page_count + freelist_count
         from pragma_max_page_count, pragma_page_count, pragma_freelist_count",
    )
    .fetch_one(connection)
    .await?;
    if pages < SPARE_PAGES {
        return Err(StoreError::Full);
    }
    Ok(())
}

/// Gives free pages back to the disk. Nobody else may use the database meanwhile.
///
/// # Errors
/// [`StoreError::InUse`] when somebody does; when the database can't be written.
pub async fn compact(path: &Path) -> Result<(), StoreError> {
    let (_lock, mut connection) = alone(path).await?;
    sqlx::query("vacuum").execute(&mut connection).await?;
    sqlx::query("pragma wal_checkpoint(truncate)")
        .execute(&mut connection)
        .await?;
    Ok(connection.close().await?)
}

/// Lets points be solved again that the program died of, and returns how many there were. Nobody else may use the database
/// meanwhile.
///
/// # Errors
/// As [`compact`].
pub async fn release(path: &Path) -> Result<u64, StoreError> {
    let (_lock, mut connection) = alone(path).await?;
    let released = crashes::forget(&mut connection).await?;
    connection.close().await?;
    Ok(released)
}

/// The database for this process alone.
///
/// # Errors
/// [`StoreError::InUse`] when somebody uses it; when it can't be opened.
pub(crate) async fn alone(path: &Path) -> Result<(DatabaseLock, SqliteConnection), StoreError> {
    let (place, lock) = opening::to_write(path, Missing::Refused).await?;
    opening::to_read(path).await?.close().await?;
    Ok((lock, condition::connect(condition::options(&place)).await?))
}
