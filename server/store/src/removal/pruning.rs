//! Removing what is old, and what an interrupted removal left, while nobody else uses the database.

use std::path::Path;

use serde::Serialize;
use sqlx::{Connection, SqliteConnection};

use super::retention::{self, Retention};
use super::{BATCH, remove_points, remove_study, remove_sweep, stray_points};
use crate::file::upkeep::alone;
use crate::store_error::StoreError;

/// Rows that a pruning removed, or would.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Pruned {
    /// Sweeps.
    pub sweeps: usize,
    /// Studies, the designs of those sweeps included.
    pub studies: usize,
    /// Solved points that no other study has.
    pub points: u64,
    /// Measured trades of documents that no study has.
    pub trades: u64,
}

/// Mode of a pruning: what it does with what it finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Removes it.
    Remove,
    /// Counts it: all that is done is taken back.
    Count,
}

/// Removes what a retention lets go. Wherever it is interrupted, what it hasn't removed is whole, and the next one goes on.
///
/// # Errors
/// [`StoreError::InUse`] when somebody uses the database; when it can't be written.
pub async fn prune(path: &Path, retention: &Retention, mode: Mode) -> Result<Pruned, StoreError> {
    let (_lock, mut connection) = alone(path).await?;
    let pruned = match mode {
        Mode::Remove => removed(&mut connection, retention).await,
        Mode::Count => counted(&mut connection, retention).await,
    };
    connection.close().await?;
    pruned
}

/// Counts in one transaction that isn't kept.
async fn counted(
    connection: &mut SqliteConnection,
    retention: &Retention,
) -> Result<Pruned, StoreError> {
    let mut transaction = connection.begin().await?;
    let pruned = removed(&mut transaction, retention).await;
    transaction.rollback().await?;
    pruned
}

async fn removed(
    connection: &mut SqliteConnection,
    retention: &Retention,
) -> Result<Pruned, StoreError> {
    let mut pruned = Pruned::default();
    for sweep in retention::old_sweeps(connection, retention).await? {
        let mut transaction = connection.begin().await?;
        // Its designs go with it, or they would be left as studies of no sweep.
        for study in remove_sweep(&mut transaction, &sweep).await? {
            remove_study(&mut transaction, &study).await?;
            pruned.studies += 1;
        }
        transaction.commit().await?;
        pruned.sweeps += 1;
    }
    for study in retention::old_studies(connection, retention).await? {
        let mut transaction = connection.begin().await?;
        remove_study(&mut transaction, &study).await?;
        transaction.commit().await?;
        pruned.studies += 1;
    }
    pruned.points = remove_strays(connection).await?;
    pruned.trades = retention::remove_old_trades(connection, retention).await?;
    Ok(pruned)
}

async fn remove_strays(connection: &mut SqliteConnection) -> Result<u64, StoreError> {
    let (mut removed, mut after) = (0, String::new());
    loop {
        let strays = stray_points(connection, &after).await?;
        let mut transaction = connection.begin().await?;
        removed += remove_points(&mut transaction, &strays).await?;
        transaction.commit().await?;
        match strays.into_iter().nth(BATCH - 1) {
            Some(last) => after = last,
            None => return Ok(removed),
        }
    }
}
