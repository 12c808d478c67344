//! The numbered changes of the tables, read from their folder.

use std::path::Path;

use sqlx::migrate::Migrator;

/// All of them.
pub async fn all() -> Migrator {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../migrations");
    Migrator::new(folder).await.expect("reads")
}

/// The first so many, as an earlier version had them.
pub async fn first(count: usize) -> Migrator {
    let first = all().await.iter().take(count).cloned().collect();
    Migrator::with_migrations(first)
}
