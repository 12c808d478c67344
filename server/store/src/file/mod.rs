//! The database file.
//!
//! - `lock`: one process per database
//! - `pools`: connections: one that writes, a few that read
//! - [`upkeep`]: checks, copies, free pages

pub(crate) mod lock;
pub(crate) mod pools;
pub mod upkeep;
