//! Sweeps of a service whose designs other machines solve. Each has a thread; what is left in the end has its turns at home.
//!
//! - [`away_report`]: what becomes of a sweep's tasks
//! - `sweep_head`: database and wishes of a sweep

pub mod away_report;
mod sweep_head;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use service::engine::Engine;
use service::queue::Queue;
use service::work::shutdown::Shutdown;
use store::StoreError;
use store::queue::engine_rows::{self, EngineRow};
use tokio::runtime::Handle;
use tokio::sync::Notify;
use tokio::task::JoinSet;

use crate::engines::engine_name::{EngineName, EngineSettings};
use crate::rounds::Rounds;
use crate::rounds::head::{Head, Wish};
use crate::task_error::TaskError;
use crate::task_folder::Kept;
use away_report::{AwaySweep, EngineList, EngineView, Reports, TaskCounts, TaskReport};
use sweep_head::SweepHead;

/// Time to wait before what failed is tried again: room on a disk, or a folder that is away.
const RETRY: Duration = Duration::from_secs(5);
/// Interval at which the end of the service is looked for meanwhile.
const MOMENT: Duration = Duration::from_millis(100);
/// Sweeps that are away at once; others wait until one of them is back.
const AT_ONCE: usize = 32;
/// Sweeps that were away and are listed still.
const LISTED: usize = 20;

/// Engines that clients of a service may name, and where their tasks are kept.
#[derive(Debug, Clone, Default)]
pub struct Means {
    /// The engines.
    pub names: Vec<EngineName>,
    /// Settings of the engines.
    pub settings: EngineSettings,
    /// Folder of all tasks.
    pub folder: PathBuf,
    /// Whether that is nobody else's, and goes when nothing is left in it.
    pub is_own: bool,
    /// Time that a task should take on this machine's threads, minutes.
    pub minutes: f64,
    /// Extent of what is kept of what tasks hand in.
    pub kept: Kept,
}

/// Sweeps whose designs other machines solve.
pub struct Away {
    engine: Engine,
    queue: Arc<Queue>,
    means: Means,
    /// Reports of the sweeps that are away.
    reports: Reports,
    news: Notify,
    /// Whether the service stops.
    stop: AtomicBool,
    shutdown: Shutdown,
}

/// Reason why an engine isn't given a sweep.
#[derive(Debug, thiserror::Error)]
pub enum Unwilling {
    /// The service has no such engine: a sentence.
    #[error("{0}")]
    Unknown(String),
    /// The engine is missing or refuses, in its own words.
    #[error("the engine {}: {words}", name.as_str())]
    Refuses {
        /// Name of the engine.
        name: EngineName,
        /// Words of the engine.
        words: String,
    },
}

impl Away {
    /// Sweeps of a queue, for engines that solve what it would.
    pub fn new(engine: Engine, queue: Arc<Queue>, means: Means, shutdown: Shutdown) -> Self {
        Self {
            engine,
            queue,
            means,
            reports: Reports::default(),
            news: Notify::new(),
            stop: AtomicBool::new(false),
            shutdown,
        }
    }

    /// Asks an engine, by its name, whether it would take a task.
    ///
    /// # Errors
    /// See [`Unwilling`].
    pub async fn willing(&self, name: &str) -> Result<EngineName, Unwilling> {
        let mut names = self.means.names.iter();
        let Some(&name) = names.find(|own| own.as_str() == name) else {
            return Err(self.unknown(name));
        };
        let engine = self.means.settings.engine(name);
        let engine = engine.map_err(|error| Unwilling::Unknown(error.to_string()))?;
        let asked = tokio::task::spawn_blocking(move || engine.asked()).await;
        let asked = asked.unwrap_or_else(|_| Err("it can't be asked".to_owned()));
        asked.map_err(|words| Unwilling::Refuses { name, words })?;
        Ok(name)
    }

    fn unknown(&self, name: &str) -> Unwilling {
        let own: Vec<&str> = self.means.names.iter().map(|own| own.as_str()).collect();
        let has = match own.as_slice() {
            [] => "none: strainsite serve --engine slurm lets clients name it".to_owned(),
            own => own.join(" and "),
        };
        Unwilling::Unknown(format!(
            "there is no engine {name:?} here; this service has {has}"
        ))
    }

    /// Looks for sweeps that were given to an engine.
    pub fn look(&self) {
        self.news.notify_one();
    }

    /// Lists the engines, with the sweeps that they have or had.
    ///
    /// # Errors
    /// When the database can't be read, or is damaged.
    pub async fn list(&self) -> Result<EngineList, StoreError> {
        let mut connection = self.engine.store.read().await?;
        let rows = engine_rows::list(&mut connection, LISTED).await?;
        drop(connection);
        let view = |&name: &EngineName| {
            let own = rows.iter().filter(|row| row.engine == name.as_str());
            let sweeps: Vec<AwaySweep> = own.map(|row| self.view(row)).collect::<Result<_, _>>()?;
            let going = sweeps.iter().filter(|sweep| sweep.ended.is_none());
            Ok(EngineView {
                name,
                tasks: TaskCounts::sum(going.map(|sweep| sweep.report.tasks)),
                sweeps,
            })
        };
        let engines: Result<_, StoreError> = self.means.names.iter().map(view).collect();
        Ok(EngineList { engines: engines? })
    }

