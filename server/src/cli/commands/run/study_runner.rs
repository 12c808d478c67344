//! A study that is run to its end, or from where it was interrupted, in the database.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use documents::study::Study;
use documents::study::plan::PlannedStudy;
use fem_client::solver::NoEquilibrium;
use results::{FailedPoint, StudyResult};
use serde_json::json;
use tokio::runtime::Runtime;

use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::progress::{progress_bar, show};
use crate::cli::terminal::signals::stop_flag;
use crate::config::Config;
use service::engine::{End, Engine};
use service::forecast::admit;
use service::queue::{enqueue, recover};
use store::queue::study_rows::{self, StudyRow};
use store::queue::turns;
use store::{Store, StoreError};

/// Runner of studies, with its database open.
pub(crate) struct StudyRunner<'c> {
    config: &'c Config,
    /// Runs what waits.
    pub runtime: Runtime,
    /// Solves, and keeps what is solved.
    pub engine: Engine,
    /// Set when the user ends the program.
    pub stop: Arc<AtomicBool>,
}

impl<'c> StudyRunner<'c> {
    /// Opens the database, unless the study needs more memory than there is.
    pub fn open(
        config: &'c Config,
        solver: &SolverOption,
        planned: &Arc<PlannedStudy>,
    ) -> Result<Self, Failure> {
        let runtime = Runtime::new().map_err(Failure::other)?;
        let solver = solver.solver().map_err(Failure::other)?;
        let (threads, memory_bytes) = (config.threads(), config.memory_bytes());
        runtime
            .block_on(admit(&solver, threads, memory_bytes, planned))
            .map_err(|error| Failure::input(error.to_string()))?;
        let store = runtime.block_on(config.open()).map_err(Failure::other)?;
        let stop = stop_flag(&runtime)?;
        Ok(Self {
            config,
            runtime,
            engine: config.work.engine(solver, store),
            stop,
        })
    }

    /// Runs the study, does something with its answer, and closes the database.
    pub fn answered<T>(
        &self,
        study: &Study,
        then: impl FnOnce(&StudyResult) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let done = self.solve(study).and_then(|end| self.result(end));
        let done = done.and_then(|result| then(&result));
        let closed = self.runtime.block_on(self.engine.store.close());
        let done = done?;
        closed.map_err(Failure::other)?;
        Ok(done)
    }

    fn solve(&self, study: &Study) -> Result<End, Failure> {
        let (runtime, engine) = (&self.runtime, &self.engine);
        let row = runtime
            .block_on(claim(&engine.store, study))
            .map_err(Failure::other)?;
        let bar = progress_bar("");
        let end = engine.run(&row, runtime.handle(), &self.stop, None, &|event| {
            show(&bar, event)
        });
        bar.finish_and_clear();
        runtime
            .block_on(engine.settle(&row, &end))
            .map_err(Failure::other)?;
        Ok(end)
    }

    fn result(&self, end: End) -> Result<Box<StudyResult>, Failure> {
        match end {
            End::Done(result) => Ok(result),
            End::Failed { error, points } => Err(failure(error, &points)),
            End::Unstorable(error) => Err(Failure::other(error)),
            End::Stopped | End::Paused => Err(Failure::Other(format!(
                "stopped; what is solved is kept in {}, and the next run of this study resumes there",
                self.config.db.display()
            ))),
        }
    }
}

/// Takes the interrupted study of the same document up again, or stores a new one.
async fn claim(store: &Store, study: &Study) -> Result<StudyRow, StoreError> {
    recover(store).await?;
    let mut transaction = store.begin().await?;
    let sha256 = study.spec_sha256();
    let id = match study_rows::queued_twin(&mut transaction, &sha256).await? {
        Some(row) => row.id,
        None => enqueue(&mut transaction, study, 0).await?,
    };
    let row = turns::claim(&mut transaction, &id).await?;
    store.commit(transaction, 0).await?;
    row.ok_or(StoreError::Database(sqlx::Error::RowNotFound))
}

/// The physics is to blame when every point that failed has no equilibrium.
fn failure(error: String, points: &[FailedPoint]) -> Failure {
    let physical = |point: &FailedPoint| {
        let status = point.cause.status?;
        NoEquilibrium::ALL.contains(&status).then_some(status)
    };
    let statuses: Option<Vec<NoEquilibrium>> = points.iter().map(physical).collect();
    match statuses.as_deref().and_then(<[NoEquilibrium]>::first) {
        Some(status) => Failure::Physics {
            status: status.as_str().to_owned(),
            detail: error,
            known: json!({"failed_points": points}),
        },
        None => Failure::Other(error),
    }
}
