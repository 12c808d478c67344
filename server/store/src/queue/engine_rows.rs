//! Sweeps whose designs other machines solve, or did.

use sqlx::SqliteConnection;

use crate::clock::now;
use crate::column::whole;
use crate::content::{document_sha256, intact};
use crate::row::from_row;
use crate::seals;
use crate::store_error::StoreError;

/// Report of a sweep whose tasks go on.
const NONE: &str = "null";

/// Sweep whose designs other machines solve, or did.
#[derive(Debug, Clone, PartialEq)]
pub struct EngineRow {
    /// Identifier of the sweep.
    pub sweep: String,
    /// Name of the engine.
    pub engine: String,
    begun: String,
    report: String,
    sha256: String,
    /// Time at which nothing of it went on any more; none while something does.
    pub ended: Option<String>,
}

from_row!(EngineRow {
    sweep,
    engine,
    begun,
    report,
    sha256,
    ended
});

impl EngineRow {
    /// Report of what became of the tasks, JSON; `null` while they go on.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when it doesn't match its hash.
    pub fn report(&self) -> Result<&str, StoreError> {
        intact(("sweep_engines", &self.sweep), &self.report, &self.sha256)
    }
}

/// Notes that an engine has a sweep, whatever came of it before.
///
/// # Errors
/// When the database can't be written.
pub async fn begin(
    connection: &mut SqliteConnection,
    sweep: &str,
    engine: &str,
) -> Result<(), StoreError> {
    let query = "insert into sweep_engines (sweep, engine, begun, report, sha256) values (?, ?, ?, ?, ?)
                 on conflict (sweep) do update set engine = excluded.engine, begun = excluded.begun, report = excluded.report, sha256 = excluded.sha256, ended = null, seal = null";
    sqlx::query(query)
        .bind(sweep)
        .bind(engine)
        .bind(now())
        .bind(NONE)
        .bind(document_sha256(NONE))
        .execute(connection)
        .await?;
    Ok(())
}

/// Notes what became of the tasks, JSON: what is left of the sweep has its turns here. Nothing where the sweep was removed, or given to an engine once more.
///
/// # Errors
/// When the database can't be written.
pub async fn end(
    connection: &mut SqliteConnection,
    row: &EngineRow,
    report: &str,
) -> Result<(), StoreError> {
    let query = "update sweep_engines set report = ?, sha256 = ?, ended = ?, seal = null where sweep = ? and begun = ?";
    sqlx::query(query)
        .bind(report)
        .bind(document_sha256(report))
        .bind(now())
        .bind(&row.sweep)
        .bind(&row.begun)
        .execute(connection)
        .await?;
    Ok(())
}

/// The row of a sweep that an engine has or had.
///
/// # Errors
/// [`StoreError::Damaged`] when it was changed; when the database can't be read.
pub(crate) async fn find(
    connection: &mut SqliteConnection,
    sweep: &str,
) -> Result<Option<EngineRow>, StoreError> {
    seals::intact(connection, "sweep_engines", "sweep = ?", sweep).await?;
    let row = sqlx::query_as("select * from sweep_engines where sweep = ?").bind(sweep);
    Ok(row.fetch_optional(connection).await?)
}

/// Lists the sweeps whose tasks go on, and so many others, newest first.
///
/// # Errors
/// [`StoreError::Damaged`] when one was changed; when the database can't be read.
pub async fn list(
    connection: &mut SqliteConnection,
    ended: usize,
) -> Result<Vec<EngineRow>, StoreError> {
    seals::intact(connection, "sweep_engines", "?1 is not null", "").await?;
    let query = "select * from sweep_engines where ended is null
                 union all select * from (select * from sweep_engines where ended is not null order by sweep desc limit ?)
                 order by sweep desc";
    let rows = sqlx::query_as(query).bind(whole(ended));
    Ok(rows.fetch_all(connection).await?)
}
