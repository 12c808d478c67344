//! Taking studies and sweeps out of the database, with all that is theirs alone.
//!
//! A study goes in one transaction. The points that no other study shares follow in batches, so that nobody waits long for the one
//! connection that writes; what an interruption leaves of them goes with the next [`pruning`].
//!
//! - [`retention`]: what is old enough to go
//! - [`pruning`]: all of that, while nobody else uses the database

pub mod pruning;
pub mod retention;

use serde_json::json;
use sqlx::SqliteConnection;

use crate::column::whole;
use crate::store_error::StoreError;

/// Points that one transaction may remove: with their strain fields some tenths of a second.
pub const BATCH: usize = 64;

/// Rows that belong to one study, those that refer to others first.
const OF_STUDY: [&str; 7] = [
    "delete from result_maps where study = ?",
    "delete from result_extracts where study = ?",
    "delete from results where study = ?",
    "delete from study_points where study = ?",
    "delete from events where study = ?",
    "delete from idempotency_keys where study = ?",
    "delete from studies where id = ?",
];

/// Rows that belong to one sweep, but for the studies of its designs.
const OF_SWEEP: [&str; 4] = [
    "delete from sweep_engines where sweep = ?",
    "delete from sweep_designs where sweep = ?",
    "delete from sweep_keys where sweep = ?",
    "delete from sweeps where id = ?",
];

/// Rows that belong to a point, its own last; only where no study refers to it.
const OF_POINT: [&str; 3] = [
    "delete from strain_fields where key in (select value from json_each(?))
     and not exists (select 1 from study_points where evaluation = strain_fields.key)",
    "delete from start_states where key in (select value from json_each(?))
     and not exists (select 1 from study_points where evaluation = start_states.key)",
    "delete from evaluations where key in (select value from json_each(?))
     and not exists (select 1 from study_points where evaluation = evaluations.key)",
];

/// Removes a study, and returns the keys of the points that it had. A study that runs must have been cancelled and let go before.
///
/// # Errors
/// When a sweep has it as a design, or the database can't be written.
pub async fn remove_study(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Vec<String>, StoreError> {
    let query = "select distinct evaluation from study_points where study = ?";
    let points = sqlx::query_scalar(query).bind(id);
    let points = points.fetch_all(&mut *connection).await?;
    remove_all(connection, &OF_STUDY, id).await?;
    Ok(points)
}

/// Removes a sweep, and returns the studies that were its designs and no other sweep's.
///
/// # Errors
/// When the database can't be written.
pub async fn remove_sweep(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Vec<String>, StoreError> {
    let query = "select distinct study from sweep_designs as own where sweep = ?1
                 and not exists (select 1 from sweep_designs where study = own.study and sweep <> ?1)";
    let studies = sqlx::query_scalar(query).bind(id);
    let studies = studies.fetch_all(&mut *connection).await?;
    remove_all(connection, &OF_SWEEP, id).await?;
    Ok(studies)
}

async fn remove_all(
    connection: &mut SqliteConnection,
    changes: &[&'static str],
    of: &str,
) -> Result<(), StoreError> {
    for change in changes {
        let change = sqlx::query(*change).bind(of);
        change.execute(&mut *connection).await?;
    }
    Ok(())
}

/// Removes those of these points that no study refers to, and returns how many there were.
///
/// # Errors
/// When the database can't be written.
pub async fn remove_points(
    connection: &mut SqliteConnection,
    keys: &[String],
) -> Result<u64, StoreError> {
    let keys = json!(keys).to_string();
    let mut removed = 0;
    for change in OF_POINT {
        let done = sqlx::query(change).bind(&keys);
        removed = done.execute(&mut *connection).await?.rows_affected();
    }
    Ok(removed)
}

/// Lists up to [`BATCH`] points that no study refers to, of those whose keys come after this one, in order.
///
/// # Errors
/// When the database can't be read.
async fn stray_points(
    connection: &mut SqliteConnection,
    after: &str,
) -> Result<Vec<String>, StoreError> {
    let query = "select key from evaluations where key > ?
                 and not exists (select 1 from study_points where evaluation = evaluations.key) order by key limit ?";
    let keys = sqlx::query_scalar(query).bind(after).bind(whole(BATCH));
    Ok(keys.fetch_all(connection).await?)
}

#[cfg(test)]
mod tests;
