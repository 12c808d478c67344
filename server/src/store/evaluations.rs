//! Evaluated points and start states, kept by content key, written once, checked when read.

use std::collections::HashSet;

use fem_client::document::Format;
use fem_client::scene::Scene;
use fem_client::solver::{Cost, Response, StartState};
use placement::archive::{PointRecord, Unsolved};
use placement::estimate::Sample;
use serde::de::DeserializeOwned;
use sqlx::{FromRow, SqliteConnection};

use super::content::{encode, sha256};
use super::{StoreError, now};

/// A point as it was stored; of its response all, or the part `R`.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluation<R = Response> {
    /// Canonical scene, JSON.
    pub scene: String,
    /// Strains, forces, diagnostics; or why there is no equilibrium.
    pub outcome: Result<R, Unsolved>,
    /// What the solve took.
    pub cost: Cost,
}

#[derive(FromRow)]
struct EvaluationRow {
    key: String,
    scene: String,
    response: String,
    failure: Option<String>,
    cost: String,
    sha256: String,
}

impl EvaluationRow {
    fn of(point: &PointRecord<'_>) -> Result<Self, StoreError> {
        let (response, failure) = match point.outcome {
            Ok(response) => (encode("the response of a point", response)?, None),
            Err(unsolved) => (
                "null".to_owned(),
                Some(encode("the failure of a point", unsolved)?),
            ),
        };
        let mut row = Self {
            key: point.key.to_owned(),
            scene: point.scene.to_owned(),
            response,
            failure,
            cost: encode("the cost of a point", &point.cost)?,
            sha256: String::new(),
        };
        row.sha256 = row.content_sha256();
        Ok(row)
    }

    /// Of all other columns; a response alone has the hash that it had before there were failures.
    fn content_sha256(&self) -> String {
        let columns = [&self.key, &self.scene, &self.response, &self.cost];
        let columns = columns.into_iter().chain(&self.failure);
        let parts: Vec<&[u8]> = columns.map(|text| text.as_bytes()).collect();
        sha256(&parts)
    }

    fn read<R: DeserializeOwned>(self) -> Result<Evaluation<R>, StoreError> {
        let damaged = || StoreError::Damaged {
            table: "evaluations",
            row: self.key.clone(),
        };
        if self.content_sha256() != self.sha256 {
            return Err(damaged());
        }
        let outcome = match &self.failure {
            None => Ok(serde_json::from_str(&self.response).map_err(|_| damaged())?),
            Some(failure) => Err(serde_json::from_str(failure).map_err(|_| damaged())?),
        };
        let cost = serde_json::from_str(&self.cost).map_err(|_| damaged())?;
        Ok(Evaluation {
            scene: self.scene,
            outcome,
            cost,
        })
    }
}

/// Stores a point's outcome, its start state, and that it answers for its ordinal of the study. What is there already
/// stays as it is.
///
/// # Errors
/// [`StoreError::NotFinite`] when the outcome holds NaN or infinity; when the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    point: &PointRecord<'_>,
) -> Result<(), StoreError> {
    let row = EvaluationRow::of(point)?;
    sqlx::query(
        "insert into evaluations (key, scene, response, failure, cost, sha256, created) values (?, ?, ?, ?, ?, ?, ?)
         on conflict do nothing",
    )
    .bind(&row.key)
    .bind(&row.scene)
    .bind(&row.response)
    .bind(&row.failure)
    .bind(&row.cost)
    .bind(&row.sha256)
    .bind(now())
    .execute(&mut *connection)
    .await?;
    if let Some(start) = point.start {
        insert_start(connection, point.key, start).await?;
    }
    link(connection, study, point.ordinal, point.key).await
}

/// Notes that an evaluation answers for an ordinal of a study.
///
/// # Errors
/// When there is no such evaluation or study, or the database can't be written.
pub async fn link(
    connection: &mut SqliteConnection,
    study: &str,
    ordinal: usize,
    key: &str,
) -> Result<(), StoreError> {
    sqlx::query("insert into study_points (study, ordinal, evaluation) values (?, ?, ?) on conflict do nothing")
        .bind(study)
        .bind(i64::try_from(ordinal).unwrap_or(i64::MAX))
        .bind(key)
        .execute(connection)
        .await?;
    Ok(())
}

/// Whether an ordinal of a study has its evaluation.
///
/// # Errors
/// When the database can't be read.
pub async fn linked(
    connection: &mut SqliteConnection,
    study: &str,
    ordinal: usize,
) -> Result<bool, StoreError> {
    let found: Option<i64> =
        sqlx::query_scalar("select 1 from study_points where study = ? and ordinal = ?")
            .bind(study)
            .bind(i64::try_from(ordinal).unwrap_or(i64::MAX))
            .fetch_optional(connection)
            .await?;
    Ok(found.is_some())
}

