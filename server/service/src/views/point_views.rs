//! The points of a study as a reader sees them: inputs beside what came of them.

use fem_client::scene::edit::number_in;
use fem_client::solver::{LocationStrain, Reached};
use placement::study::Input;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use sqlx::SqliteConnection;
use utoipa::ToSchema;

use crate::study_document::stored_study;
use store::StoreError;
use store::points::evaluations::{self, Evaluation};
use store::queue::study_rows::StudyRow;

/// One point that has an outcome.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EvaluationView {
    /// Its place.
    pub ordinal: usize,
    /// Hash of all that determines its outcome.
    pub key: String,
    /// Mesh level.
    pub level: Option<String>,
    /// The inputs' values; null when its scene hasn't one of them.
    pub values: Option<Vec<f64>>,
    /// Vertical force, N; null without an equilibrium.
    pub reaction_n: Option<f64>,
    /// How far the ground at the contact centre stands above the inflated outer radius, mm; absent without an equilibrium.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub depth_mm: Option<f64>,
    /// Strains at P1, P2, ...; null without an equilibrium.
    pub locations: Option<Vec<LocationStrain>>,
    /// Newton iterations; null without an equilibrium.
    pub newton_iterations: Option<usize>,
    /// Wall-clock time of the solve, s.
    pub wall_s: f64,
    /// Why there is no equilibrium.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
    /// Loads of the last equilibrium before.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reached: Option<Reached>,
}

/// What is shown of a response.
#[derive(Deserialize)]
struct Shown {
    reaction_n: f64,
    #[serde(default)]
    depth_mm: Option<f64>,
    locations: Vec<LocationStrain>,
}

/// The points of a study that have an outcome so far, in the order of the plan.
///
/// # Errors
/// [`StoreError::Damaged`] when a row doesn't match its hash; when the database can't be read.
pub async fn of(
    connection: &mut SqliteConnection,
    study: &StudyRow,
) -> Result<Vec<EvaluationView>, StoreError> {
    let inputs = inputs_of(study);
    let parts = evaluations::parts_of(connection, &study.id).await?;
    Ok(parts
        .into_iter()
        .map(|(ordinal, key, evaluation)| view(ordinal, key, evaluation, &inputs))
        .collect())
}

/// What varies in a study; nothing if this version can't read its document.
fn inputs_of(study: &StudyRow) -> Vec<Input> {
    let read = stored_study(study).map(|study| study.inputs);
    read.unwrap_or_default()
}

fn view(
    ordinal: usize,
    key: String,
    evaluation: Evaluation<Shown>,
    inputs: &[Input],
) -> EvaluationView {
    let scene: Option<Value> = serde_json::from_str(&evaluation.scene).ok();
    let level = |scene: &Value| Some(scene.pointer("/model/level")?.as_str()?.to_owned());
    let solved = evaluation.outcome.is_ok();
    let (response, unsolved) = match evaluation.outcome {
        Ok(response) => (Some(response), None),
        Err(unsolved) => (None, Some(unsolved)),
    };
    EvaluationView {
        ordinal,
        key,
        level: scene.as_ref().and_then(level),
        values: scene.as_ref().and_then(|scene| values_of(scene, inputs)),
        reaction_n: response.as_ref().map(|response| response.reaction_n),
        depth_mm: response.as_ref().and_then(|response| response.depth_mm),
        locations: response.map(|response| response.locations),
        newton_iterations: solved.then_some(evaluation.cost.newton_iterations),
        wall_s: evaluation.cost.wall_s,
        reason: unsolved.as_ref().map(ToString::to_string),
        reached: unsolved.map(|unsolved| unsolved.reached),
    }
}

/// The inputs' values in a stored scene; none if it hasn't one of them.
fn values_of(scene: &Value, inputs: &[Input]) -> Option<Vec<f64>> {
    let value = |input: &Input| number_in(scene, &input.vary);
    inputs.iter().map(value).collect()
}
