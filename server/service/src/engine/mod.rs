//! Runs one claimed study from its document to its end, the same for the service and for the command line.
//!
//! A study that was interrupted anywhere is run again as if it were new: its plan is the same, the archive has the
//! points that were solved, and what is lacking is solved from the same start.

mod answered;
mod shared_part;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use documents::study::Study;
use documents::study::plan::PlannedStudy;
use fem_client::solver::Solver;
use placement::estimate::Pace;
use placement::ladder::climb;
use placement::points::Event;
use placement::points::RunContext;
use placement::points::RunError;
use placement::points::usage::Stopwatch;
use placement::score::assemble::version;
use results::{FailedPoint, StudyResult};
use serde_json::{Value, json};
use tokio::runtime::Handle;

use crate::database_archive::StoreArchive;
use crate::engine::answered::{Answered, answered};
use crate::forecast::{ForecastError, forecast_next, pace};
use crate::metrics::{Metrics, PointOutcome};
use crate::solving::live::{Live, Turn};
use crate::solving::timekeeper::Timekeeper;
use crate::solving::traced::Traced;
use crate::study_document::stored_plan;
use crate::work::memory_share::MemoryShare;
use crate::work::shutdown::unless_stopped;
use store::answers::result_rows;
use store::queue::event_rows;
use store::queue::study_rows::{self, State, StudyRow};
use store::queue::turns;
use store::{Store, StoreError};

/// Engine that runs studies.
#[derive(Clone)]
pub struct Engine {
    /// Store of points and results.
    pub store: Arc<Store>,
    /// Solver of the points.
    pub solver: Arc<dyn Solver>,
    /// Solves that run at once.
    pub threads: usize,
    /// Counts points.
    pub metrics: Arc<Metrics>,
    /// Tells of the solves under way.
    pub live: Arc<Live>,
    /// Memory that is shared with fits.
    pub memory: Arc<MemoryShare>,
}

/// End of a run.
#[derive(Debug)]
pub enum End {
    /// End with a result.
    Done(Box<StudyResult>),
    /// End without a result.
    Failed {
        /// Reason, a sentence.
        error: String,
        /// The points that have no response.
        points: Vec<FailedPoint>,
    },
    /// End on request; what was solved is kept.
    Stopped,
    /// End for another study's turn; what was solved is kept.
    Paused,
    /// End of a run whose database takes nothing: the disk is full, or its files are gone; what was stored before is kept.
    Unstorable(StoreError),
}

impl End {
    /// Returns a word for the log.
    pub fn as_str(&self) -> &'static str {
        match self {
            Self::Done(_) => "done",
            Self::Failed { .. } => "failed",
            Self::Stopped => "stopped",
            Self::Paused => "paused",
            Self::Unstorable(_) => "database unwritable",
        }
    }

    /// End of a run that an error ended.
    fn of(error: &RunError, archive: &StoreArchive) -> Self {
        match (error, archive.unwritable()) {
            (RunError::Stopped, _) => Self::Stopped,
            (RunError::Paused, _) => Self::Paused,
            (RunError::Archive(_), Some(cause)) => Self::Unstorable(cause),
            _ => Self::Failed {
                error: error.to_string(),
                points: error.failed_points().to_vec(),
            },
        }
    }

    /// A failure that no single point is to blame for.
    pub fn failed(error: impl Into<String>) -> Self {
        Self::Failed {
            error: error.into(),
            points: Vec::new(),
        }
    }
}

