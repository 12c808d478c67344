//! Sweeps: which studies are the designs of one.

use serde_json::{Map, Value};
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::column::whole;
use crate::content::{document_sha256, encode, intact};
use crate::queue::listed::{Listed, RowChange};
use crate::queue::study_rows::StudyRow;
use crate::row::from_row;
use crate::seals;
use crate::store_error::StoreError;

/// A sweep as stored.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRow {
    /// UUID, ordered by time.
    pub id: String,
    /// Free text.
    pub name: String,
    spec: String,
    spec_sha256: String,
    /// Priority of its studies.
    pub priority: i64,
    /// Time at which it was submitted.
    pub created: String,
    /// Time at which it was archived, so that lists leave it out.
    pub archived: Option<String>,
}

from_row!(SweepRow {
    id,
    name,
    spec,
    spec_sha256,
    priority,
    created,
    archived
});

impl SweepRow {
    /// The canonical document of the study without changes, JSON.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when it doesn't match its hash.
    pub fn document(&self) -> Result<&str, StoreError> {
        intact(("sweeps", &self.id), &self.spec, &self.spec_sha256)
    }
}

/// A design of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignRow {
    /// Place in the sweep.
    pub ordinal: i64,
    /// Name that tells it from the others.
    pub name: String,
    /// Values by path.
    pub set: Map<String, Value>,
    /// The study that answers for it.
    pub study: StudyRow,
}

/// Stores a new sweep without designs and returns its identifier.
///
/// # Errors
/// When the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    name: &str,
    document: &str,
    priority: i64,
) -> Result<String, StoreError> {
    let id = uuid::Uuid::now_v7().to_string();
    sqlx::query("insert into sweeps (id, name, spec, spec_sha256, priority, created) values (?, ?, ?, ?, ?, ?)")
        .bind(&id)
        .bind(name)
        .bind(document)
        .bind(document_sha256(document))
        .bind(priority)
        .bind(now())
        .execute(connection)
        .await?;
    Ok(id)
}

/// Adds a design behind the others.
///
/// # Errors
/// [`StoreError::NotFinite`] when a value isn't finite; when the database can't be written.
pub async fn add_design(
    connection: &mut SqliteConnection,
    sweep: &str,
    name: &str,
    set: &Map<String, Value>,
    study: &str,
) -> Result<(), StoreError> {
    sqlx::query("update sweeps set seal = null, designs = designs + 1 where id = ?")
        .bind(sweep)
        .execute(&mut *connection)
        .await?;
    let query = "insert into sweep_designs (sweep, ordinal, name, settings, study)
                 values (?1, (select coalesce(max(ordinal) + 1, 0) from sweep_designs where sweep = ?1), ?2, ?3, ?4)";
    sqlx::query(query)
        .bind(sweep)
        .bind(name)
        .bind(encode("the settings of a design", set)?)
        .bind(study)
        .execute(connection)
        .await?;
    Ok(())
}

/// Lets another study answer for a design.
///
/// # Errors
/// When the database can't be written.
pub async fn replace_study(
    connection: &mut SqliteConnection,
    sweep: &str,
    ordinal: i64,
    study: &str,
) -> Result<(), StoreError> {
    sqlx::query("update sweep_designs set study = ?, seal = null where sweep = ? and ordinal = ?")
        .bind(study)
        .bind(sweep)
        .bind(ordinal)
        .execute(connection)
        .await?;
    Ok(())
}

/// The sweep of this identifier.
///
/// # Errors
/// When the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Option<SweepRow>, StoreError> {
    seals::intact(connection, "sweeps", "id = ?", id).await?;
    let query = "select * from sweeps where id = ?";
    Ok(sqlx::query_as(query)
        .bind(id)
        .fetch_optional(connection)
        .await?)
}

/// Lists up to `limit` of the sweeps that are looked for, newest first, older than the sweep `before`.
///
/// # Errors
/// When the database can't be read.
pub async fn page(
    connection: &mut SqliteConnection,
    listed: Listed<'_>,
    before: Option<&str>,
    limit: u32,
) -> Result<Vec<SweepRow>, StoreError> {
    let query = "select * from sweeps
                 where (?1 is null or id < ?1)
                 and (?3 is null or instr(lower(name), lower(?3)) > 0 or substr(id, 1, length(?3)) = lower(?3))
                 and (?4 is null or (archived is not null) = ?4)
                 order by id desc limit ?2";
    Ok(sqlx::query_as(query)
        .bind(before)
        .bind(limit)
        .bind(listed.search)
        .bind(listed.archived.wanted())
        .fetch_all(connection)
        .await?)
}

