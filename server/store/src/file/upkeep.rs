//! Looking after the database file: whether it is whole, its free pages given back.
//!
//! A check reads a snapshot and may run beside the service.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;
use sqlx::{Connection, SqliteConnection};

use crate::file::condition;
use crate::file::keyed_rows::KeyedRows;
use crate::file::lock::DatabaseLock;
use crate::file::opening::{self, Missing};
use crate::points::crashes;
use crate::points::study_points;
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

/// Reads everything: SQLite's own structures, every reference, every hash, and that each study has the points it counts. Rows are read on all cores. Tells `seen` how
/// many it has read, and of how many.
///
/// # Errors
/// When the database can't be read at all.
pub async fn inspect(path: &Path, seen: &dyn Fn(usize, usize)) -> Result<Inspection, StoreError> {
    let mut connection = opening::to_read(path).await?;
    let found = inspected(path, &mut connection, seen).await;
    connection.close().await?;
    found
}

async fn inspected(
    path: &Path,
    connection: &mut SqliteConnection,
    seen: &dyn Fn(usize, usize),
) -> Result<Inspection, StoreError> {
    let keyed = KeyedRows::list(connection).await?;
    let mut found = Inspection {
        rows: keyed.counts(),
        faults: structure(connection).await?,
    };
    found.faults.extend(keyed.faults(path, seen).await?);
    found.faults.extend(seals::broken(connection).await?);
    found.faults.extend(short(connection).await?);
    found.faults.extend(gaps(connection).await?);
    Ok(found)
}

/// Faults of SQLite's own structures, and rows that refer to none.
async fn structure(connection: &mut SqliteConnection) -> Result<Vec<String>, StoreError> {
    let verdicts: Vec<String> = sqlx::query_scalar("pragma integrity_check(20)")
        .fetch_all(&mut *connection)
        .await?;
    let mut faults = verdicts;
    faults.retain(|verdict| verdict != "ok");
    faults.extend(dangling(connection).await?);
    Ok(faults)
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
