//! Results with their ranked rows.

use placement::result::{StudyCost, StudyResult};
use serde::de::DeserializeOwned;
use sqlx::sqlite::SqliteRow;
use sqlx::{Row, SqliteConnection};

use crate::answers::ranked_rows::{self, Ranked};
use crate::answers::stored_signals;
use crate::clock::now;
use crate::content::{encode, sha256};
use crate::store_error::StoreError;

const RESULT: &str = "the result of a study";

/// Stores the result of a study with its ranked rows.
///
/// # Errors
/// [`StoreError::NotFinite`] when a number isn't finite; when the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    result: &StudyResult,
) -> Result<(), StoreError> {
    let document = encode(RESULT, result)?;
    let inserted = sqlx::query(
        "insert into results (study, document, document_sha256, content_sha256, created) values (?, ?, ?, ?, ?)
         on conflict do nothing",
    )
    .bind(study)
    .bind(&document)
    .bind(sha256(&[study.as_bytes(), document.as_bytes()]))
    .bind(content_sha256(result)?)
    .bind(now())
    .execute(&mut *connection)
    .await?;
    if inserted.rows_affected() == 0 {
        return Ok(());
    }
    ranked_rows::insert(connection, study, &result.locations, &result.layouts).await?;
    match &result.signals {
        Some(signals) => stored_signals::insert(connection, study, signals).await,
        None => Ok(()),
    }
}

/// SHA-256 of what a result says: without what it cost, what it was expected to cost, what a surer answer costs, and without the identifier of its study, so that equal
/// documents give equal hashes in any database, on any number of threads, with any history of interruptions.
fn content_sha256(result: &StudyResult) -> Result<String, StoreError> {
    let mut content = result.clone();
    content.cost = StudyCost::default();
    content.estimate = None;
    if let Some(answer) = &mut content.answer {
        answer.surer = None;
    }
    content.study.id.clear();
    let text =
        serde_json::to_string(&content).map_err(|_| StoreError::NotFinite { what: RESULT })?;
    Ok(sha256(&[text.as_bytes()]))
}

/// Writes the ranked rows of results that have none, which earlier versions stored otherwise. A damaged result stays without.
///
/// # Errors
/// When the database can't be written.
pub(crate) async fn complete_rankings(connection: &mut SqliteConnection) -> Result<(), StoreError> {
    let query = "select study from results where study not in (select study from rankings)";
    let lacking: Vec<String> = sqlx::query_scalar(query)
        .fetch_all(&mut *connection)
        .await?;
    for study in lacking {
        match find::<Ranked>(connection, &study).await {
            Ok(Some((ranked, _))) => {
                ranked_rows::insert(connection, &study, &ranked.locations, &ranked.layouts).await?;
            }
            Ok(None) | Err(StoreError::Damaged { .. }) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(())
}

/// The row of a result, as SQLite gave it: its text is read where it lies.
pub struct ResultRow {
    study: String,
    row: SqliteRow,
}

/// The row of a study's result, when there is one.
///
/// # Errors
/// When the database can't be read.
pub async fn row(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<ResultRow>, StoreError> {
    let query = "select document, document_sha256, content_sha256 from results where study = ?";
    let row = sqlx::query(query)
        .bind(study)
        .fetch_optional(connection)
        .await?;
    Ok(row.map(|row| ResultRow {
        study: study.to_owned(),
        row,
    }))
}

impl ResultRow {
    /// The result, or the part `R` of it, and the hash of its content.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when the row doesn't match its hash.
    pub fn read<R: DeserializeOwned>(self) -> Result<(R, String), StoreError> {
        let [document, stored, content] = [
            self.row.try_get::<&str, _>(0)?,
            self.row.try_get(1)?,
            self.row.try_get(2)?,
        ];
        if sha256(&[self.study.as_bytes(), document.as_bytes()]) != stored {
            return Err(damaged(&self.study));
        }
        let result = serde_json::from_str(document).map_err(|_| damaged(&self.study))?;
        Ok((result, content.to_owned()))
    }
}

/// The result of a study, or the part `R` of it, and the hash of its content.
///
/// # Errors
/// [`StoreError::Damaged`] when the row doesn't match its hash; when the database can't be read.
pub async fn find<R: DeserializeOwned>(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<(R, String)>, StoreError> {
    row(connection, study)
        .await?
        .map(ResultRow::read)
        .transpose()
}

pub(super) fn damaged(study: &str) -> StoreError {
    StoreError::Damaged {
        table: "results",
        row: study.to_owned(),
    }
}

/// The hash of the content of a study's result, when there is one.
///
/// # Errors
/// When the database can't be read.
pub async fn sha256_of(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<String>, StoreError> {
    Ok(
        sqlx::query_scalar("select content_sha256 from results where study = ?")
            .bind(study)
            .fetch_optional(connection)
            .await?,
    )
}
