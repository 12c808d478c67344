//! Studies: what was asked, and how far it got.
//!
//! A study is `queued`, `running`, then `done`, `failed` or `cancelled`. Every change of state is guarded by the state
//! that it starts from, so that a late writer never overwrites an end. One process holds the database, so a study
//! that is `running` when the process starts was left behind by a crash.

use results::Estimate;
use serde::{Deserialize, Serialize};
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::column::{counted, whole};
use crate::content::{document_sha256, encode, intact};
use crate::queue::listed::{Listed, RowChange};
use crate::row::from_row;
use crate::seals;
use crate::store_error::StoreError;

/// State of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum State {
    /// Waits for its turn, from the start or for what it still lacks.
    Queued,
    /// Is being solved.
    Running,
    /// Has a result.
    Done,
    /// Has none, and `error` says why.
    Failed,
    /// Was cancelled.
    Cancelled,
}

impl State {
    /// The name in documents and in the database.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Done => "done",
            Self::Failed => "failed",
            Self::Cancelled => "cancelled",
        }
    }

    /// States, all of them.
    pub const ALL: [Self; 5] = [
        Self::Queued,
        Self::Running,
        Self::Done,
        Self::Failed,
        Self::Cancelled,
    ];

    /// The state of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|state| state.as_str() == name)
    }
}

/// A study as stored.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyRow {
    /// UUID, ordered by time.
    pub id: String,
    /// Name in lists: the document's, unless it was changed.
    pub name: String,
    spec: String,
    /// SHA-256 of the canonical document.
    pub spec_sha256: String,
    state: String,
    /// Points of its plan, once known.
    pub points_total: Option<i64>,
    /// Points that have a response.
    pub points_done: i64,
    /// Reason why it failed.
    pub error: Option<String>,
    /// Time at which it was submitted.
    pub created: String,
    /// Time at which it was first started.
    pub started: Option<String>,
    /// Time at which it ended.
    pub finished: Option<String>,
    /// Estimate of its cost when it last started, JSON.
    pub estimate: Option<String>,
    /// Priority: studies of higher ones go first.
    pub priority: i64,
    /// Time at which it was archived, so that lists leave it out.
    pub archived: Option<String>,
    /// Answer in few characters; `None` before there is one, and of results of earlier versions.
    pub brief: Option<String>,
}

from_row!(StudyRow {
    id,
    name,
    spec,
    spec_sha256,
    state,
    points_total,
    points_done,
    error,
    created,
    started,
    finished,
    estimate,
    priority,
    archived,
    brief
});

impl StudyRow {
    /// Returns its state.
    ///
    /// # Panics
    /// Never: the table allows no other names.
    pub fn state(&self) -> State {
        State::named(&self.state).expect("the table's check allows known states only")
    }

    /// The canonical document, JSON.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when it doesn't match its hash.
    pub fn document(&self) -> Result<&str, StoreError> {
        intact(("studies", &self.id), &self.spec, &self.spec_sha256)
    }

    /// Whether it has come to an end.
    pub fn ended(&self) -> bool {
        matches!(self.state(), State::Done | State::Failed | State::Cancelled)
    }
}

/// Stores a new study at the end of the queue and returns its identifier.
///
/// # Errors
/// When the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    name: &str,
    document: &str,
) -> Result<String, StoreError> {
    let id = uuid::Uuid::now_v7().to_string();
    let query = "insert into studies (id, name, spec, spec_sha256, state, created, place)
                 values (?, ?, ?, ?, 'queued', ?, (select coalesce(max(place), 0) + 1 from studies))";
    sqlx::query(query)
        .bind(&id)
        .bind(name)
        .bind(document)
        .bind(document_sha256(document))
        .bind(now())
        .execute(connection)
        .await?;
    Ok(id)
}

/// The study of this identifier.
///
/// # Errors
/// [`StoreError::Damaged`] when it was exchanged with another one; when the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Option<StudyRow>, StoreError> {
    seals::intact(connection, "studies", "id = ?", id).await?;
    Ok(sqlx::query_as("select * from listed_studies where id = ?")
        .bind(id)
        .fetch_optional(connection)
        .await?)
}

/// Filter of a list: all studies that aren't archived unless something is said.
#[derive(Debug, Clone, Copy, Default)]
pub struct Filter<'f> {
    /// State of the studies.
    pub state: Option<State>,
    /// The designs of the sweep of this identifier; for `none`, those that are no design of any.
    pub sweep: Option<&'f str>,
    /// Search among the studies.
    pub listed: Listed<'f>,
}

