//! Turns of the studies.
//!
//! The waiting studies stand in a line, those that other machines are to solve apart. The foremost of those with the highest priority is claimed; when its turn is over and
//! it hasn't ended, it goes to the end of the line. So every study has its turn before any of its priority has a second one.

use sqlx::SqliteConnection;

use crate::clock::now;
use crate::queue::study_rows::StudyRow;
use crate::store_error::StoreError;

/// Condition of a study that waits for its turn, and that no other machine is to solve.
macro_rules! waits_here {
    () => {
        "state = 'queued' and not exists (select 1 from sweep_designs join sweep_engines on sweep_engines.sweep = sweep_designs.sweep
         where sweep_designs.study = studies.id and sweep_engines.ended is null)"
    };
}

/// The identifier of the study whose turn is next.
///
/// # Errors
/// When the database can't be read.
pub async fn next(connection: &mut SqliteConnection) -> Result<Option<String>, StoreError> {
    let query = concat!(
        "select id from studies where ",
        waits_here!(),
        " order by priority desc, place limit 1"
    );
    Ok(sqlx::query_scalar(query).fetch_optional(connection).await?)
}

/// Counts the studies that wait.
///
/// # Errors
/// When the database can't be read.
pub async fn waiting(connection: &mut SqliteConnection) -> Result<u32, StoreError> {
    let query = "select count(*) from studies where state = 'queued'";
    Ok(sqlx::query_scalar(query).fetch_one(connection).await?)
}

/// Whether a study of this priority or a higher one waits.
///
/// # Errors
/// When the database can't be read.
pub async fn is_awaited(
    connection: &mut SqliteConnection,
    priority: i64,
) -> Result<bool, StoreError> {
    let query = concat!(
        "select exists (select 1 from studies where ",
        waits_here!(),
        " and priority >= ?)"
    );
    Ok(sqlx::query_scalar(query)
        .bind(priority)
        .fetch_one(connection)
        .await?)
}

/// Takes a queued study to run it; `None` when it isn't queued any more.
///
/// # Errors
/// When the database can't be written.
pub async fn claim(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Option<StudyRow>, StoreError> {
    let query =
        "update studies set state_seal = null, state = 'running', started = coalesce(started, ?)
                 where id = ? and state = 'queued' returning *, null as brief";
    Ok(sqlx::query_as(query)
        .bind(now())
        .bind(id)
        .fetch_optional(connection)
        .await?)
}

/// Puts a running study back to where it stood in the line; false when it isn't running any more.
///
/// # Errors
/// When the database can't be written.
pub async fn release(connection: &mut SqliteConnection, id: &str) -> Result<bool, StoreError> {
    let query =
        "update studies set state_seal = null, state = 'queued' where id = ? and state = 'running'";
    let done = sqlx::query(query).bind(id).execute(connection).await?;
    Ok(done.rows_affected() == 1)
}

/// Puts a running study at the end of the line; false when it isn't running any more.
///
/// # Errors
/// When the database can't be written.
pub async fn pass_on(connection: &mut SqliteConnection, id: &str) -> Result<bool, StoreError> {
    let query = "update studies set state_seal = null, state = 'queued', place = (select max(place) + 1 from studies)
                 where id = ? and state = 'running'";
    let done = sqlx::query(query).bind(id).execute(connection).await?;
    Ok(done.rows_affected() == 1)
}

/// Gives a study a priority.
///
/// # Errors
/// When the database can't be written, or the priority isn't between -100 and 100.
pub async fn set_priority(
    connection: &mut SqliteConnection,
    id: &str,
    priority: i64,
) -> Result<(), StoreError> {
    sqlx::query("update studies set state_seal = null, priority = ? where id = ?")
        .bind(priority)
        .bind(id)
        .execute(connection)
        .await?;
    Ok(())
}

/// The studies that a crash left running.
///
/// # Errors
/// When the database can't be read.
pub async fn running(connection: &mut SqliteConnection) -> Result<Vec<String>, StoreError> {
    Ok(
        sqlx::query_scalar("select id from studies where state = 'running' order by place")
            .fetch_all(connection)
            .await?,
    )
}

#[cfg(test)]
mod tests;
