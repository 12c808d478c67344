//! Retention: what is old enough to go.

use sqlx::SqliteConnection;

use crate::store_error::StoreError;

/// Retention of studies and sweeps: which are old enough to go.
#[derive(Debug, Clone)]
pub struct Retention {
    /// Time before which they ended, RFC 3339, UTC.
    pub before: String,
    /// Whether the newest result of each name stays.
    pub keeps_named: bool,
}

/// Studies that a retention lets go: ended, and designs of no sweep.
///
/// # Errors
/// When the database can't be read.
pub(crate) async fn old_studies(
    connection: &mut SqliteConnection,
    retention: &Retention,
) -> Result<Vec<String>, StoreError> {
    let query = "select id from studies as old
                 where state in ('done', 'failed', 'cancelled') and finished < ?1
                 and not exists (select 1 from sweep_designs where study = old.id)
                 and (not ?2 or state <> 'done' or exists
                     (select 1 from studies where name = old.name and state = 'done' and id > old.id))
                 order by id";
    ids(connection, query, retention).await
}

/// Sweeps that a retention lets go: all of their studies ended before its time.
///
/// # Errors
/// When the database can't be read.
pub(crate) async fn old_sweeps(
    connection: &mut SqliteConnection,
    retention: &Retention,
) -> Result<Vec<String>, StoreError> {
    let query = "select id from sweeps as old
                 where created < ?1
                 and not exists (select 1 from sweep_designs d join studies s on s.id = d.study
                                 where d.sweep = old.id and coalesce(s.finished >= ?1, true))
                 and (not ?2 or exists (select 1 from sweeps where name = old.name and id > old.id))
                 order by id";
    ids(connection, query, retention).await
}

async fn ids(
    connection: &mut SqliteConnection,
    query: &'static str,
    retention: &Retention,
) -> Result<Vec<String>, StoreError> {
    let ids = sqlx::query_scalar(query)
        .bind(&retention.before)
        .bind(retention.keeps_named);
    Ok(ids.fetch_all(connection).await?)
}

/// Removes measured trades of documents that no study has, and returns how many there were.
///
/// # Errors
/// When the database can't be written.
pub(crate) async fn remove_old_trades(
    connection: &mut SqliteConnection,
    retention: &Retention,
) -> Result<u64, StoreError> {
    let query = "delete from trades where created < ?
                 and not exists (select 1 from studies where spec_sha256 = trades.spec_sha256)";
    let removed = sqlx::query(query).bind(&retention.before);
    Ok(removed.execute(connection).await?.rows_affected())
}
