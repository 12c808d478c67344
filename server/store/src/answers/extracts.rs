//! Parts of results that comparisons read, so that thousands needn't be read whole.

use placement::compare::Comparable;
use results::StudyResult;
use sqlx::SqliteConnection;

use crate::content::{encode, sha256};
use crate::store_error::StoreError;

const EXTRACT: &str = "what a comparison reads of a result";
/// Format of the extracts that this version writes; those of others aren't read. To be raised with every change of `Comparable`.
const FORMAT: i64 = 1;

/// Stores what comparisons read of a study's result.
///
/// # Errors
/// [`StoreError::NotFinite`] when a number isn't finite; when the database can't be written.
pub(super) async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    result: &StudyResult,
) -> Result<(), StoreError> {
    let document = encode(EXTRACT, &Comparable::of(result))?;
    sqlx::query(
        "insert into result_extracts (study, format, document, sha256) values (?, ?, ?, ?)",
    )
    .bind(study)
    .bind(FORMAT)
    .bind(&document)
    .bind(hash(study, &document))
    .execute(connection)
    .await?;
    Ok(())
}

/// The stored part of a study's result that a comparison reads; none of a result of an earlier version.
///
/// # Errors
/// [`StoreError::Damaged`] when it doesn't match its hash; when the database can't be read.
pub(super) async fn find(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<Comparable>, StoreError> {
    let document = document(connection, study).await?;
    let read = document.map(|document| serde_json::from_str(&document));
    read.transpose().map_err(|_| damaged(study))
}

/// Checks that what comparisons read of a study's result, if it is stored, is the result's.
///
/// # Errors
/// [`StoreError::Damaged`] when it isn't; when the database can't be read.
pub(super) async fn check(
    connection: &mut SqliteConnection,
    study: &str,
    result: &StudyResult,
) -> Result<(), StoreError> {
    match document(connection, study).await? {
        Some(document) if document != encode(EXTRACT, &Comparable::of(result))? => {
            Err(damaged(study))
        }
        _ => Ok(()),
    }
}

async fn document(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<String>, StoreError> {
    let query = "select document, sha256 from result_extracts where study = ? and format = ?";
    let row: Option<(String, String)> = sqlx::query_as(query)
        .bind(study)
        .bind(FORMAT)
        .fetch_optional(connection)
        .await?;
    match row {
        Some((document, stored)) if hash(study, &document) != stored => Err(damaged(study)),
        row => Ok(row.map(|(document, _)| document)),
    }
}

fn hash(study: &str, document: &str) -> String {
    sha256(&[study.as_bytes(), &FORMAT.to_le_bytes(), document.as_bytes()])
}

fn damaged(study: &str) -> StoreError {
    StoreError::Damaged {
        table: "result_extracts",
        row: study.to_owned(),
    }
}
