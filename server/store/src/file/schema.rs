//! The tables, as their numbered changes make them.

use sqlx::migrate::Migrator;

/// All changes, in order.
pub static MIGRATIONS: Migrator = sqlx::migrate!("../../migrations");

/// Whether a migration that a database has is this program's first.
pub fn is_first(version: i64, checksum: &[u8]) -> bool {
    let first = MIGRATIONS.iter().next();
    first.is_some_and(|first| first.version == version && *first.checksum == *checksum)
}

/// Number of the newest change of the tables.
pub fn newest() -> i64 {
    let versions = MIGRATIONS.iter().map(|migration| migration.version);
    versions.max().unwrap_or(0)
}
