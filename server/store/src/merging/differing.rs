//! Differences between a database and an attached one, for which that is refused: keys and identifiers that say something else there.

use fem_client::solver::Response;
use sqlx::SqliteConnection;

use super::parts::Taken;
use crate::points::evaluations;
use crate::store_error::StoreError;

/// Row that says something else in the other database.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Difference {
    /// Point of this key with another response, cost aside.
    Point(String),
    /// Run of this key, of a model that another program serves, with other outputs.
    ModelRun(String),
    /// Study of this identifier with another document.
    Document(String),
    /// Study of this identifier with another result.
    Result(String),
    /// Sweep of this identifier with other designs.
    Sweep(String),
}

/// Queries of keys that differ, for all that is taken.
const POINT: &str = "select o.key from other.evaluations o join main.evaluations m on m.key = o.key
     left join other.strain_fields o_fields on o_fields.key = o.key
     left join main.strain_fields m_fields on m_fields.key = o.key
     left join other.start_states o_start on o_start.key = o.key
     left join main.start_states m_start on m_start.key = o.key
     where o.scene is not m.scene or o.response is not m.response or o.failure is not m.failure
     or o_fields.lists is not m_fields.lists or o_start.state <> m_start.state
     order by o.key limit 1";
const MODEL_RUN: &str =
    "select o.key from other.model_runs o join main.model_runs m on m.key = o.key
     where o.outputs <> m.outputs order by o.key limit 1";
const DOCUMENT: &str = "select o.id from other.studies o join main.studies m on m.id = o.id
     where o.spec_sha256 <> m.spec_sha256 order by o.id limit 1";
const RESULT: &str = "select o.study from other.results o join main.results m on m.study = o.study
     where o.content_sha256 <> m.content_sha256 order by o.study limit 1";
const SWEEP: &str = "select sweep from
     (select o.sweep, o.ordinal, o.name, o.settings, o.study from other.sweep_designs o join main.sweeps m on m.id = o.sweep
      except select sweep, ordinal, name, settings, study from main.sweep_designs)
     order by sweep limit 1";

/// The first difference in what would be taken.
pub(super) async fn first(
    connection: &mut SqliteConnection,
    taken: Taken,
) -> Result<Option<Difference>, StoreError> {
    let of_points = [
        (POINT, Difference::Point as fn(String) -> Difference),
        (MODEL_RUN, Difference::ModelRun),
    ];
    let of_studies = [
        (DOCUMENT, Difference::Document as fn(String) -> Difference),
        (RESULT, Difference::Result),
        (SWEEP, Difference::Sweep),
    ];
    let points = of_points.into_iter().filter(|_| taken.has_points());
    let studies = of_studies.into_iter().filter(|_| taken != Taken::Points);
    for (query, difference) in points.chain(studies) {
        let key: Option<String> = sqlx::query_scalar(query)
            .fetch_optional(&mut *connection)
            .await?;
        if let Some(key) = key {
            return Ok(Some(difference(key)));
        }
    }
    Ok(None)
}

impl Difference {
    /// Says what differs, and of a point by how much.
    pub(super) async fn told(
        &self,
        ours: &mut SqliteConnection,
        theirs: &mut SqliteConnection,
    ) -> Result<String, StoreError> {
        Ok(match self {
            Self::Point(key) => {
                let keys = [key.clone()];
                let [here, there] = [
                    evaluations::find(ours, &keys).await?,
                    evaluations::find(theirs, &keys).await?,
                ];
                let outcome =
                    |mut found: Vec<Option<evaluations::Evaluation>>| Some(found.pop()??.outcome);
                let how = match (outcome(here), outcome(there)) {
                    (Some(Ok(here)), Some(Ok(there))) => match largest_difference(&here, &there) {
                        0.0 => "with other diagnostics, or another equilibrium to start from"
                            .to_owned(),
                        share => format!(
                            "with another response: by {share:.1e} of the largest value of its kind"
                        ),
                    },
                    _ => "with an equilibrium where there is none in the other".to_owned(),
                };
                format!(
                    "its point {key} is known here {how}; one of both was solved wrongly, or altered"
                )
            }
            Self::ModelRun(key) => format!(
                "its run {key} of a model that another program serves is known here with other outputs; the model isn't the same each time, or one of both was altered"
            ),
            Self::Document(study) => {
                format!("its study {study} is known here with another document")
            }
            Self::Result(study) => format!("its study {study} is known here with another result"),
            Self::Sweep(sweep) => format!("its sweep {sweep} is known here with other designs"),
        })
    }
}

/// Largest difference between the reactions and strains of two responses, over the largest value of its kind; infinite where they have other numbers of strains.
fn largest_difference(a: &Response, b: &Response) -> f64 {
    let kinds = |response: &Response| {
        let mut kinds = vec![vec![response.reaction_n]];
        for of in [|x: f64, _: f64| x, |_: f64, y: f64| y] {
            let of_locations = response.locations.iter();
            kinds.push(
                of_locations
                    .map(|one| of(one.strain.x, one.strain.y))
                    .collect(),
            );
        }
        for rings in &response.rings {
            kinds.extend([rings.strain.x.clone(), rings.strain.y.clone()]);
        }
        if let Some(map) = &response.map {
            kinds.extend([map.strain.x.clone(), map.strain.y.clone()]);
        }
        kinds
    };
    let (a, b) = (kinds(a), kinds(b));
    let are_alike = a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| a.len() == b.len());
    if !are_alike {
        return f64::INFINITY;
    }
    let of_kind = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        let largest = a
            .iter()
            .chain(b)
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        let apart = a
            .iter()
            .zip(b)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        if apart == 0.0 { 0.0 } else { apart / largest }
    };
    a.iter().zip(&b).map(of_kind).fold(0.0, f64::max)
}