    fn view(&self, row: &EngineRow) -> Result<AwaySweep, StoreError> {
        let stored = row.report()?;
        let report = match row.ended {
            Some(_) => serde_json::from_str(stored).unwrap_or_default(),
            None => self.reports.of(&row.sweep),
        };
        Ok(AwaySweep {
            sweep: row.sweep.clone(),
            report,
            ended: row.ended.clone(),
        })
    }

    /// Has sweeps solved elsewhere until the service stops. Their tasks go on then, and are found again.
    pub async fn work(self: Arc<Self>) {
        let mut shutdown = self.shutdown.clone();
        let mut threads = JoinSet::new();
        loop {
            match self.begun().await {
                Ok(rows) => {
                    for row in rows {
                        let (own, runtime) = (self.clone(), Handle::current());
                        threads.spawn_blocking(move || own.solve_or_say(&row, &runtime));
                    }
                }
                Err(error) => {
                    tracing::error!(%error, "sweeps for other machines can't be looked for; they are at the next one");
                }
            }
            tokio::select! {
                () = self.news.notified() => {}
                Some(_) = threads.join_next() => {}
                () = shutdown.wait() => break,
            }
        }
        self.stop.store(true, Ordering::Relaxed);
        while threads.join_next().await.is_some() {}
    }

    /// Sweeps that nobody here has yet.
    async fn begun(&self) -> Result<Vec<EngineRow>, StoreError> {
        let mut connection = self.engine.store.read().await?;
        let mut rows = engine_rows::list(&mut connection, 0).await?;
        // The oldest first.
        rows.reverse();
        let mut reports = self.reports.all();
        rows.retain(|row| !reports.contains_key(&row.sweep));
        rows.truncate(AT_ONCE.saturating_sub(reports.len()));
        for row in &rows {
            reports.insert(row.sweep.clone(), TaskReport::default());
        }
        Ok(rows)
    }

    /// Has a sweep solved; one whose thread breaks has its turns here.
    fn solve_or_say(&self, row: &EngineRow, runtime: &Handle) {
        let solved = catch_unwind(AssertUnwindSafe(|| self.solve(row, runtime)));
        if solved.is_err() {
            let words = "giving it away broke; the log says where";
            self.reports.change(&row.sweep, |report| report.say(words));
            self.end(row, runtime);
        }
    }

    /// Has a sweep solved until that has an end, or the service stops.
    fn solve(&self, row: &EngineRow, runtime: &Handle) {
        let sweep = row.sweep.as_str();
        let head = SweepHead {
            engine: &self.engine,
            reports: &self.reports,
            stop: &self.stop,
            runtime,
            sweep,
            looked: Mutex::default(),
        };
        loop {
            match self.solved(row, &head, runtime) {
                Ok(()) => break,
                Err(TaskError::Stopped) => match head.wish() {
                    Wish::Leave => return,
                    // Nobody wants what it has any more.
                    _ => break drop(fs::remove_dir_all(self.folder(sweep))),
                },
                Err(error @ (TaskError::Engine(_) | TaskError::Asked(_))) => {
                    tracing::warn!(sweep, %error, "a sweep is solved here: its engine has no use");
                    self.reports
                        .change(sweep, |report| report.say(&error.to_string()));
                    break;
                }
                Err(error) => {
                    tracing::error!(sweep, %error, "tasks for other machines wait");
                    self.reports
                        .change(sweep, |report| report.say(&error.to_string()));
                    self.wait();
                }
            }
        }
        if self.means.is_own {
            // Empty but for what was refused.
            let _ = fs::remove_dir(&self.means.folder);
        }
        self.end(row, runtime);
    }

    fn solved(
        &self,
        row: &EngineRow,
        head: &SweepHead<'_>,
        runtime: &Handle,
    ) -> Result<(), TaskError> {
        let named = |name: &&EngineName| name.as_str() == row.engine;
        let name = self.means.names.iter().find(named);
        let name = name.ok_or_else(|| TaskError::Asked(self.unknown(&row.engine).to_string()))?;
        let mut engine = self.means.settings.engine(*name)?;
        let rounds = Rounds {
            runtime,
            head,
            sweep: &row.sweep,
            folder: self.folder(&row.sweep),
            solver: self.engine.solver.clone(),
            minutes: self.means.minutes,
            kept: self.means.kept,
        };
        rounds.solve(engine.as_mut())
    }

    fn folder(&self, sweep: &str) -> PathBuf {
        self.means.folder.join(sweep)
    }

    /// Lets what is left of a sweep have its turns here, however long the database takes to be writable again.
    fn end(&self, row: &EngineRow, runtime: &Handle) {
        let sweep = row.sweep.as_str();
        let Ok(report) = serde_json::to_string(&self.reports.of(sweep)) else {
            return;
        };
        let ended = || {
            runtime.block_on(async {
                let mut transaction = self.engine.store.begin().await?;
                engine_rows::end(&mut transaction, row, &report).await?;
                self.queue.admit(transaction).await
            })
        };
        while let Err(error) = ended() {
            tracing::error!(sweep, %error, "the end of a sweep's tasks could not be recorded yet");
            if self.stop.load(Ordering::Relaxed) {
                return;
            }
            self.wait();
        }
        self.reports.all().remove(sweep);
        tracing::info!(sweep, "nothing of a sweep is solved elsewhere any more");
        // Another one may wait for its place, and so may this one that was given away once more.
        self.look();
    }

    /// Waits before something is tried again, unless the service stops.
    fn wait(&self) {
        let begun = Instant::now();
        while begun.elapsed() < RETRY && !self.stop.load(Ordering::Relaxed) {
            std::thread::sleep(MOMENT);
        }
    }
}
