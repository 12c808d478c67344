//! Keys under which clients submitted studies. They live as long as the study.

use sqlx::SqliteConnection;

use crate::clock::now;
use crate::seals;
use crate::store_error::StoreError;

/// The study submitted under this key, and the hash of its document.
///
/// # Errors
/// When the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    key: &str,
) -> Result<Option<(String, String)>, StoreError> {
    seals::intact(connection, "idempotency_keys", "key = ?", key).await?;
    Ok(
        sqlx::query_as("select study, spec_sha256 from idempotency_keys where key = ?")
            .bind(key)
            .fetch_optional(connection)
            .await?,
    )
}

/// Notes that this key stands for this study.
///
/// # Errors
/// When the key is taken, or the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    key: &str,
    study: &str,
    spec_sha256: &str,
) -> Result<(), StoreError> {
    sqlx::query(
        "insert into idempotency_keys (key, study, spec_sha256, created) values (?, ?, ?, ?)",
    )
    .bind(key)
    .bind(study)
    .bind(spec_sha256)
    .bind(now())
    .execute(connection)
    .await?;
    Ok(())
}
