//! Zeros that estimators were given after they were learnt.

use sqlx::SqliteConnection;

use crate::content::{document_sha256, intact};
use crate::seals;
use crate::store_error::StoreError;

/// Document of an estimator that was given no zero: it has a row all the same, so that one that was removed is missed.
const NONE: &str = "null";

/// The zero of an estimator, JSON, where it was given one.
///
/// # Errors
/// [`StoreError::Damaged`] when it doesn't match its hash, or is missed beside a model; when the database can't be read.
pub async fn zero(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Option<String>, StoreError> {
    seals::intact(connection, "estimator_zeros", "estimator = ?", id).await?;
    // One statement, so that what is learnt meanwhile is seen with its zero or not at all.
    let query = "select count(distinct parts.estimator), zeros.document, zeros.sha256 from (select ? as id) left join estimator_parts parts on parts.estimator = id left join estimator_zeros zeros on zeros.estimator = id";
    let (learnt, document, sha256): (i64, Option<String>, Option<String>) =
        sqlx::query_as(query).bind(id).fetch_one(connection).await?;
    match (document.zip(sha256), learnt) {
        (Some((document, sha256)), _) => {
            intact(("estimator_zeros", id), &document, &sha256)?;
            Ok(Some(document).filter(|document| document != NONE))
        }
        (None, 0) => Ok(None),
        (None, _) => Err(StoreError::Damaged {
            table: "estimator_zeros",
            row: id.to_owned(),
        }),
    }
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
    let query = "insert into estimator_zeros (estimator, document, sha256) values (?, ?, ?) on conflict (estimator) do update set document = excluded.document, sha256 = excluded.sha256, seal = null";
    sqlx::query(query)
        .bind(id)
        .bind(document)
        .bind(document_sha256(document))
        .execute(connection)
        .await?;
    Ok(())
}

/// Gives an estimator no zero, in place of an earlier one.
///
/// # Errors
/// When the database can't be written.
pub async fn forget(connection: &mut SqliteConnection, id: &str) -> Result<(), StoreError> {
    set(connection, id, NONE).await
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn estimators_of_earlier_versions_have_no_zero_by_its_hash() {
        let change = include_str!("../../../../migrations/0005_estimator_zeros.sql");
        assert!(change.contains(&format!("'{NONE}', '{}'", document_sha256(NONE))));
    }
}
