//! Errors between the program and its database.

use std::path::PathBuf;

/// The database refused, failed, or holds something that it shouldn't.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// Another process holds the database.
    #[error(
        "another strainsite process{} is using the database {}: stop it first, or name another database with --db",
        process.map_or(String::new(), |process| format!(" ({process})")),
        path.display()
    )]
    InUse {
        /// The database file.
        path: PathBuf,
        /// The process, where the system tells.
        process: Option<u32>,
    },
    /// The database can't be opened.
    #[error("the database {} can't be opened: {cause}", path.display())]
    Open {
        /// The database file.
        path: PathBuf,
        /// Cause in the words of the system or SQLite.
        cause: String,
    },
    /// A file of the database isn't the one any more that was opened.
    #[error(
        "{} was removed or replaced while it was in use: nothing is stored any more; put it back, or stop the program and restore a copy",
        file.display()
    )]
    Gone {
        /// The file: the database, its write-ahead log or the log's index.
        file: PathBuf,
    },
    /// A copy can't be written.
    #[error("the copy {} can't be written: {cause}", path.display())]
    Copy {
        /// Path where it was to be.
        path: PathBuf,
        /// Cause in the words of the system or SQLite, and what to do.
        cause: String,
    },
    /// Another database can't be taken in.
    #[error("{} wasn't merged: {cause}", path.display())]
    Merge {
        /// The file of the other database.
        path: PathBuf,
        /// Cause, a clause.
        cause: String,
    },
    /// The disk is full, or the database has grown as far as it may.
    #[error(
        "the database can't grow: its disk is full, or it has reached --max-database-mb; free some space, remove studies \
         (DELETE /v1/studies/{{id}}?purge or strainsite db prune) or raise the limit"
    )]
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
        /// Thing that was to be stored.
        what: &'static str,
    },
    /// Any other failure of SQLite.
    #[error("the database failed: {0}")]
    Database(sqlx::Error),
}

/// SQLite's primary result codes for a full disk, and for a lock that was waited for in vain.
const SQLITE_FULL: i32 = 13;
const SQLITE_BUSY: i32 = 5;
/// SQLite's primary result codes for what it can't make sense of.
const SQLITE_CORRUPT: i32 = 11;
const SQLITE_NOTADB: i32 = 26;
/// SQLite's primary result codes for what can't be opened or may not be written.
const SQLITE_READONLY: i32 = 8;
const SQLITE_CANTOPEN: i32 = 14;

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

/// Whether SQLite can't make sense of the file.
pub(crate) fn is_corrupt(error: &sqlx::Error) -> bool {
    matches!(primary_code(error), Some(SQLITE_CORRUPT | SQLITE_NOTADB))
}

/// Whether SQLite would have to write before it could read.
pub(crate) fn wants_to_write(error: &sqlx::Error) -> bool {
    matches!(primary_code(error), Some(SQLITE_READONLY | SQLITE_CANTOPEN))
}
