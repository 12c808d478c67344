//! Effects of what the model of a study leaves out, measured: each omission's richer scene is solved once, at the means.
//!
//! An effect is the difference of two models on one mesh, and the mesh's own error cancels in it to a good part: those of the coarse
//! level are within a tenth of the standard's on the reference tire. The draft's aren't: friction has 3.5 times its true effect
//! there, so that a draft states none.

use fem_client::scene::{Level, Scene};
use fem_client::solver::direction::PerDirection;
use fem_client::solver::{Choice, Omission, Response};

use crate::points::Place;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::archive::Outcome;
use crate::points::{PointSeries, Starts, outcomes_of};
use crate::score::quantity::at_locations;
use documents::study::Study;
use documents::study::plan::Plan;
use results::StudyResult;

/// Fills in the effects of what a result's model leaves out. The points have ordinals from `first` on.
///
/// # Errors
/// See [`RunError`]; the result is unchanged then.
pub(crate) fn measure(
    first: usize,
    study: &Study,
    plan: &Plan,
    result: &mut StudyResult,
    context: RunContext<'_>,
) -> Result<(), RunError> {
    if result.model.level == Level::Draft.as_str() {
        return Ok(());
    }
    let mut plain = plan.points[0].clone();
    plain.model.level = Level::Coarse;
    let richer: Vec<(Omission, Scene)> = context
        .solver
        .omissions(&plain)
        .into_iter()
        .filter_map(|omission| {
            let scene = omission.richer.clone()?;
            Some((omission, scene))
        })
        .collect();
    if richer.is_empty() {
        return Ok(());
    }
    let scenes: Vec<Scene> = std::iter::once(plain)
        .chain(richer.iter().map(|(_, scene)| scene.clone()))
        .collect();
    let values = vec![plan.values()[0].clone(); scenes.len()];
    let place = Place {
        first,
        of: first + scenes.len(),
    };
    let series = PointSeries {
        scenes: &scenes,
        starts: Starts::from_first(scenes.len()),
        values: &values,
        readout: &study.readout(),
    };
    let outcomes = match outcomes_of(series, place, context) {
        Ok(outcomes) => outcomes,
        // Without the coarse mesh there is nothing to compare with: that costs the effects, not the study.
        Err(RunError::PointsFailed { .. } | RunError::Refused { .. }) => return Ok(()),
        Err(error) => return Err(error),
    };
    result.cost.effect_solves = outcomes.len();
    if let Some((Ok(plain), others)) = outcomes.split_first() {
        for ((omission, _), outcome) in richer.iter().zip(others) {
            let left_out = result.model.left_out.iter_mut();
            for choice in left_out.filter(|choice| choice.what == omission.what) {
                state(choice, plain, outcome);
            }
        }
    }
    Ok(())
}

/// Says what leaving it out does.
fn state(choice: &mut Choice, plain: &Response, richer: &Outcome) {
    match richer {
        Ok(richer) => choice.effect = effect(plain, richer),
        Err(unsolved) => choice
            .why
            .push_str(&format!(". With it there is no equilibrium: {unsolved}")),
    }
}

/// Largest change of a strain at P1, P2, ..., over the largest one of its direction; `None` where there is no strain at all.
pub fn effect(plain: &Response, richer: &Response) -> Option<f64> {
    let of_direction = |direction| {
        let strains =
            |response| -> Vec<f64> { at_locations(response).map(|s| s[direction]).collect() };
        let (plain, richer) = (strains(plain), strains(richer));
        let largest = plain
            .iter()
            .fold(0.0f64, |max, strain| max.max(strain.abs()));
        let changes = plain.iter().zip(&richer).map(|(a, b)| (a - b).abs());
        let change = changes.fold(0.0, f64::max);
        (largest > 0.0).then(|| change / largest)
    };
    let effects = PerDirection::of(of_direction);
    effects.into_iter().flatten().reduce(f64::max)
}