async fn insert_start(
    connection: &mut SqliteConnection,
    key: &str,
    start: &StartState,
) -> Result<(), StoreError> {
    let state = start.to_bytes();
    sqlx::query(
        "insert into start_states (key, state, sha256) values (?, ?, ?) on conflict do nothing",
    )
    .bind(key)
    .bind(&state)
    .bind(sha256(&[key.as_bytes(), &state]))
    .execute(connection)
    .await?;
    Ok(())
}

/// The evaluation under this key.
///
/// # Errors
/// [`StoreError::Damaged`] when the row doesn't match its hash; when the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    key: &str,
) -> Result<Option<Evaluation>, StoreError> {
    find_part(connection, key).await
}

/// The evaluation under this key with a part of its response: the rest, rings and map, takes as long to read as all else.
///
/// # Errors
/// As for [`find`].
pub async fn find_part<R: DeserializeOwned>(
    connection: &mut SqliteConnection,
    key: &str,
) -> Result<Option<Evaluation<R>>, StoreError> {
    let query = "select key, scene, response, failure, cost, sha256 from evaluations where key = ?";
    let row: Option<EvaluationRow> = sqlx::query_as(query)
        .bind(key)
        .fetch_optional(connection)
        .await?;
    row.map(EvaluationRow::read).transpose()
}

/// The start state under this key.
///
/// # Errors
/// As for [`find`].
pub async fn find_start(
    connection: &mut SqliteConnection,
    key: &str,
) -> Result<Option<StartState>, StoreError> {
    let row: Option<(Vec<u8>, String)> =
        sqlx::query_as("select state, sha256 from start_states where key = ?")
            .bind(key)
            .fetch_optional(connection)
            .await?;
    let Some((state, stored)) = row else {
        return Ok(None);
    };
    let damaged = || StoreError::Damaged {
        table: "start_states",
        row: key.to_owned(),
    };
    if sha256(&[key.as_bytes(), &state]) != stored {
        return Err(damaged());
    }
    StartState::from_bytes(&state)
        .map(Some)
        .map_err(|_| damaged())
}

/// Which of these keys have an evaluation.
///
/// # Errors
/// When the database can't be read.
pub async fn known(
    connection: &mut SqliteConnection,
    keys: &[&str],
) -> Result<HashSet<String>, StoreError> {
    let query = "select key from evaluations where key in (select value from json_each(?))";
    let known: Vec<String> = sqlx::query_scalar(query)
        .bind(serde_json::json!(keys).to_string())
        .fetch_all(connection)
        .await?;
    Ok(known.into_iter().collect())
}

/// The newest solves with their times: the newest cut points, and the newest of all others. What can't be read is left out.
///
/// # Errors
/// When the database can't be read.
pub async fn samples(connection: &mut SqliteConnection) -> Result<Vec<Sample>, StoreError> {
    let query = "select * from (select e.scene, e.cost, 1 from start_states s join evaluations e on e.key = s.key
                                order by s.rowid desc limit 20)
                 union all
                 select * from (select e.scene, e.cost, 0 from evaluations e
                                where e.failure is null and not exists (select 1 from start_states s where s.key = e.key)
                                order by e.rowid desc limit 200)";
    let rows: Vec<(String, String, bool)> = sqlx::query_as(query).fetch_all(connection).await?;
    let sample = |(scene, cost, cut): (String, String, bool)| {
        let cost: Cost = serde_json::from_str(&cost).ok()?;
        Some(Sample {
            scene: Scene::from_text(&scene, Format::Json).ok()?,
            wall_s: cost.wall_s,
            cut,
        })
    };
    Ok(rows.into_iter().filter_map(sample).collect())
}

