//! Evaluated points and start states, kept by content key, written once, checked when read.

use std::collections::HashSet;

use document::Format;
use fem_client::scene::Scene;
use fem_client::solver::{Cost, Response, StartState};
use placement::estimate::Sample;
use placement::points::archive::PointRecord;
use results::Unsolved;
use serde::de::DeserializeOwned;
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::column::counted;
use crate::content::{encode, sha256};
use crate::points::{strain_fields, study_points};
use crate::row::from_row;
use crate::store_error::StoreError;

/// A point as it was stored; of its response all, or the part `R`.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluation<R = Response> {
    /// Canonical scene, JSON.
    pub scene: String,
    /// Strains, forces, diagnostics; or why there is no equilibrium.
    pub outcome: Result<R, Unsolved>,
    /// Cost of the solve.
    pub cost: Cost,
}

struct EvaluationRow {
    key: String,
    scene: String,
    response: String,
    failure: Option<String>,
    cost: String,
    sha256: String,
}

from_row!(EvaluationRow {
    key,
    scene,
    response,
    failure,
    cost,
    sha256
});

/// An evaluation with its strain fields, in answer to the key at a place of a list.
struct WholeRow {
    place: i64,
    row: EvaluationRow,
    lists: Option<Vec<u8>>,
    lists_sha256: Option<String>,
}

from_row!(WholeRow { place, lists, lists_sha256; row });

impl WholeRow {
    fn read(self) -> Result<Evaluation, StoreError> {
        let key = self.row.key.clone();
        let mut evaluation: Evaluation = self.row.read()?;
        if let Ok(response) = &mut evaluation.outcome {
            strain_fields::restore(&key, response, self.lists.zip(self.lists_sha256))?;
        }
        Ok(evaluation)
    }
}

/// An evaluation as a point of a study.
struct PointRow {
    ordinal: i64,
    link_sha256: String,
    row: EvaluationRow,
}

from_row!(PointRow { ordinal, link_sha256; row });

impl EvaluationRow {
    /// The row, and the strain fields that are kept beside it.
    fn of(point: &PointRecord<'_>) -> Result<(Self, Option<Vec<u8>>), StoreError> {
        let (mut response, mut failure, mut fields) = ("null".to_owned(), None, None);
        match point.outcome {
            Ok(solved) => {
                let mut solved = solved.clone();
                fields = strain_fields::take(&mut solved)?;
                response = encode("the response of a point", &solved)?;
            }
            Err(unsolved) => failure = Some(encode("the failure of a point", unsolved)?),
        }
        let mut row = Self {
            key: point.key.to_owned(),
            scene: point.scene.to_owned(),
            response,
            failure,
            cost: encode("the cost of a point", &point.cost)?,
            sha256: String::new(),
        };
        row.sha256 = row.content_sha256();
        Ok((row, fields))
    }

    /// Hashes all other columns that aren't null.
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
    let (row, fields) = EvaluationRow::of(point)?;
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
    if let Some(fields) = fields {
        strain_fields::insert(connection, point.key, &fields).await?;
    }
    if let Some(start) = point.start {
        insert_start(connection, point.key, start).await?;
    }
    study_points::link(connection, study, point.ordinal, &[point.key.to_owned()]).await?;
    Ok(())
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

/// The evaluations under these keys, in their order.
///
/// # Errors
/// [`StoreError::Damaged`] when a row doesn't match its hash; when the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    keys: &[String],
) -> Result<Vec<Option<Evaluation>>, StoreError> {
    let query = "select wanted.key as place, e.key, e.scene, e.response, e.failure, e.cost, e.sha256, f.lists, f.sha256 as lists_sha256
                 from json_each(?) wanted join evaluations e on e.key = wanted.value left join strain_fields f on f.key = e.key";
    let mut found: Vec<Option<Evaluation>> = keys.iter().map(|_| None).collect();
    // So many at a time that the rows take little memory beside what is read from them.
    for (chunk, places) in keys.chunks(AT_ONCE).zip(found.chunks_mut(AT_ONCE)) {
        let rows: Vec<WholeRow> = sqlx::query_as(query)
            .bind(serde_json::json!(chunk).to_string())
            .fetch_all(&mut *connection)
            .await?;
        for row in rows {
            let place = counted(row.place);
            if let Some(place) = place.and_then(|place| places.get_mut(place)) {
                *place = Some(row.read()?);
            }
        }
    }
    Ok(found)
}

/// Rows read at once.
const AT_ONCE: usize = 256;

/// The points of a study that have an evaluation, in order: ordinal, key, and the evaluation with a part `R` of its response,
/// which can't be of its strain fields.
///
/// # Errors
/// As for [`find`].
pub async fn parts_of<R: DeserializeOwned>(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Vec<(usize, String, Evaluation<R>)>, StoreError> {
    let query = "select p.ordinal, p.sha256 as link_sha256, e.key, e.scene, e.response, e.failure, e.cost, e.sha256
                 from study_points p join evaluations e on e.key = p.evaluation
                 where p.study = ? order by p.ordinal";
    let found = parts(connection, query, study).await?;
    match study_points::short(connection, Some(study))
        .await?
        .is_empty()
    {
        true => Ok(found),
        false => Err(study_points::lost(study)),
    }
}

/// Finds those points alone from whose equilibrium others start.
///
/// # Errors
/// As for [`find`].
pub async fn cut_points_of<R: DeserializeOwned>(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Vec<(usize, String, Evaluation<R>)>, StoreError> {
    let query = "select p.ordinal, p.sha256 as link_sha256, e.key, e.scene, e.response, e.failure, e.cost, e.sha256
                 from study_points p join evaluations e on e.key = p.evaluation join start_states s on s.key = e.key
                 where p.study = ? order by p.ordinal";
    parts(connection, query, study).await
}

async fn parts<R: DeserializeOwned>(
    connection: &mut SqliteConnection,
    query: &'static str,
    study: &str,
) -> Result<Vec<(usize, String, Evaluation<R>)>, StoreError> {
    let rows: Vec<PointRow> = sqlx::query_as(query)
        .bind(study)
        .fetch_all(connection)
        .await?;
    let part = |point: PointRow| {
        let key = point.row.key.clone();
        let ordinal = study_points::checked(study, point.ordinal, &key, &point.link_sha256)?;
        Ok((ordinal, key, point.row.read()?))
    };
    rows.into_iter().map(part).collect()
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

/// Returns those of these keys that have an evaluation.
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

/// The newest solves with their times: the newest cut points, and the newest of all others. What can't be read is left out, and what strains around the wheel
/// were read of: their meshes are finer than their scenes say.
///
/// # Errors
/// When the database can't be read.
pub async fn samples(connection: &mut SqliteConnection) -> Result<Vec<Sample>, StoreError> {
    let query = "select * from (select e.scene, e.cost, 1 from start_states s join evaluations e on e.key = s.key
                                where coalesce(json_array_length(e.response, '$.rings'), 0) = 0
                                order by s.rowid desc limit 20)
                 union all
                 select * from (select e.scene, e.cost, 0 from evaluations e
                                where e.failure is null and coalesce(json_array_length(e.response, '$.rings'), 0) = 0
                                and not exists (select 1 from start_states s where s.key = e.key)
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

#[cfg(test)]
mod tests;
