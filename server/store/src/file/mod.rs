//! The database file.
//!
//! - `place`, `identity`: where it is, and which file that is
//! - `lock`: one process per database
//! - `rights`: who may read what is made
//! - `presence`: whether an open one is still there
//! - `schema`: its tables
//! - `condition`, [`opening`]: what a file is before it is touched
//! - `pools`: connections: one that writes, a few that read
//! - [`copies`], [`unfinished`]: copies, and a copy back in its place
//! - [`upkeep`], `keyed_rows`: checks, free pages

pub(crate) mod condition;
pub mod copies;
pub(crate) mod identity;
pub(crate) mod keyed_rows;
pub(crate) mod lock;
pub mod opening;
pub(crate) mod place;
pub(crate) mod pools;
pub(crate) mod presence;
pub(crate) mod rights;
pub(crate) mod schema;
pub mod unfinished;
pub mod upkeep;
