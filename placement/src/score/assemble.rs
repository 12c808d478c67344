//! Plan and outcomes to the answer of a study.

use std::sync::atomic::AtomicBool;

use fem_client::solver::ModelSummary;

use crate::points::archive::Outcome;
use crate::score::analyst::Stopped;
use crate::score::indices::{Coarse, score};
use crate::score::notes::notes;
use crate::score::rank::rank;
use documents::parts::distribution_reader::distribution_value;
use documents::study::Study;
use documents::study::plan::Plan;
use results::{CutPoint, FailedPoint, InputReport, StudyCost, StudyIdentity, StudyResult};

/// The answer, without the study's identifier, which the database gives it. What it cost is asked for at the end.
///
/// # Errors
/// When `stop` is set meanwhile.
///
/// # Panics
/// If there is not one outcome for each point of the plan, or the cut point has no response.
pub fn assemble(
    study: &Study,
    plan: &Plan,
    outcomes: &[Outcome],
    coarse: Option<&Coarse>,
    solver_version: &str,
    stop: &AtomicBool,
    cost: impl FnOnce() -> StudyCost,
) -> Result<StudyResult, Stopped> {
    let cut = outcomes[0]
        .as_ref()
        .expect("without the cut point's response nothing is assembled");
    let failed_points = failed_points(plan, outcomes);
    let scores = score(study, plan.campaign(), cut, outcomes, coarse, stop)?;
    let locations = rank(study, &scores);
    let graded_notes = notes(study, plan, cut, &scores, &locations, &failed_points);
    Ok(StudyResult {
        study: StudyIdentity {
            id: String::new(),
            name: study.name.clone(),
            spec_sha256: study.spec_sha256(),
            version: version(solver_version),
        },
        answer: None,
        model: largest_model(outcomes),
        inputs: study.inputs.iter().map(input_report).collect(),
        outputs: scores.outputs().cloned().collect(),
        locations,
        layouts: Vec::new(),
        layout_findings: None,
        map: scores.map,
        signals: None,
        forces: None,
        notes: graded_notes.iter().map(|note| note.text.clone()).collect(),
        graded_notes,
        failed_points,
        cut_point: CutPoint {
            values: plan.values()[0].clone(),
            reaction_n: cut.reaction_n,
            depth_mm: cut.depth_mm,
            inflated_outer_radius_mm: cut.inflated.outer_radius_mm,
            locations: cut.locations.clone(),
            residual_history: cut.residual_history.clone(),
        },
        climb: None,
        cost: cost(),
        estimate: None,
    })
}

/// Returns a result's version with this solver: equal ones give equal results of equal documents.
pub fn version(solver_version: &str) -> String {
    format!(
        "strainsite {}+{}, solver {solver_version}",
        env!("CARGO_PKG_VERSION"),
        env!("ANALYSIS_SOURCES")
    )
}

/// The points without an equilibrium, in the order of the plan.
pub(crate) fn failed_points(plan: &Plan, outcomes: &[Outcome]) -> Vec<FailedPoint> {
    let failed = |(ordinal, outcome): (usize, &Outcome)| {
        let unsolved = outcome.as_ref().err()?;
        Some(FailedPoint {
            ordinal,
            values: plan.values()[ordinal].clone(),
            cause: unsolved.into(),
        })
    };
    outcomes.iter().enumerate().filter_map(failed).collect()
}

/// The largest model that any point needed: symmetric points are solved on less. The first of equals, so that it doesn't
/// depend on later points.
fn largest_model(outcomes: &[Outcome]) -> ModelSummary {
    let largest = outcomes
        .iter()
        .flatten()
        .rev()
        .max_by_key(|response| response.model.dofs);
    largest
        .map(|response| response.model.clone())
        .unwrap_or_default()
}

fn input_report(input: &documents::study::Input) -> InputReport {
    InputReport {
        name: input.name.clone(),
        vary: input.vary.clone(),
        distribution: distribution_value(&input.distribution),
    }
}
