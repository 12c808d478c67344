//! Zeros that estimators were given after they were learnt.

use sqlx::SqliteConnection;

use crate::content::{document_sha256, intact};
use crate::seals;
use crate::store_error::StoreError;

/// The zero of an estimator, JSON, where it was given one.
///
/// # Errors
/// [`StoreError::Damaged`] when it doesn't match its hash; when the database can't be read.
pub async fn zero(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Option<String>, StoreError> {
    seals::intact(connection, "estimator_zeros", "estimator = ?", id).await?;
    let query = "select document, sha256 from estimator_zeros where estimator = ?";
    let row: Option<(String, String)> = sqlx::query_as(query)
        .bind(id)
        .fetch_optional(connection)
        .await?;
    let Some((document, sha256)) = row else {
        return Ok(None);
    };
    intact(("estimator_zeros", id), &document, &sha256)?;
    Ok(Some(document))
}

/// Gives an estimator this zero, JSON, in place of an earlier one.
///
/// # Errors
/// When the database can't be written.
pub async fn set(
    connection: &mut SqliteConnection,
    id: &str,
    document: &str,
) -> Result<(), StoreError> {
    forget(connection, id).await?;
    sqlx::query("insert into estimator_zeros (estimator, document, sha256) values (?, ?, ?)")
        .bind(id)
        .bind(document)
        .bind(document_sha256(document))
        .execute(connection)
        .await?;
    Ok(())
}

/// Forgets the zero that an estimator was given.
///
/// # Errors
/// When the database can't be written.
pub async fn forget(connection: &mut SqliteConnection, id: &str) -> Result<(), StoreError> {
    sqlx::query("delete from estimator_zeros where estimator = ?")
        .bind(id)
        .execute(connection)
        .await?;
    Ok(())
}
