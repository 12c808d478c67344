//! Events of studies, in order, for replay.

use serde_json::Value;
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::row::from_row;
use crate::seals;
use crate::store_error::StoreError;

/// An event of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct EventRow {
    /// Grows with time, over all studies.
    pub id: i64,
    /// Kind of event: `queued`, `started`, `point-solved`, `point-failed`, `estimate-revised`, `analysing`, `done`, `failed`, `cancelled`.
    pub kind: String,
    /// Particulars, a JSON object.
    pub payload: String,
    /// Time of the event.
    pub created: String,
}

from_row!(EventRow {
    id,
    kind,
    payload,
    created
});

impl EventRow {
    /// Whether nothing comes after it.
    pub fn ends_the_study(&self) -> bool {
        matches!(self.kind.as_str(), "done" | "failed" | "cancelled")
    }
}

/// Stores an event and returns its number.
///
/// # Errors
/// When the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    kind: &str,
    payload: &Value,
) -> Result<i64, StoreError> {
    let query = "insert into events (study, previous, kind, payload, created)
         values (?1, (select max(id) from events where study = ?1), ?2, ?3, ?4) returning id";
    Ok(sqlx::query_scalar(query)
        .bind(study)
        .bind(kind)
        .bind(payload.to_string())
        .bind(now())
        .fetch_one(connection)
        .await?)
}

/// Number of the newest event; 0 before there is one.
///
/// # Errors
/// When the database can't be read.
pub async fn latest(connection: &mut SqliteConnection) -> Result<i64, StoreError> {
    let query = "select coalesce(max(id), 0) from events";
    Ok(sqlx::query_scalar(query).fetch_one(connection).await?)
}

/// Lists up to `limit` events of a study after the event `after`, in order.
///
/// # Errors
/// [`StoreError::Damaged`] when one was changed; when the database can't be read.
pub async fn after(
    connection: &mut SqliteConnection,
    study: &str,
    after: i64,
    limit: u32,
) -> Result<Vec<EventRow>, StoreError> {
    let query = "select id, kind, payload, created from events where study = ? and id > ? order by id limit ?";
    let rows: Vec<EventRow> = sqlx::query_as(query)
        .bind(study)
        .bind(after)
        .bind(limit)
        .fetch_all(&mut *connection)
        .await?;
    if let Some(last) = rows.last() {
        let these = format!("study = ? and id > {after} and id <= {}", last.id);
        seals::intact(connection, "events", &these, study).await?;
    }
    Ok(rows)
}
