//! Measured trades of accuracy for time.

use placement::ladder::trade::Trade;
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::content::{encode, sha256};
use crate::seals;
use crate::store_error::StoreError;

/// Stores a trade; earlier ones of the same study stay.
///
/// # Errors
/// [`StoreError::NotFinite`] when a number isn't finite; when the database can't be written.
pub async fn insert(connection: &mut SqliteConnection, trade: &Trade) -> Result<(), StoreError> {
    let document = encode("a trade", trade)?;
    sqlx::query(
        "insert into trades (spec_sha256, document, document_sha256, created) values (?, ?, ?, ?)",
    )
    .bind(&trade.spec_sha256)
    .bind(&document)
    .bind(sha256(&[document.as_bytes()]))
    .bind(now())
    .execute(connection)
    .await?;
    Ok(())
}

/// The newest trade of the study with this document.
///
/// # Errors
/// [`StoreError::Damaged`] when the row doesn't match its hash; when the database can't be read.
pub async fn newest(
    connection: &mut SqliteConnection,
    spec_sha256: &str,
) -> Result<Option<Trade>, StoreError> {
    seals::intact(connection, "trades", "spec_sha256 = ?", spec_sha256).await?;
    let query = "select document, document_sha256 from trades where spec_sha256 = ? order by id desc limit 1";
    let row: Option<(String, String)> = sqlx::query_as(query)
        .bind(spec_sha256)
        .fetch_optional(connection)
        .await?;
    let Some((document, stored)) = row else {
        return Ok(None);
    };
    let damaged = || StoreError::Damaged {
        table: "trades",
        row: spec_sha256.to_owned(),
    };
    if sha256(&[document.as_bytes()]) != stored {
        return Err(damaged());
    }
    serde_json::from_str(&document)
        .map(Some)
        .map_err(|_| damaged())
}

/// Whether there is a trade of the study with this document.
///
/// # Errors
/// When the database can't be read.
pub async fn is_measured(
    connection: &mut SqliteConnection,
    spec_sha256: &str,
) -> Result<bool, StoreError> {
    let query = "select exists (select 1 from trades where spec_sha256 = ?)";
    Ok(sqlx::query_scalar(query)
        .bind(spec_sha256)
        .fetch_one(connection)
        .await?)
}

#[cfg(test)]
mod tests {
    use placement::ladder::trade::Rung;

    use super::*;
    use crate::database::tests::fresh;

    fn trade(study: &str, wall_s: f64) -> Trade {
        let rung = Rung {
            label: "draft mdrm 3".to_owned(),
            wall_s,
            error_true: Some(0.02),
            ..Rung::default()
        };
        Trade {
            study: study.to_owned(),
            spec_sha256: study.to_owned(),
            reference: rung.clone(),
            rungs: vec![rung],
        }
    }

    #[tokio::test]
    async fn the_newest_trade_of_a_document_is_found() {
        let (_folder, store) = fresh().await;
        let mut transaction = store.begin().await.expect("begins");
        for (study, wall_s) in [("one", 1.0), ("other", 2.0), ("one", 3.0)] {
            let stored = insert(&mut transaction, &trade(study, wall_s)).await;
            stored.expect("stores");
        }
        store.commit(transaction, 0).await.expect("commits");
        let mut connection = store.read().await.expect("reads");
        let found = newest(&mut connection, "one").await.expect("reads");
        assert_eq!(found, Some(trade("one", 3.0)));
        let found = newest(&mut connection, "third").await.expect("reads");
        assert_eq!(found, None);
        for (study, expected) in [("other", true), ("third", false)] {
            let measured = is_measured(&mut connection, study).await.expect("reads");
            assert_eq!(measured, expected, "{study}");
        }
    }

    #[tokio::test]
    async fn a_changed_trade_is_refused() {
        let (_folder, store) = fresh().await;
        let mut transaction = store.begin().await.expect("begins");
        insert(&mut transaction, &trade("one", 1.0))
            .await
            .expect("stores");
        let spoiled = sqlx::query("update trades set document = replace(document, '0.02', '0.01')")
            .execute(&mut *transaction)
            .await;
        assert_eq!(spoiled.expect("updates").rows_affected(), 1);
        let found = newest(&mut transaction, "one").await;
        assert!(matches!(
            found,
            Err(StoreError::Damaged {
                table: "trades",
                ..
            })
        ));
    }
}
