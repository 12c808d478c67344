//! Designs of sweeps: which studies they are, and how far those are.

use std::collections::HashMap;
use std::ops::Range;

use serde_json::{Map, Value};
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::column::{counted, whole};
use crate::content::encode;
use crate::queue::study_rows::{State, StudyRow};
use crate::row::from_row;
use crate::seals;
use crate::store_error::StoreError;

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

struct Joined {
    ordinal: i64,
    design: String,
    settings: String,
    study: StudyRow,
}

from_row!(Joined { ordinal, design, settings; study });

/// Places of all designs.
pub const ALL: Range<usize> = 0..usize::MAX;

/// The designs of a sweep at these places with their studies, in order.
///
/// # Errors
/// [`StoreError::Damaged`] when one was changed, exchanged or lost; when the database can't be read.
pub async fn designs(
    connection: &mut SqliteConnection,
    sweep: &str,
    places: Range<usize>,
) -> Result<Vec<DesignRow>, StoreError> {
    let (first, end) = (whole(places.start), whole(places.end));
    let within = format!("sweep = ? and ordinal >= {first} and ordinal < {end}");
    seals::intact(connection, "sweep_designs", &within, sweep).await?;
    let query = "select d.ordinal, d.name as design, d.settings, s.* from sweep_designs d join listed_studies s on s.id = d.study
                 where d.sweep = ? and d.ordinal >= ? and d.ordinal < ? order by d.ordinal";
    let rows: Vec<Joined> = sqlx::query_as(query)
        .bind(sweep)
        .bind(first)
        .bind(end)
        .fetch_all(&mut *connection)
        .await?;
    let designs = count(connection, sweep).await?;
    let expected = |there: usize| places.end.min(there).saturating_sub(places.start);
    if designs.is_some_and(|there| expected(there) != rows.len()) {
        return Err(StoreError::Damaged {
            table: "sweep_designs",
            row: sweep.to_owned(),
        });
    }
    let studies = format!("id in (select study from sweep_designs where {within})");
    seals::intact(connection, "studies", &studies, sweep).await?;
    let design = |row: Joined| DesignRow {
        ordinal: row.ordinal,
        name: row.design,
        set: serde_json::from_str(&row.settings).unwrap_or_default(),
        study: row.study,
    };
    Ok(rows.into_iter().map(design).collect())
}

/// Designs that a sweep should have; none where there is no such sweep.
async fn count(
    connection: &mut SqliteConnection,
    sweep: &str,
) -> Result<Option<usize>, StoreError> {
    let query = sqlx::query_scalar("select designs from sweeps where id = ?").bind(sweep);
    Ok(query.fetch_optional(connection).await?.and_then(counted))
}

/// Designs of a sweep that are in one state.
struct InState {
    state: String,
    designs: i64,
    /// Designs whose plan is known.
    planned: i64,
    points_total: i64,
    points_done: i64,
    finished: Option<String>,
}

from_row!(InState {
    state,
    designs,
    planned,
    points_total,
    points_done,
    finished
});

/// Standing of a sweep: how far its designs are.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Standing {
    by_state: HashMap<State, usize>,
    /// Points of all designs; none while a plan isn't known.
    pub points_total: Option<i64>,
    /// Points that have an outcome.
    pub points_done: i64,
    /// Time at which the last design ended; none while one hasn't.
    pub finished: Option<String>,
    /// Time in which any design was at work, s.
    pub worked_s: f64,
}

impl Standing {
    /// Designs in a state.
    pub fn count(&self, state: State) -> usize {
        self.by_state.get(&state).copied().unwrap_or(0)
    }
}

/// Seconds in which any design was at work: of each what lies behind the end of all that began before it.
const WORKED: &str = "with spans as (
         select julianday(started) as began, julianday(coalesce(finished, ?2)) as ended
         from sweep_designs join studies on studies.id = study where sweep = ?1 and started is not null and state <> 'queued'),
     ordered as (
         select began, ended, max(ended) over (order by began rows between unbounded preceding and 1 preceding) as before from spans)
     select round(86400.0 * coalesce(sum(max(0.0, ended - max(began, coalesce(before, began)))), 0.0), 3) from ordered";

