//! Which solves were in flight when the program died, and how often.

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

/// Counts a crash of every solve that is still in flight, and returns how many there were. Call it before anything runs.
///
/// # Errors
/// When the database can't be written.
pub async fn count(connection: &mut SqliteConnection) -> Result<u64, StoreError> {
    sqlx::query(
        "insert into crashes (key, count) select key, 1 from solves_in_flight where true
         on conflict (key) do update set count = count + 1",
    )
    .execute(&mut *connection)
    .await?;
    let ended = sqlx::query("delete from solves_in_flight")
        .execute(connection)
        .await?;
    Ok(ended.rows_affected())
}

/// How often the program died while this point was being solved.
///
/// # Errors
/// When the database can't be read.
pub async fn of(connection: &mut SqliteConnection, key: &str) -> Result<usize, StoreError> {
    let count: Option<i64> = sqlx::query_scalar("select count from crashes where key = ?")
        .bind(key)
        .fetch_optional(connection)
        .await?;
    Ok(count.and_then(counted).unwrap_or(0))
}

/// Forgets all crashes, and returns how many points had any.
///
/// # Errors
/// When the database can't be written.
pub async fn forget(connection: &mut SqliteConnection) -> Result<u64, StoreError> {
    let forgotten = sqlx::query("delete from crashes")
        .execute(connection)
        .await?;
    Ok(forgotten.rows_affected())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::tests::fresh;

    #[tokio::test]
    async fn only_what_was_in_flight_is_blamed_and_every_time() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        for crash in 1..=3 {
            for key in ["ended", "in flight"] {
                begin(&mut tx, key).await.expect("begins");
            }
            end(&mut tx, "ended").await.expect("ends");
            assert_eq!(count(&mut tx).await.expect("counts"), 1);
            assert_eq!(of(&mut tx, "in flight").await.expect("reads"), crash);
            assert_eq!(of(&mut tx, "ended").await.expect("reads"), 0);
        }
        assert_eq!(count(&mut tx).await.expect("counts"), 0);
        assert_eq!(forget(&mut tx).await.expect("forgets"), 1);
        assert_eq!(of(&mut tx, "in flight").await.expect("reads"), 0);
    }
}
