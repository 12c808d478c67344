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

/// SQLite's primary result code for a full disk.
const SQLITE_FULL: &str = "13";

impl From<sqlx::Error> for StoreError {
    fn from(error: sqlx::Error) -> Self {
        let full = error
            .as_database_error()
            .and_then(|e| e.code())
            .is_some_and(|code| code == SQLITE_FULL);
        if full {
            Self::Full
        } else {
            Self::Database(error)
        }
    }
}
