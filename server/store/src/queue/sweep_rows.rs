//! Sweeps, of which each design is a study.

use sqlx::SqliteConnection;

use crate::clock::now;
use crate::content::{document_sha256, intact};
use crate::queue::listed::{Listed, RowChange};
use crate::row::from_row;
use crate::seals;
use crate::store_error::StoreError;

/// A sweep as stored.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRow {
    /// UUID, ordered by time.
    pub id: String,
    /// Free text.
    pub name: String,
    spec: String,
    spec_sha256: String,
    /// Priority of its studies.
    pub priority: i64,
    /// Time at which it was submitted.
    pub created: String,
    /// Time at which it was archived, so that lists leave it out.
    pub archived: Option<String>,
}

from_row!(SweepRow {
    id,
    name,
    spec,
    spec_sha256,
    priority,
    created,
    archived
});

impl SweepRow {
    /// The canonical document of the study without changes, JSON.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when it doesn't match its hash.
    pub fn document(&self) -> Result<&str, StoreError> {
        intact(("sweeps", &self.id), &self.spec, &self.spec_sha256)
    }
}

/// Stores a new sweep without designs and returns its identifier.
///
/// # Errors
/// When the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    name: &str,
    document: &str,
    priority: i64,
) -> Result<String, StoreError> {
    let id = uuid::Uuid::now_v7().to_string();
    sqlx::query("insert into sweeps (id, name, spec, spec_sha256, priority, created) values (?, ?, ?, ?, ?, ?)")
        .bind(&id)
        .bind(name)
        .bind(document)
        .bind(document_sha256(document))
        .bind(priority)
        .bind(now())
        .execute(connection)
        .await?;
    Ok(id)
}

/// The sweep of this identifier.
///
/// # Errors
/// When the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Option<SweepRow>, StoreError> {
    seals::intact(connection, "sweeps", "id = ?", id).await?;
    let query = "select * from sweeps where id = ?";
    Ok(sqlx::query_as(query)
        .bind(id)
        .fetch_optional(connection)
        .await?)
}

/// Lists up to `limit` of the sweeps that are looked for, newest first, older than the sweep `before`.
///
/// # Errors
/// When the database can't be read.
pub async fn page(
    connection: &mut SqliteConnection,
    listed: Listed<'_>,
    before: Option<&str>,
    limit: u32,
) -> Result<Vec<SweepRow>, StoreError> {
    let query = "select * from sweeps
                 where (?1 is null or id < ?1)
                 and (?3 is null or instr(lower(name), lower(?3)) > 0 or substr(id, 1, length(?3)) = lower(?3))
                 and (?4 is null or (archived is not null) = ?4)
                 order by id desc limit ?2";
    Ok(sqlx::query_as(query)
        .bind(before)
        .bind(limit)
        .bind(listed.search)
        .bind(listed.archived.wanted())
        .fetch_all(connection)
        .await?)
}

/// Changes what lists say of a sweep. What is archived already keeps its time.
///
/// # Errors
/// When the database can't be written.
pub async fn change(
    connection: &mut SqliteConnection,
    id: &str,
    change: &RowChange,
) -> Result<(), StoreError> {
    let query = "update sweeps set state_seal = null, name = coalesce(?2, name),
                 archived = case ?3 when true then coalesce(archived, ?4) when false then null else archived end where id = ?1";
    sqlx::query(query)
        .bind(id)
        .bind(&change.name)
        .bind(change.archived)
        .bind(now())
        .execute(connection)
        .await?;
    Ok(())
}

/// The sweep submitted under this key, and the hash of what was submitted.
///
/// # Errors
/// When the database can't be read.
pub async fn under_key(
    connection: &mut SqliteConnection,
    key: &str,
) -> Result<Option<(String, String)>, StoreError> {
    seals::intact(connection, "sweep_keys", "key = ?", key).await?;
    Ok(
        sqlx::query_as("select sweep, sha256 from sweep_keys where key = ?")
            .bind(key)
            .fetch_optional(connection)
            .await?,
    )
}

/// Notes that this key stands for this sweep.
///
/// # Errors
/// When the key is taken, or the database can't be written.
pub async fn insert_key(
    connection: &mut SqliteConnection,
    key: &str,
    sweep: &str,
    sha256: &str,
) -> Result<(), StoreError> {
    sqlx::query("insert into sweep_keys (key, sweep, sha256, created) values (?, ?, ?, ?)")
        .bind(key)
        .bind(sweep)
        .bind(sha256)
        .bind(now())
        .execute(connection)
        .await?;
    Ok(())
}
