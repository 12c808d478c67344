//! What can go wrong between the program and its database.

use std::path::PathBuf;

/// The database refused, failed, or holds something that it shouldn't.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// Another process holds the database.
    #[error(
        "another strainsite process is using the database {}: stop it first, or name another database with --db",
        path.display()
    )]
    InUse {
        /// The database file.
        path: PathBuf,
    },
    /// The database can't be opened.
    #[error("the database {} can't be opened: {cause}", path.display())]
    Open {
        /// The database file.
        path: PathBuf,
        /// What the system or SQLite said.
        cause: String,
    },
    /// The disk is full.
    #[error("the disk that holds the database is full: free some space and try again")]
    Full,
    /// The database did not answer in time.
    #[error("the database is busy: try again in a moment")]
    Busy,
    /// A row does not match the hash stored with it.
    #[error("row {row:?} of table {table} is damaged: its content does not match its hash")]
    Damaged {
        /// Table of the row.
        table: &'static str,
        /// Primary key of the row.
        row: String,
    },
    /// A value can't be written as JSON without loss, because a number in it is not finite.
    #[error("{what} holds a number that is not finite and was not stored")]
    NotFinite {
        /// What was to be stored.
        what: &'static str,
    },
    /// Any other failure of SQLite.
    #[error("the database failed: {0}")]
    Database(sqlx::Error),
}

/// SQLite's primary result codes for a full disk, and for a lock that was waited for in vain.
const SQLITE_FULL: i32 = 13;
const SQLITE_BUSY: i32 = 5;

impl From<sqlx::Error> for StoreError {
    fn from(error: sqlx::Error) -> Self {
        if matches!(error, sqlx::Error::PoolTimedOut) {
            return Self::Busy;
        }
        match primary_code(&error) {
            Some(SQLITE_FULL) => Self::Full,
            Some(SQLITE_BUSY) => Self::Busy,
            _ => Self::Database(error),
        }
    }
}

/// SQLite's result code without what extends it.
fn primary_code(error: &sqlx::Error) -> Option<i32> {
    let code = error.as_database_error()?.code()?;
    code.parse().ok().map(|code: i32| code & 0xff)
}