/// Lists up to `limit` studies, newest first, older than the study `before`.
///
/// # Errors
/// When the database can't be read.
pub async fn page(
    connection: &mut SqliteConnection,
    filter: Filter<'_>,
    before: Option<&str>,
    limit: u32,
) -> Result<Vec<StudyRow>, StoreError> {
    let query = "select * from listed_studies
                 where (?1 is null or state = ?1) and (?2 is null or id < ?2)
                 and (?4 is null or case ?4
                    when 'none' then not exists (select 1 from sweep_designs where study = listed_studies.id)
                    else exists (select 1 from sweep_designs where study = listed_studies.id and sweep = ?4) end)
                 and (?5 is null or instr(lower(name), lower(?5)) > 0 or substr(id, 1, length(?5)) = lower(?5))
                 and (?6 is null or (archived is not null) = ?6)
                 order by id desc limit ?3";
    Ok(sqlx::query_as(query)
        .bind(filter.state.map(State::as_str))
        .bind(before)
        .bind(limit)
        .bind(filter.sweep)
        .bind(filter.listed.search)
        .bind(filter.listed.archived.wanted())
        .fetch_all(connection)
        .await?)
}

/// Counts the studies in each state.
///
/// # Errors
/// When the database can't be read.
pub async fn counts(connection: &mut SqliteConnection) -> Result<Vec<(State, i64)>, StoreError> {
    by_state(
        connection,
        "select state, count(*) from studies group by state",
    )
    .await
}

/// The answer of a query for states with their counts, every state once.
pub(crate) async fn by_state(
    connection: &mut SqliteConnection,
    query: &'static str,
) -> Result<Vec<(State, i64)>, StoreError> {
    let rows: Vec<(String, i64)> = sqlx::query_as(query).fetch_all(connection).await?;
    let count = |state: State| {
        let row = rows.iter().find(|(name, _)| name == state.as_str());
        (state, row.map_or(0, |(_, count)| *count))
    };
    Ok(State::ALL.into_iter().map(count).collect())
}

/// The newest queued study of the same document, unless that was damaged: one that was interrupted, or still waits.
///
/// # Errors
/// When the database can't be read.
pub async fn queued_twin(
    connection: &mut SqliteConnection,
    spec_sha256: &str,
) -> Result<Option<StudyRow>, StoreError> {
    let query = "select * from listed_studies where spec_sha256 = ? and state = 'queued' order by id desc limit 1";
    let twin: Option<StudyRow> = sqlx::query_as(query)
        .bind(spec_sha256)
        .fetch_optional(connection)
        .await?;
    Ok(twin.filter(|twin| twin.document().is_ok()))
}

/// The newest other study of the same document that is done and has every one of its points stored: none of them broke.
///
/// # Errors
/// When the database can't be read.
pub async fn answered_twin(
    connection: &mut SqliteConnection,
    id: &str,
    spec_sha256: &str,
) -> Result<Option<String>, StoreError> {
    let query = "select id from studies where spec_sha256 = ? and id <> ? and state = 'done'
                 and points_total = (select count(*) from study_points where study = studies.id) order by id desc limit 1";
    Ok(sqlx::query_scalar(query)
        .bind(spec_sha256)
        .bind(id)
        .fetch_optional(connection)
        .await?)
}

/// The most points that any study of this document has.
///
/// # Errors
/// When the database can't be read.
pub async fn points_of_twins(
    connection: &mut SqliteConnection,
    spec_sha256: &str,
) -> Result<usize, StoreError> {
    let query = "select coalesce(max(points_done), 0) from studies where spec_sha256 = ?";
    let points = sqlx::query_scalar(query).bind(spec_sha256);
    Ok(counted(points.fetch_one(connection).await?).unwrap_or(0))
}

/// Whether a study is running.
///
/// # Errors
/// When the database can't be read.
pub async fn is_running(connection: &mut SqliteConnection, id: &str) -> Result<bool, StoreError> {
    let running = find(connection, id).await?.map(|row| row.state());
    Ok(running == Some(State::Running))
}

/// Ends a running study; false when it isn't running any more.
///
/// # Errors
/// When the database can't be written.
pub async fn finish(
    connection: &mut SqliteConnection,
    id: &str,
    state: State,
    error: Option<&str>,
) -> Result<bool, StoreError> {
    let query = "update studies set state_seal = null, state = ?, error = ?, finished = ? where id = ? and state = 'running'";
    let done = sqlx::query(query)
        .bind(state.as_str())
        .bind(error)
        .bind(now())
        .bind(id)
        .execute(connection)
        .await?;
    Ok(done.rows_affected() == 1)
}

