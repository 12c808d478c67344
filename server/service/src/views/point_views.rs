//! The points of a study as a reader sees them: inputs beside what came of them.

use documents::study::Input;
use fem_client::scene::edit::number_in;
use fem_client::solver::LocationStrain;
use serde::Deserialize;
use serde_json::Value;
use sqlx::SqliteConnection;

use crate::study_document::stored_study;
use crate::wire::study_wire::EvaluationView;
use store::StoreError;
use store::points::evaluations::{self, Evaluation};
use store::queue::study_rows::StudyRow;

/// Part of a response that is shown.
#[derive(Deserialize)]
struct Shown {
    reaction_n: f64,
    depth_mm: f64,
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

/// Returns what varies in a study; nothing if this version can't read its document.
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
        depth_mm: response.as_ref().map(|response| response.depth_mm),
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