/// Standing of a sweep, of whose designs none is read.
///
/// # Errors
/// When the database can't be read.
pub async fn standing(
    connection: &mut SqliteConnection,
    sweep: &str,
) -> Result<Standing, StoreError> {
    let query = "select state, count(*) as designs, count(points_total) as planned, coalesce(sum(points_total), 0) as points_total,
                 coalesce(sum(points_done), 0) as points_done, max(finished) as finished
                 from sweep_designs join studies on studies.id = study where sweep = ? group by state";
    let groups: Vec<InState> = sqlx::query_as(query)
        .bind(sweep)
        .fetch_all(&mut *connection)
        .await?;
    let worked_s = sqlx::query_scalar(WORKED).bind(sweep).bind(now());
    let worked_s = worked_s.fetch_one(connection).await?;
    let by_state = groups.iter().filter_map(|group| {
        let state = State::named(&group.state)?;
        Some((state, counted(group.designs)?))
    });
    let by_state: HashMap<State, usize> = by_state.collect();
    let planned = groups.iter().all(|group| group.planned == group.designs);
    let waits = [State::Queued, State::Running]
        .iter()
        .any(|state| by_state.contains_key(state));
    let finished = groups.iter().filter_map(|group| group.finished.clone());
    Ok(Standing {
        by_state,
        points_total: planned.then(|| groups.iter().map(|group| group.points_total).sum()),
        points_done: groups.iter().map(|group| group.points_done).sum(),
        finished: finished.max().filter(|_| !waits),
        worked_s,
    })
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

/// Studies of a sweep that haven't ended, in the order of their designs, of which none is read.
///
/// # Errors
/// When the database can't be read.
pub async fn open_studies(
    connection: &mut SqliteConnection,
    sweep: &str,
) -> Result<Vec<String>, StoreError> {
    let query = "select study from sweep_designs join studies on studies.id = study
                 where sweep = ? and state in ('queued', 'running') order by ordinal";
    Ok(sqlx::query_scalar(query)
        .bind(sweep)
        .fetch_all(connection)
        .await?)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::tests::fresh;
    use crate::queue::{study_rows, sweep_rows};

    /// A sweep of four designs: two done with an overlap, one that runs again since a pause, one that waits and was begun before.
    async fn begun(connection: &mut SqliteConnection) -> String {
        let sweep = sweep_rows::insert(connection, "walls", "{}", 0).await;
        let sweep = sweep.expect("inserts");
        for (state, total, started, finished) in [
            ("done", Some(26), Some("00:00:00"), Some("00:00:08")),
            ("done", Some(26), Some("00:00:06"), Some("00:00:12")),
            ("running", Some(26), Some("00:01:40"), Some("00:01:44")),
            ("queued", None, Some("00:00:20"), None),
        ] {
            let study = study_rows::insert(connection, "a", "{}").await;
            let study = study.expect("inserts");
            let added = add_design(connection, &sweep, "a", &Map::new(), &study).await;
            added.expect("adds");
            let time = |time: Option<&str>| time.map(|time| format!("2026-01-01T{time}.000Z"));
            let query = "update studies set state = ?, points_total = ?, points_done = 1, started = ?, finished = ? where id = ?";
            let changed = sqlx::query(query)
                .bind(state)
                .bind(total)
                .bind(time(started))
                .bind(time(finished))
                .bind(&study);
            changed.execute(&mut *connection).await.expect("changes");
        }
        sweep
    }

    #[tokio::test]
    async fn a_sweep_was_at_work_where_any_of_its_designs_was() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        let sweep = begun(&mut tx).await;
        let found = standing(&mut tx, &sweep).await.expect("reads");
        // 0 to 12 with an overlap, a pause, and 4 s since 100; what waits isn't at work.
        assert_eq!(found.worked_s, 16.0);
        assert_eq!(State::ALL.map(|state| found.count(state)), [1, 1, 2, 0, 0]);
        let open = open_studies(&mut tx, &sweep).await.expect("reads");
        assert_eq!(open.len(), 2);
        let points = (found.points_total, found.points_done);
        assert_eq!((points, found.finished), ((None, 4), None));

        let ended = "update studies set state = 'done', points_total = 26";
        sqlx::query(ended).execute(&mut *tx).await.expect("changes");
        let found = standing(&mut tx, &sweep).await.expect("reads");
        let finished = Some("2026-01-01T00:01:44.000Z".to_owned());
        assert_eq!((found.points_total, found.finished), (Some(104), finished));
        let nobody = standing(&mut tx, "none").await.expect("reads");
        assert_eq!((nobody.worked_s, nobody.count(State::Done)), (0.0, 0));
    }
}
