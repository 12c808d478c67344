//! Scenes that are no points of the plan, solved at the inputs' means.

use fem_client::scene::Scene;
use fem_client::solver::Readout;

use super::planned_points::{Answers, Place};
use super::series_group::{PointSeries, SceneSeries, answers_of_all};
use crate::points::archive::Outcome;
use crate::points::run_context::RunContext;
use crate::points::run_error::RunError;

/// Solves these scenes from the first one, or says why nothing came of them; the place moves behind their points.
///
/// # Errors
/// See [`RunError`].
pub(crate) fn outcomes(
    scenes: &[Scene],
    readout: &Readout,
    means: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Result<Vec<Outcome>, String>, RunError> {
    let series = SceneSeries::from_first(scenes.to_vec(), readout.clone());
    let mut found = outcomes_of_all(&[series], means, place, context)?;
    Ok(found.remove(0))
}

/// Solves several series of scenes at once; of the first alone, where nothing came of it. The place moves behind their points.
///
/// # Errors
/// See [`RunError`].
pub(crate) fn outcomes_of_all(
    all: &[SceneSeries],
    means: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Vec<Result<Vec<Outcome>, String>>, RunError> {
    let values = |series: &SceneSeries| vec![means.to_vec(); series.scenes.len()];
    let values: Vec<Vec<Vec<f64>>> = all.iter().map(values).collect();
    let series = all.iter().zip(&values);
    let series = series.map(|(series, values)| PointSeries {
        scenes: &series.scenes,
        starts: series.starts.clone(),
        values,
        readout: &series.readout,
    });
    let answers = answers_of_all(&series.collect::<Vec<_>>(), *place, context)?;
    place.first += values.iter().map(Vec::len).sum::<usize>();
    let outcomes = |answers: Result<Answers, RunError>| match answers {
        Ok(answers) => Ok(Ok(answers.outcomes())),
        Err(error @ (RunError::PointsFailed { .. } | RunError::Refused { .. })) => {
            Ok(Err(error.to_string()))
        }
        Err(error) => Err(error),
    };
    answers.into_iter().map(outcomes).collect()
}
