//! The database as the place where solved points are kept.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use fem_client::solver::{Cost, StartState};
use placement::points::archive::{Archive, ArchiveError, Crashes, Outcome, PointRecord};
use sqlx::SqliteConnection;
use tokio::runtime::Handle;
use tracing::{Instrument, Span};

use crate::metrics::{Metrics, PointOutcome};
use crate::solving::timekeeper::Timekeeper;
use store::points::crashes;
use store::points::evaluations::{self, Evaluation};
use store::points::study_points;
use store::{Store, StoreError};

/// Keeps the points of one study. Used from solving threads, which may wait; never from a task of the runtime.
pub(crate) struct StoreArchive {
    store: Arc<Store>,
    runtime: Handle,
    study: String,
    metrics: Arc<Metrics>,
    timekeeper: Arc<Timekeeper>,
    span: Span,
    unwritable: Mutex<Option<StoreError>>,
}

impl StoreArchive {
    /// The archive of this study, whose span is the current one.
    pub fn new(
        store: Arc<Store>,
        runtime: Handle,
        study: &str,
        metrics: Arc<Metrics>,
        timekeeper: Arc<Timekeeper>,
    ) -> Self {
        Self {
            store,
            runtime,
            study: study.to_owned(),
            metrics,
            timekeeper,
            span: Span::current(),
            unwritable: Mutex::new(None),
        }
    }

    /// Writes in one transaction.
    fn write(
        &self,
        change: impl AsyncFnOnce(&mut SqliteConnection) -> Result<(), StoreError>,
    ) -> Result<(), ArchiveError> {
        self.wait(async {
            let mut transaction = self.store.begin().await?;
            change(&mut transaction).await?;
            self.store.commit(transaction, 0).await
        })
    }

    /// Waits for the database, on whichever thread: what is logged of it belongs to the study. Remembers what no study is to blame for.
    fn wait<T>(
        &self,
        work: impl Future<Output = Result<T, StoreError>>,
    ) -> Result<T, ArchiveError> {
        let done = self.runtime.block_on(work.instrument(self.span.clone()));
        done.map_err(|error| {
            let detail = error.to_string();
            if matches!(error, StoreError::Full | StoreError::Gone { .. }) {
                let mut unwritable = self
                    .unwritable
                    .lock()
                    .unwrap_or_else(PoisonError::into_inner);
                unwritable.get_or_insert(error);
            }
            ArchiveError { detail }
        })
    }

    /// Returns why nothing could be stored, where it was a full disk or a database that is gone.
    pub fn unwritable(&self) -> Option<StoreError> {
        let mut unwritable = self
            .unwritable
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        unwritable.take()
    }
}

impl Archive for StoreArchive {
    /// Whichever study solved them; this one is noted to use them too.
    fn load(
        &self,
        keys: &[String],
        first: usize,
    ) -> Result<Vec<Option<(Outcome, Cost)>>, ArchiveError> {
        let mut reused = 0;
        self.write(async |connection| {
            reused = study_points::link(connection, &self.study, first, keys).await?;
            Ok(())
        })?;
        self.metrics.points(PointOutcome::Reused, reused);
        let found = self.wait(async {
            let mut connection = self.store.read().await?;
            evaluations::find(&mut connection, keys).await
        })?;
        let answer = |evaluation: Evaluation| (evaluation.outcome, evaluation.cost);
        Ok(found.into_iter().map(|found| found.map(answer)).collect())
    }

    fn begin(&self, key: &str) -> Result<(), ArchiveError> {
        self.write(async |connection| crashes::begin(connection, key).await)
    }

    fn give_up(&self, key: &str) -> Result<(), ArchiveError> {
        self.write(async |connection| crashes::end(connection, key).await)
    }

    fn crashed(&self, key: &str, cause: &str) -> Result<usize, ArchiveError> {
        let mut own = 0;
        self.write(async |connection| {
            own = crashes::count(connection, key, cause).await?;
            Ok(())
        })?;
        Ok(own)
    }

    fn crashes(&self) -> Result<HashMap<String, Crashes>, ArchiveError> {
        self.wait(async {
            let mut connection = self.store.read().await?;
            crashes::all(&mut connection).await
        })
    }

    /// Saves evaluation, start state and place in the study in one transaction: a kill leaves all or nothing.
    fn save(&self, point: &PointRecord<'_>) -> Result<(), ArchiveError> {
        self.write(async |connection| {
            evaluations::insert(connection, &self.study, point).await?;
            crashes::end(connection, point.key).await
        })?;
        self.metrics.solve(point.cost.wall_s);
        self.timekeeper.solved(point.key, point.cost.wall_s);
        Ok(())
    }

    fn load_start(&self, key: &str) -> Result<Option<StartState>, ArchiveError> {
        self.wait(async {
            let mut connection = self.store.read().await?;
            evaluations::find_start(&mut connection, key).await
        })
    }
}
