//! The tables, as their numbered changes make them.

use std::sync::LazyLock;

use sqlx::migrate::{Migration, MigrationType, Migrator};
use sqlx::{Connection, SqlSafeStr, SqliteConnection};

use crate::store_error::StoreError;

/// The files of `migrations`, in order, each by its number and name.
static CHANGES: [(&str, &str); 9] = [
    (
        "0001_tables",
        include_str!("../../../../migrations/0001_tables.sql"),
    ),
    (
        "0002_estimators_in_processes",
        include_str!("../../../../migrations/0002_estimators_in_processes.sql"),
    ),
    (
        "0003_seals",
        include_str!("../../../../migrations/0003_seals.sql"),
    ),
    (
        "0004_briefs",
        include_str!("../../../../migrations/0004_briefs.sql"),
    ),
    (
        "0005_estimator_zeros",
        include_str!("../../../../migrations/0005_estimator_zeros.sql"),
    ),
    (
        "0006_model_runs",
        include_str!("../../../../migrations/0006_model_runs.sql"),
    ),
    (
        "0007_sweep_engines",
        include_str!("../../../../migrations/0007_sweep_engines.sql"),
    ),
    (
        "0008_result_extracts",
        include_str!("../../../../migrations/0008_result_extracts.sql"),
    ),
    (
        "0009_brief_column",
        include_str!("../../../../migrations/0009_brief_column.sql"),
    ),
];

/// All changes, in order.
pub(crate) static MIGRATIONS: LazyLock<Migrator> = LazyLock::new(|| {
    let migrations = CHANGES.iter().filter_map(|(file, sql)| change(file, sql));
    Migrator::with_migrations(migrations.collect())
});

fn change(file: &str, sql: &'static str) -> Option<Migration> {
    let (number, name) = file.split_once('_')?;
    let description = name.replace('_', " ").into();
    let number = number.parse().ok()?;
    Some(Migration::new(
        number,
        description,
        MigrationType::Simple,
        sql.into_sql_str(),
        false,
    ))
}

/// Whether a migration that a database has is this program's first.
pub fn is_first(version: i64, checksum: &[u8]) -> bool {
    let first = MIGRATIONS.iter().next();
    first.is_some_and(|first| first.version == version && *first.checksum == *checksum)
}

/// Name of a table, view, trigger or index that the changes don't make, or make otherwise.
///
/// # Errors
/// When it can't be read.
pub(crate) async fn strange(
    connection: &mut SqliteConnection,
) -> Result<Option<String>, StoreError> {
    let mut fresh = SqliteConnection::connect("sqlite::memory:").await?;
    MIGRATIONS
        .run(&mut fresh)
        .await
        .map_err(sqlx::Error::from)?;
    let [own, found] = [objects(&mut fresh).await?, objects(connection).await?];
    fresh.close().await?;
    let mut others = found.iter().filter(|object| !own.contains(object));
    Ok(others.next().map(|(name, _)| name.clone()))
}

/// Names and definitions of all that a database has. SQLite's own have none.
async fn objects(
    connection: &mut SqliteConnection,
) -> Result<Vec<(String, Option<String>)>, StoreError> {
    let query = "select name, sql from sqlite_schema where sql is not null and name not like 'sqlite~_%' escape '~' order by name";
    Ok(sqlx::query_as(query).fetch_all(connection).await?)
}

/// Number of the newest change of the tables.
pub fn newest() -> i64 {
    let versions = MIGRATIONS.iter().map(|migration| migration.version);
    versions.max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[tokio::test]
    async fn every_file_of_the_folder_is_a_change() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../migrations");
        let files = Migrator::new(folder).await.expect("reads");
        let facts = |migrator: &Migrator| -> Vec<_> {
            let changes = migrator.iter();
            changes
                .map(|one| (one.version, one.description.clone(), one.checksum.clone()))
                .collect()
        };
        assert_eq!(facts(&MIGRATIONS), facts(&files));
    }
}