/// The ordinals of a study that have an evaluation, with its key, in order.
///
/// # Errors
/// When the database can't be read.
pub async fn points_of(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Vec<(usize, String)>, StoreError> {
    let rows: Vec<(i64, String)> = sqlx::query_as(
        "select ordinal, evaluation from study_points where study = ? order by ordinal",
    )
    .bind(study)
    .fetch_all(connection)
    .await?;
    Ok(rows
        .into_iter()
        .filter_map(|(ordinal, key)| Some((usize::try_from(ordinal).ok()?, key)))
        .collect())
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use fem_client::closed_form::ClosedFormSolver;
    use fem_client::scene::Scene;
    use fem_client::solver::{NoEquilibrium, Reached, Readout, Response, SolveRequest, Solver};
    use placement::archive::Unsolved;

    use placement::archive::Outcome;

    use super::*;
    use crate::store::studies;
    use crate::store::tests::fresh;

    fn solved() -> (Outcome, Cost, StartState) {
        let (scene, stop) = (Scene::default(), AtomicBool::new(false));
        let readout = Readout::default();
        let request = SolveRequest {
            scene: &scene,
            readout: &readout,
            start: None,
            stop: &stop,
        };
        let solved = ClosedFormSolver::new().solve(&request).expect("solves");
        (Ok(solved.response), solved.cost, solved.state)
    }

    fn response(outcome: &mut Outcome) -> &mut Response {
        outcome.as_mut().expect("a response")
    }

    fn record((outcome, cost, state): &(Outcome, Cost, StartState)) -> PointRecord<'_> {
        PointRecord {
            key: "k",
            ordinal: 3,
            scene: "{}",
            outcome,
            cost: *cost,
            start: outcome.is_ok().then_some(state),
        }
    }

    #[tokio::test]
    async fn a_point_reads_back_bit_for_bit_and_is_written_once() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        let study = studies::insert(&mut tx, "a", "{}", "x")
            .await
            .expect("inserts");
        let first = solved();
        insert(&mut tx, &study, &record(&first))
            .await
            .expect("stores");
        let mut other = first.clone();
        response(&mut other.0).reaction_n += 1.0;
        insert(&mut tx, &study, &record(&other))
            .await
            .expect("is no error");

        let stored = find(&mut tx, "k").await.expect("reads").expect("is there");
        assert_eq!((&stored.outcome, stored.cost), (&first.0, first.1));
        assert_eq!(
            find_start(&mut tx, "k").await.expect("reads"),
            Some(first.2)
        );
        assert_eq!(
            points_of(&mut tx, &study).await.expect("reads"),
            [(3, "k".to_owned())]
        );
        assert!(linked(&mut tx, &study, 3).await.expect("reads"));
        assert!(!linked(&mut tx, &study, 4).await.expect("reads"));
        assert_eq!(find(&mut tx, "absent").await.expect("reads"), None);
    }

    #[tokio::test]
    async fn a_point_without_equilibrium_is_an_answer_like_any_other() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        let study = studies::insert(&mut tx, "a", "{}", "x")
            .await
            .expect("inserts");
        let unsolved = Unsolved {
            status: NoEquilibrium::Crushed,
            detail: "squeezed to 0.31 at 70.1 %".to_owned(),
            reached: Reached {
                pressure_mpa: 0.2,
                depths_mm: vec![0.1 + 0.2; 5],
            },
        };
        let (_, cost, state) = solved();
        let failed = (Err(unsolved), cost, state);
        insert(&mut tx, &study, &record(&failed))
            .await
            .expect("stores");
        let stored = find(&mut tx, "k").await.expect("reads").expect("is there");
        assert_eq!((stored.outcome, stored.cost), (failed.0, cost));
        assert!(linked(&mut tx, &study, 3).await.expect("reads"));
        assert_eq!(find_start(&mut tx, "k").await.expect("reads"), None);
        sqlx::query("update evaluations set failure = replace(failure, '70.1', '70.2')")
            .execute(&mut *tx)
            .await
            .expect("damages");
        assert!(matches!(
            find(&mut tx, "k").await,
            Err(StoreError::Damaged { .. })
        ));
    }

    #[tokio::test]
    async fn a_number_that_is_not_finite_is_not_stored() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        let study = studies::insert(&mut tx, "a", "{}", "x")
            .await
            .expect("inserts");
        let mut wrong = solved();
        response(&mut wrong.0).locations[2].strain_x = f64::NAN;
        let refused = insert(&mut tx, &study, &record(&wrong)).await;
        assert!(matches!(refused, Err(StoreError::NotFinite { .. })));
        assert_eq!(find(&mut tx, "k").await.expect("reads"), None);
    }

    #[tokio::test]
    async fn a_lost_or_changed_byte_is_found() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        let study = studies::insert(&mut tx, "a", "{}", "x")
            .await
            .expect("inserts");
        let solved = solved();
        insert(&mut tx, &study, &record(&solved))
            .await
            .expect("stores");
        sqlx::query("update start_states set state = substr(state, 1, length(state) - 1)")
            .execute(&mut *tx)
            .await
            .expect("damages");
        let damaged = find_start(&mut tx, "k").await;
        assert!(matches!(
            damaged,
            Err(StoreError::Damaged {
                table: "start_states",
                ..
            })
        ));
        sqlx::query("update evaluations set cost = replace(cost, 'wall_s', 'wall_t')")
            .execute(&mut *tx)
            .await
            .expect("damages");
        assert!(matches!(
            find(&mut tx, "k").await,
            Err(StoreError::Damaged {
                table: "evaluations",
                ..
            })
        ));
    }
}