impl Engine {
    /// Runs a claimed study until it ends, `stop` is set, or `pause` is and the solves in flight have ended. Blocks: call it on a
    /// plain thread.
    pub fn run(
        &self,
        row: &StudyRow,
        runtime: &Handle,
        stop: &AtomicBool,
        pause: Option<&AtomicBool>,
        progress: &(dyn Fn(&Event) + Sync),
    ) -> End {
        // Of the highest level, so that no filter takes the study's name from a line that it lets through.
        let span = tracing::error_span!("study", study = row.id);
        let _entered = span.enter();
        let watch = Stopwatch::start();
        let preparing = unless_stopped(stop, self.prepared(row));
        let (planned, pace) = match runtime.block_on(preparing) {
            Some(Ok(prepared)) => prepared,
            Some(Err(error)) => return End::failed(error),
            None => return End::Stopped,
        };
        let needed = pace
            .as_ref()
            .map_or(0, |pace| pace.estimate().peak_memory_bytes);
        let taking = unless_stopped(stop, self.memory.take(needed));
        let Some(_memory) = runtime.block_on(taking) else {
            return End::Stopped;
        };
        let timekeeper = Arc::new(Timekeeper::new(pace));
        let archive = StoreArchive::new(
            self.store.clone(),
            runtime.clone(),
            &row.id,
            self.metrics.clone(),
            timekeeper.clone(),
        );
        let tell = |event: Event| {
            let _entered = span.enter();
            self.live.event(&event);
            if let Err(error) = runtime.block_on(self.record(&row.id, &event)) {
                tracing::warn!(study = row.id, %error, "an event could not be recorded");
            }
            self.metrics.event(&event);
            progress(&event);
        };
        let observer = |event: Event| {
            tell(event);
            if let Some(estimate) = timekeeper.revised() {
                tell(Event::Revised(Box::new(estimate)));
            }
        };
        let solver = Traced::new(self.solver.clone(), span.clone());
        let _solves = Turn::begin(&self.live, &row.id);
        let context = RunContext {
            solver: &solver,
            archive: &archive,
            threads: self.threads,
            stop,
            pause,
            observer: &observer,
        };
        let PlannedStudy { study, plan } = &*planned;
        let estimate = timekeeper.estimate();
        if let Some(Answered { mut result, points }) = runtime.block_on(self.answered(row, study)) {
            observer(Event::Started {
                points,
                reused: points,
            });
            result.estimate = estimate;
            runtime.block_on(self.tell_surer(study, &mut result));
            (result.cost.wall_s, result.cost.cpu_s) = (0.0, 0.0);
            watch.add_to(&mut result.cost);
            return End::Done(Box::new(result));
        }
        match climb::answer(study, plan, context) {
            Ok(mut result) => {
                result.estimate = estimate;
                runtime.block_on(self.tell_surer(study, &mut result));
                result.study.id.clone_from(&row.id);
                End::Done(Box::new(result))
            }
            Err(error) => End::of(&error, &archive),
        }
    }

    /// The plan of a study, and what it is expected to take.
    async fn prepared(&self, row: &StudyRow) -> Result<(Arc<PlannedStudy>, Option<Pace>), String> {
        // A row that was exchanged with another one isn't what it was claimed as.
        let mut connection = self.store.read().await.map_err(|error| error.to_string())?;
        study_rows::find(&mut connection, &row.id)
            .await
            .map_err(|error| error.to_string())?;
        drop(connection);
        let own = row.clone();
        let planned = tokio::task::spawn_blocking(move || stored_plan(&own)).await;
        let planned = planned.map_err(|_| ForecastError::Broken.to_string())??;
        let planned = Arc::new(planned);
        let pace = self.expected(row, &planned).await;
        Ok((planned, pace))
    }

    /// The answer of an earlier study of the same document. Where there is none, or it can't be had, the study is computed.
    async fn answered(&self, row: &StudyRow, study: &Study) -> Option<Answered> {
        let version = version(&self.solver.version());
        let found = answered(&self.store, row, study, &version).await;
        let found = found.unwrap_or_else(|error| {
            tracing::warn!(%error, "whether the study was answered before isn't known");
            None
        })?;
        let shared = u64::try_from(found.points).unwrap_or(0);
        self.metrics.points(PointOutcome::Reused, shared);
        Some(found)
    }

    /// Estimates what the study takes, and stores that with it. Not worth a study: without it the study runs too.
    async fn expected(&self, row: &StudyRow, planned: &Arc<PlannedStudy>) -> Option<Pace> {
        let store = Some(&*self.store);
        let pace = match pace(store, &self.solver, self.threads, planned).await {
            Ok(pace) => pace,
            Err(error) => {
                tracing::warn!(%error, "the study's cost could not be estimated");
                return None;
            }
        };
        let stored = async {
            let mut transaction = self.store.begin().await?;
            study_rows::set_estimate(&mut transaction, &row.id, pace.estimate()).await?;
            self.store.commit(transaction, 0).await
        };
        if let Err(error) = stored.await {
            tracing::warn!(%error, "the study's estimate could not be stored");
        }
        Some(pace)
    }

