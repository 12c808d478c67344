//! Connections: one that writes, a few that read.

use std::time::Duration;

use sqlx::sqlite::{SqliteConnectOptions, SqliteJournalMode, SqlitePoolOptions, SqliteSynchronous};
use sqlx::{Connection, SqliteConnection, SqlitePool};

use crate::file::condition;
use crate::file::place::Place;
use crate::file::schema;
use crate::seals;
use crate::store_error::StoreError;

/// Oldest version of SQLite: before it, a database could be corrupted when its write-ahead log was reset.
const SQLITE_OLDEST: [u32; 3] = [3, 51, 3];
const READERS: u32 = 4;
/// SQLite's default size of a page, bytes.
const PAGE: u64 = 4096;
const BUSY_TIMEOUT: Duration = Duration::from_secs(10);

/// Sets the write-ahead log and brings the tables up to date, on a connection of its own: several connections that switch a fresh file
/// at once find it locked.
pub(crate) async fn bootstrap(place: &Place) -> Result<(), StoreError> {
    let options = writing(place).journal_mode(SqliteJournalMode::Wal);
    let mut connection = SqliteConnection::connect_with(&options)
        .await
        .map_err(|error| place.failed(error))?;
    let version: String = sqlx::query_scalar("select sqlite_version()")
        .fetch_one(&mut connection)
        .await?;
    if !new_enough(&version) {
        return Err(place.failed(format!(
            "SQLite {version} is older than 3.51.3, which can corrupt databases"
        )));
    }
    schema::MIGRATIONS
        .run(&mut connection)
        .await
        .map_err(|error| place.failed(error))?;
    // Those of before there were seals; an interruption leaves some for the next start.
    seals::close(&mut connection).await?;
    connection
        .close()
        .await
        .map_err(|error| place.failed(error))
}

/// The one connection that writes, to a file of at most so many bytes.
pub async fn writer(place: &Place, most_bytes: Option<u64>) -> Result<SqlitePool, StoreError> {
    let options = match most_bytes {
        Some(bytes) => writing(place).pragma("max_page_count", (bytes / PAGE).max(1).to_string()),
        None => writing(place),
    };

    Ok(SqlitePoolOptions::new()
        .max_connections(1)
        .idle_timeout(None)
        .max_lifetime(None)
        .after_release(|connection, _| {
            // After a full disk sqlx believes that the transaction is still open and refuses every later one: such a
            // connection is thrown away instead of going back to the pool.
            Box::pin(async move {
                connection.ping().await?;
                Ok(!connection.is_in_transaction())
            })
        })
        .connect_with(options)
        .await?)
}

/// Connections that can only read.
pub(crate) async fn readers(place: &Place) -> Result<SqlitePool, StoreError> {
    only_reading(place, READERS).await
}

/// The one connection that reads whole results. Each connection has a thread, which keeps what it took for the longest text that it read: a pool gives its
/// connections out in turn, so that all of them would come to hold that.
pub(crate) async fn whole_reader(place: &Place) -> Result<SqlitePool, StoreError> {
    only_reading(place, 1).await
}

async fn only_reading(place: &Place, connections: u32) -> Result<SqlitePool, StoreError> {
    Ok(SqlitePoolOptions::new()
        .max_connections(connections)
        // A file doesn't hang up: the question would cost every reader a round to the connection's thread.
        .test_before_acquire(false)
        .connect_with(reading(place))
        .await?)
}

/// A connection that is never used: as long as there is one SQLite keeps its log, whatever becomes of the others.
pub(crate) async fn keeper(place: &Place) -> Result<SqliteConnection, StoreError> {
    Ok(condition::connect(reading(place)).await?)
}

fn reading(place: &Place) -> SqliteConnectOptions {
    SqliteConnectOptions::new()
        .filename(&place.real)
        .read_only(true)
        .busy_timeout(BUSY_TIMEOUT)
}

fn writing(place: &Place) -> SqliteConnectOptions {
    SqliteConnectOptions::new()
        .filename(&place.real)
        .synchronous(SqliteSynchronous::Full)
        .foreign_keys(true)
        .busy_timeout(BUSY_TIMEOUT)
}

fn new_enough(version: &str) -> bool {
    let numbers: Vec<u32> = version
        .split('.')
        .filter_map(|part| part.parse().ok())
        .collect();
    numbers.as_slice() >= SQLITE_OLDEST.as_slice()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_compared_by_number() {
        assert!(new_enough("3.51.3") && new_enough("3.100.0") && new_enough("4.0.0"));
        assert!(!new_enough("3.51.2") && !new_enough("3.6.20"));
    }
}
