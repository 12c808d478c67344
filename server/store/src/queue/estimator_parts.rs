//! Parts of an estimator: the recordings that it is learnt from, and what was learnt of them.

use sqlx::SqliteConnection;

use crate::column::whole;
use crate::content::{document_sha256, intact, sha256};
use crate::seals;
use crate::store_error::StoreError;

/// A recording as it was sent.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecordingRow {
    /// File of the recording, for people.
    pub file: String,
    /// CSV.
    pub text: String,
}

/// Part that a fit leaves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Report of what was found.
    Report,
    /// The model file.
    Model,
    /// Predictions of rows that weren't learnt from.
    LeftOut,
}

impl Part {
    /// Parts, all of them.
    pub const ALL: [Self; 3] = [Self::Report, Self::Model, Self::LeftOut];

    /// Returns its name in the database and in addresses.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Report => "report",
            Self::Model => "model",
            Self::LeftOut => "left-out",
        }
    }
}

/// Stores the recordings of a new estimator.
///
/// # Errors
/// When the database can't be written.
pub(crate) async fn insert_recordings<'r>(
    connection: &mut SqliteConnection,
    id: &str,
    recordings: impl Iterator<Item = (&'r str, &'r str)>,
) -> Result<(), StoreError> {
    let query = "insert into estimator_recordings (estimator, ordinal, file, text, sha256) values (?, ?, ?, ?, ?)";
    for (ordinal, (file, text)) in recordings.enumerate() {
        sqlx::query(query)
            .bind(id)
            .bind(whole(ordinal))
            .bind(file)
            .bind(text)
            .bind(recording_sha256(file, text))
            .execute(&mut *connection)
            .await?;
    }
    Ok(())
}

fn recording_sha256(file: &str, text: &str) -> String {
    sha256(&[file.as_bytes(), text.as_bytes()])
}

/// Reads its recordings, in order.
///
/// # Errors
/// [`StoreError::Damaged`] when one doesn't match its hash; when the database can't be read.
pub async fn recordings(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Vec<RecordingRow>, StoreError> {
    let query =
        "select file, text, sha256 from estimator_recordings where estimator = ? order by ordinal";
    seals::intact(connection, "estimator_recordings", "estimator = ?", id).await?;
    let rows: Vec<(String, String, String)> = sqlx::query_as(query)
        .bind(id)
        .fetch_all(&mut *connection)
        .await?;
    let counted = "select json_array_length(document, '$.recordings') from estimators where id = ?";
    let counted: Option<Option<i64>> = sqlx::query_scalar(counted)
        .bind(id)
        .fetch_optional(connection)
        .await?;
    if counted
        .flatten()
        .is_some_and(|counted| counted != whole(rows.len()))
    {
        return Err(StoreError::Damaged {
            table: "estimator_recordings",
            row: id.to_owned(),
        });
    }
    let whole = |(file, text, sha256): (String, String, String)| {
        if recording_sha256(&file, &text) == sha256 {
            return Ok(RecordingRow { file, text });
        }
        Err(StoreError::Damaged {
            table: "estimator_recordings",
            row: id.to_owned(),
        })
    };
    rows.into_iter().map(whole).collect()
}

/// Stores what was learnt.
///
/// # Errors
/// When the database can't be written.
pub(crate) async fn insert_parts(
    connection: &mut SqliteConnection,
    id: &str,
    parts: &[(Part, String)],
) -> Result<(), StoreError> {
    let query =
        "insert into estimator_parts (estimator, part, document, sha256) values (?, ?, ?, ?)";
    for (part, document) in parts {
        sqlx::query(query)
            .bind(id)
            .bind(part.as_str())
            .bind(document)
            .bind(document_sha256(document))
            .execute(&mut *connection)
            .await?;
    }
    Ok(())
}

/// Hash of a part of what was learnt, where there is one.
///
/// # Errors
/// When the database can't be read.
pub async fn part_sha256(
    connection: &mut SqliteConnection,
    id: &str,
    part: Part,
) -> Result<Option<String>, StoreError> {
    let query = "select sha256 from estimator_parts where estimator = ? and part = ?";
    Ok(sqlx::query_scalar(query)
        .bind(id)
        .bind(part.as_str())
        .fetch_optional(connection)
        .await?)
}

/// A part of what was learnt, JSON, where there is one.
///
/// # Errors
/// [`StoreError::Damaged`] when it doesn't match its hash; when the database can't be read.
pub async fn part(
    connection: &mut SqliteConnection,
    id: &str,
    part: Part,
) -> Result<Option<String>, StoreError> {
    seals::intact(connection, "estimator_parts", "estimator = ?", id).await?;
    let query = "select document, sha256 from estimator_parts where estimator = ? and part = ?";
    let row: Option<(String, String)> = sqlx::query_as(query)
        .bind(id)
        .bind(part.as_str())
        .fetch_optional(connection)
        .await?;
    let Some((document, sha256)) = row else {
        return Ok(None);
    };
    intact(("estimator_parts", id), &document, &sha256)?;
    Ok(Some(document))
}