    /// Adds to an answer what a surer one costs. Not worth a study: without it the answer stands.
    async fn tell_surer(&self, study: &Study, result: &mut StudyResult) {
        let Some(answer) = &mut result.answer else {
            return;
        };
        answer.surer = match forecast_next(
            &self.store,
            &self.solver,
            self.threads,
            study,
            &result.model.level,
        )
        .await
        {
            Ok(surer) => surer,
            Err(error) => {
                tracing::warn!(%error, "what a surer answer costs isn't known");
                None
            }
        };
    }

    /// Stores an event, unless it is for those alone who look now.
    async fn record(&self, study: &str, event: &Event) -> Result<(), StoreError> {
        let Some((kind, payload)) = wire(event) else {
            return Ok(());
        };
        let mut transaction = self.store.begin().await?;
        // A solve may end after its study was cancelled: its point is kept, but nothing comes after the last event.
        if !study_rows::is_running(&mut transaction, study).await? {
            return Ok(());
        }
        if let Some((total, done)) = progress_of(event) {
            study_rows::set_progress(&mut transaction, study, total, done).await?;
        }
        if let Event::Revised(estimate) = event {
            study_rows::set_estimate(&mut transaction, study, estimate).await?;
        }
        let id = event_rows::insert(&mut transaction, study, kind, &payload).await?;
        self.store.commit(transaction, id).await
    }

    /// Records how a run ended. Returns false, and changes nothing, when the study was cancelled meanwhile.
    ///
    /// # Errors
    /// When the database can't be written; then the study is still running and this can be tried again.
    pub async fn settle(&self, row: &StudyRow, end: &End) -> Result<bool, StoreError> {
        let mut transaction = self.store.begin().await?;
        if !study_rows::is_running(&mut transaction, &row.id).await? {
            // Before its result, for which there may be no room.
            return Ok(false);
        }
        let (kind, payload) = match end {
            End::Done(result) => {
                result_rows::insert(&mut transaction, &row.id, result).await?;
                let sha256 = result_rows::sha256_of(&mut transaction, &row.id).await?;
                study_rows::finish(&mut transaction, &row.id, State::Done, None).await?;
                ("done", json!({"result_sha256": sha256}))
            }
            End::Failed { error, points } => {
                let cause = Some(error.as_str());
                study_rows::finish(&mut transaction, &row.id, State::Failed, cause).await?;
                ("failed", json!({"error": error, "failed_points": points}))
            }
            End::Stopped | End::Unstorable(_) => {
                turns::release(&mut transaction, &row.id).await?;
                ("queued", json!({"resumed": true}))
            }
            End::Paused => {
                turns::pass_on(&mut transaction, &row.id).await?;
                ("queued", json!({"resumed": true}))
            }
        };
        let id = event_rows::insert(&mut transaction, &row.id, kind, &payload).await?;
        self.store.commit(transaction, id).await?;
        Ok(true)
    }
}

/// Total and finished points, when the event changes them.
fn progress_of(event: &Event) -> Option<(usize, usize)> {
    match *event {
        Event::Started { points, reused } => Some((points, reused)),
        Event::PointSolved { done, of, .. } | Event::PointFailed { done, of, .. } => {
            Some((of, done))
        }
        Event::Solving { .. } | Event::Analysing | Event::Revised(_) => None,
    }
}

/// Name and content of an event that is stored.
fn wire(event: &Event) -> Option<(&'static str, Value)> {
    Some(match event {
        Event::Solving { .. } => return None,
        Event::Started { points, reused } => {
            ("started", json!({"points": points, "reused": reused}))
        }
        Event::PointSolved {
            ordinal,
            done,
            of,
            wall_s,
            newton_iterations,
        } => (
            "point-solved",
            json!({
                "ordinal": ordinal,
                "done": done,
                "of": of,
                "wall_s": wall_s,
                "newton_iterations": newton_iterations,
            }),
        ),
        Event::PointFailed {
            ordinal,
            done,
            of,
            cause,
        } => (
            "point-failed",
            json!({"ordinal": ordinal, "done": done, "of": of, "cause": cause}),
        ),
        Event::Analysing => ("analysing", json!({})),
        Event::Revised(estimate) => (
            "estimate-revised",
            json!({"wall_s": estimate.wall_s, "reason": estimate.reasons.last()}),
        ),
    })
}
