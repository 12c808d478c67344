//! Taking studies and sweeps out of the service: cancelled first, then removed with what is theirs alone.

use std::sync::Arc;
use std::time::Duration;

use sqlx::{Sqlite, Transaction};
use tokio::time::timeout;

use crate::queue::Queue;
use store::queue::design_rows;
use store::removal::{self, BATCH};
use store::{Store, StoreError};

/// A study that was cancelled lets go within a Newton iteration, or at the next output of the analysis.
const PATIENCE: Duration = Duration::from_secs(10);

/// Reason why a study was not removed.
#[derive(Debug, thiserror::Error)]
pub enum RemovalError {
    /// A design of a sweep.
    #[error(
        "the study is a design of the sweep {sweep}: remove that, DELETE /v1/sweeps/{sweep}?purge"
    )]
    Design {
        /// Identifier of the sweep.
        sweep: String,
    },
    /// A study whose solve hasn't ended yet.
    #[error("the study is cancelled, but its last solve has not ended yet: ask again")]
    Busy,
    /// The database failed.
    #[error(transparent)]
    Store(#[from] StoreError),
}

impl Queue {
    /// Removes a study, running or not, with its result and the points that no other study has.
    ///
    /// # Errors
    /// See [`RemovalError`].
    pub async fn remove(&self, id: &str) -> Result<(), RemovalError> {
        refuse_design(self.store(), id).await?;
        self.end(id).await?;
        let mut transaction = self.store().begin().await?;
        let points = removal::remove_study(&mut transaction, id).await?;
        self.clear(transaction, points).await
    }

    /// Removes a sweep with the studies of its designs, unless another sweep has them too.
    ///
    /// # Errors
    /// See [`RemovalError`]. What was removed until then stays removed.
    pub async fn remove_sweep(&self, id: &str) -> Result<(), RemovalError> {
        self.cancel_sweep(id).await?;
        let mut transaction = self.store().begin().await?;
        let studies = removal::remove_sweep(&mut transaction, id).await?;
        self.store().commit(transaction, 0).await?;
        for study in studies {
            self.remove(&study).await?;
        }
        Ok(())
    }

    /// Ends a study's work.
    async fn end(&self, id: &str) -> Result<(), RemovalError> {
        self.cancel(id).await?;
        let let_go = timeout(PATIENCE, self.let_go(id)).await;
        let_go.map_err(|_| RemovalError::Busy)
    }

    /// Commits, then removes those of these points that nobody else has. That goes on when nobody waits for it any more.
    async fn clear(
        &self,
        transaction: Transaction<'static, Sqlite>,
        points: Vec<String>,
    ) -> Result<(), RemovalError> {
        self.store().commit(transaction, 0).await?;
        let cleared = tokio::spawn(remove_points(self.store().clone(), points)).await;
        match cleared {
            Ok(cleared) => cleared?,
            Err(error) => tracing::error!(%error, "points of a removed study were left"),
        }
        Ok(())
    }
}

async fn refuse_design(store: &Store, id: &str) -> Result<(), RemovalError> {
    let mut connection = store.read().await?;
    match design_rows::of_study(&mut connection, id).await? {
        Some(sweep) => Err(RemovalError::Design { sweep }),
        None => Ok(()),
    }
}

async fn remove_points(store: Arc<Store>, points: Vec<String>) -> Result<(), StoreError> {
    for batch in points.chunks(BATCH) {
        let mut transaction = store.begin().await?;
        removal::remove_points(&mut transaction, batch).await?;
        store.commit(transaction, 0).await?;
    }
    Ok(())
}
