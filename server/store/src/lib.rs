//! The database: all SQL of the program, one aggregate per file.
//!
//! - [`Store`]: an open database
//! - [`clock`]: the time, as rows have it
//! - [`content`]: content hashes, and JSON that reads back as what was written
//! - [`mod@file`]: the database file: its lock, its connections, its upkeep
//! - [`queue`]: what was asked, whose turn it is, what happened
//! - [`points`]: solved points
//! - [`answers`]: results and measured trades
//! - [`merging`]: what other databases have, taken in
//! - `seals`: rows that stay in their places
//! - [`removal`]: taking studies out, with all that is theirs alone
//!
//! Functions take a connection, so that the caller owns the transaction. Times are RFC 3339, UTC.

pub mod answers;
pub mod clock;
mod column;
pub mod content;
mod database;
pub mod file;
pub mod merging;
pub mod points;
pub mod queue;
pub mod removal;
mod row;
#[cfg(test)]
mod sealed_rows;
mod seals;
mod store_error;

pub use database::Store;
pub use store_error::StoreError;