/// Cancels a study that hasn't ended; false when it has.
///
/// # Errors
/// When the database can't be written.
pub async fn cancel(connection: &mut SqliteConnection, id: &str) -> Result<bool, StoreError> {
    let query = "update studies set state_seal = null, state = 'cancelled', finished = ? where id = ? and state in ('queued', 'running')";
    Ok(sqlx::query(query)
        .bind(now())
        .bind(id)
        .execute(connection)
        .await?
        .rows_affected()
        == 1)
}

/// Changes what lists say of a study. What is archived already keeps its time.
///
/// # Errors
/// When the database can't be written.
pub async fn change(
    connection: &mut SqliteConnection,
    id: &str,
    change: &RowChange,
) -> Result<(), StoreError> {
    let query = "update studies set state_seal = null, name = coalesce(?2, name),
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

/// Notes how many points the plan has, and how many of them are known already.
///
/// # Errors
/// When the database can't be written.
pub async fn set_progress(
    connection: &mut SqliteConnection,
    id: &str,
    total: usize,
    done: usize,
) -> Result<(), StoreError> {
    sqlx::query(
        "update studies set state_seal = null, points_total = ?, points_done = ? where id = ?",
    )
    .bind(whole(total))
    .bind(whole(done))
    .bind(id)
    .execute(connection)
    .await?;
    Ok(())
}

/// Notes what a study that starts or runs is expected to take.
///
/// # Errors
/// [`StoreError::NotFinite`] when a number isn't finite; when the database can't be written.
pub async fn set_estimate(
    connection: &mut SqliteConnection,
    id: &str,
    estimate: &Estimate,
) -> Result<(), StoreError> {
    sqlx::query("update studies set state_seal = null, estimate = ? where id = ?")
        .bind(encode("the estimate of a study", estimate)?)
        .bind(id)
        .execute(connection)
        .await?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::tests::fresh;
    use crate::queue::listed::Archived;

    #[tokio::test]
    async fn pages_go_from_new_to_old_without_overlap() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        let mut ids = Vec::new();
        for name in ["a", "b", "c"] {
            ids.push(insert(&mut tx, name, "{}").await.expect("inserts"));
        }
        let first = page(&mut tx, Filter::default(), None, 2)
            .await
            .expect("reads");
        let of = |state: State| Filter {
            state: Some(state),
            ..Filter::default()
        };
        let rest = page(&mut tx, of(State::Queued), Some(&first[1].id), 2)
            .await
            .expect("reads");
        let seen: Vec<&str> = first
            .iter()
            .chain(&rest)
            .map(|row| row.id.as_str())
            .collect();
        assert_eq!(seen, [&ids[2], &ids[1], &ids[0]]);
        assert!(
            page(&mut tx, of(State::Done), None, 2)
                .await
                .expect("reads")
                .is_empty()
        );
    }

    #[tokio::test]
    async fn a_search_takes_its_characters_literally_and_a_change_leaves_the_document() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        let mut ids = Vec::new();
        for name in ["Wall 50%", "wall 500", "a_b", "axb"] {
            ids.push(insert(&mut tx, name, "{}").await.expect("inserts"));
        }
        let change_of = |archived| RowChange {
            name: Some("Bead".to_owned()),
            archived,
        };
        for archived in [Some(true), None] {
            let changed = change(&mut tx, &ids[3], &change_of(archived)).await;
            changed.expect("changes");
        }
        let row = find(&mut tx, &ids[3]).await.expect("reads").expect("there");
        assert_eq!(
            (row.name.as_str(), row.document().ok()),
            ("Bead", Some("{}"))
        );

        let (all, alone) = (Archived::All, Archived::Alone);
        for (search, archived, found) in [
            (None, Archived::Without, &ids[..3]),
            (None, alone, &ids[3..]),
            (None, all, &ids[..]),
            (Some("WALL 50"), all, &ids[..2]),
            (Some("50%"), all, &ids[..1]),
            (Some("a_"), all, &ids[2..3]),
            (Some("bead"), all, &ids[3..]),
            (Some("bead"), Archived::Without, &[]),
            (Some(ids[1].to_uppercase().as_str()), all, &ids[1..2]),
            (Some(&ids[1][1..]), all, &[]),
        ] {
            let filter = Filter {
                listed: Listed { search, archived },
                ..Filter::default()
            };
            let rows = page(&mut tx, filter, None, 9).await.expect("reads");
            let mut seen: Vec<&str> = rows.iter().map(|row| row.id.as_str()).collect();
            seen.reverse();
            assert_eq!(seen, found, "{search:?} {archived:?}");
        }
    }
}
