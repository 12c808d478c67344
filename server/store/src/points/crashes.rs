//! Crashes: which solves were in flight when the program died, and which of them crash by themselves.

use std::collections::HashMap;

use placement::points::archive::Crashes;
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::column::counted;
use crate::store_error::StoreError;

/// Notes that a solve begins.
///
/// # Errors
/// When the database can't be written.
pub async fn begin(connection: &mut SqliteConnection, key: &str) -> Result<(), StoreError> {
    sqlx::query("insert into solves_in_flight (key, started) values (?, ?) on conflict do nothing")
        .bind(key)
        .bind(now())
        .execute(connection)
        .await?;
    Ok(())
}

/// Notes that it has ended, one way or another.
///
/// # Errors
/// When the database can't be written.
pub async fn end(connection: &mut SqliteConnection, key: &str) -> Result<(), StoreError> {
    sqlx::query("delete from solves_in_flight where key = ?")
        .bind(key)
        .execute(connection)
        .await?;
    Ok(())
}

/// Suspects every solve that is still in flight, and returns how many there were: the program died, and whether one of them is to blame
/// isn't known. Call it before anything runs.
///
/// # Errors
/// When the database can't be written.
pub async fn suspect(connection: &mut SqliteConnection) -> Result<u64, StoreError> {
    sqlx::query(
        "insert into crashes (key, count) select key, 1 from solves_in_flight where true
         on conflict (key) do update set count = count + 1, seal = null",
    )
    .execute(&mut *connection)
    .await?;
    let ended = sqlx::query("delete from solves_in_flight")
        .execute(connection)
        .await?;
    Ok(ended.rows_affected())
}

/// Counts a crash of the process in which a point was solved alone, and returns how many there were.
///
/// # Errors
/// When the database can't be written.
pub async fn count(
    connection: &mut SqliteConnection,
    key: &str,
    cause: &str,
) -> Result<usize, StoreError> {
    let own: i64 = sqlx::query_scalar(
        "insert into crashes (key, count, own, cause) values (?, 1, 1, ?)
         on conflict (key) do update set own = own + 1, cause = excluded.cause, seal = null returning own",
    )
    .bind(key)
    .bind(cause)
    .fetch_one(connection)
    .await?;
    Ok(counted(own).unwrap_or(0))
}

/// The suspect points and what is known of them, by key.
///
/// # Errors
/// When the database can't be read.
pub async fn all(
    connection: &mut SqliteConnection,
) -> Result<HashMap<String, Crashes>, StoreError> {
    let rows: Vec<(String, i64, Option<String>)> =
        sqlx::query_as("select key, own, cause from crashes")
            .fetch_all(connection)
            .await?;
    let suspect = |(key, own, cause): (String, i64, Option<String>)| {
        let own = counted(own).unwrap_or(0);
        let cause = cause.unwrap_or_default();
        (key, Crashes { own, cause })
    };
    Ok(rows.into_iter().map(suspect).collect())
}

/// Forgets all crashes, and returns how many points had any.
///
/// # Errors
/// When the database can't be written.
pub(crate) async fn forget(connection: &mut SqliteConnection) -> Result<u64, StoreError> {
    let forgotten = sqlx::query("delete from crashes")
        .execute(connection)
        .await?;
    Ok(forgotten.rows_affected())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::tests::fresh;

    async fn known(connection: &mut SqliteConnection) -> Vec<(String, Crashes)> {
        all(connection).await.expect("reads").into_iter().collect()
    }

    #[tokio::test]
    async fn what_was_in_flight_is_suspect_and_only_its_own_crashes_count() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        for kill in 1..=5 {
            for key in ["ended", "in flight"] {
                begin(&mut tx, key).await.expect("begins");
            }
            end(&mut tx, "ended").await.expect("ends");
            assert_eq!(suspect(&mut tx).await.expect("suspects"), 1, "kill {kill}");
            assert_eq!(
                known(&mut tx).await,
                [("in flight".to_owned(), Crashes::default())],
                "kill {kill}"
            );
        }
        assert_eq!(suspect(&mut tx).await.expect("suspects"), 0);
        for own in 1..=3 {
            let cause = format!("crash {own}");
            let counted = count(&mut tx, "in flight", &cause).await;
            assert_eq!(counted.expect("counts"), own);
            assert_eq!(
                known(&mut tx).await,
                [("in flight".to_owned(), Crashes { own, cause })]
            );
        }
        assert_eq!(forget(&mut tx).await.expect("forgets"), 1);
        assert_eq!(known(&mut tx).await, []);
    }
}