/// Changes what lists say of a sweep. What is archived already keeps its time.
///
/// # Errors
/// When the database can't be written.
pub async fn change(
    connection: &mut SqliteConnection,
    id: &str,
    change: &RowChange,
) -> Result<(), StoreError> {
    let query = "update sweeps set state_seal = null, name = coalesce(?2, name),
                 archived = case ?3 when true then coalesce(archived, ?4) when false then null else archived end where id = ?1";
    sqlx::query(query)
        .bind(id)
        .bind(&change.name)
        .bind(change.archived)
        .bind(now())
        .execute(connection)
        .await?;
    Ok(())
}

struct Joined {
    ordinal: i64,
    design: String,
    settings: String,
    study: StudyRow,
}

from_row!(Joined { ordinal, design, settings; study });

/// The designs of a sweep with their studies, in order.
///
/// # Errors
/// [`StoreError::Damaged`] when one was changed, exchanged or lost; when the database can't be read.
pub async fn designs(
    connection: &mut SqliteConnection,
    sweep: &str,
) -> Result<Vec<DesignRow>, StoreError> {
    let query = "select d.ordinal, d.name as design, d.settings, s.* from sweep_designs d join listed_studies s on s.id = d.study
                 where d.sweep = ? order by d.ordinal";
    seals::intact(connection, "sweep_designs", "sweep = ?", sweep).await?;
    let rows: Vec<Joined> = sqlx::query_as(query)
        .bind(sweep)
        .fetch_all(&mut *connection)
        .await?;
    let counted: Option<i64> = sqlx::query_scalar("select designs from sweeps where id = ?")
        .bind(sweep)
        .fetch_optional(&mut *connection)
        .await?;
    if counted.is_some_and(|counted| counted != whole(rows.len())) {
        return Err(StoreError::Damaged {
            table: "sweep_designs",
            row: sweep.to_owned(),
        });
    }
    let studies = "id in (select study from sweep_designs where sweep = ?)";
    seals::intact(connection, "studies", studies, sweep).await?;
    let design = |row: Joined| DesignRow {
        ordinal: row.ordinal,
        name: row.design,
        set: serde_json::from_str(&row.settings).unwrap_or_default(),
        study: row.study,
    };
    Ok(rows.into_iter().map(design).collect())
}

/// Answer to whether anybody waits for a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Openness {
    /// A design waits or is being solved.
    Open,
    /// All of its designs have ended.
    Ended,
    /// No such sweep is there.
    Gone,
}

/// Whether anybody waits for a sweep.
///
/// # Errors
/// When the database can't be read.
pub async fn openness(
    connection: &mut SqliteConnection,
    sweep: &str,
) -> Result<Openness, StoreError> {
    let query = "select exists (select 1 from sweeps where id = ?1),
                 exists (select 1 from sweep_designs join studies on studies.id = study where sweep = ?1 and state in ('queued', 'running'))";
    let (is_there, is_open): (bool, bool) = sqlx::query_as(query)
        .bind(sweep)
        .fetch_one(connection)
        .await?;
    Ok(match (is_there, is_open) {
        (_, true) => Openness::Open,
        (true, false) => Openness::Ended,
        (false, false) => Openness::Gone,
    })
}

/// The sweep that a study is a design of.
///
/// # Errors
/// When the database can't be read.
pub async fn of_study(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<String>, StoreError> {
    Ok(
        sqlx::query_scalar("select sweep from sweep_designs where study = ?")
            .bind(study)
            .fetch_optional(connection)
            .await?,
    )
}

/// The sweep submitted under this key, and the hash of what was submitted.
///
/// # Errors
/// When the database can't be read.
pub async fn under_key(
    connection: &mut SqliteConnection,
    key: &str,
) -> Result<Option<(String, String)>, StoreError> {
    seals::intact(connection, "sweep_keys", "key = ?", key).await?;
    Ok(
        sqlx::query_as("select sweep, sha256 from sweep_keys where key = ?")
            .bind(key)
            .fetch_optional(connection)
            .await?,
    )
}

/// Notes that this key stands for this sweep.
///
/// # Errors
/// When the key is taken, or the database can't be written.
pub async fn insert_key(
    connection: &mut SqliteConnection,
    key: &str,
    sweep: &str,
    sha256: &str,
) -> Result<(), StoreError> {
    sqlx::query("insert into sweep_keys (key, sweep, sha256, created) values (?, ?, ?, ?)")
        .bind(key)
        .bind(sweep)
        .bind(sha256)
        .bind(now())
        .execute(connection)
        .await?;
    Ok(())
}
