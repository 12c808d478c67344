//! Plan and responses to the answer of a study.

use fem_client::solver::{ModelSummary, Response};

use crate::layout::rank_layouts;
use crate::notes::notes;
use crate::plan::Plan;
use crate::rank::rank;
use crate::result::{CutPoint, InputReport, StudyCost, StudyIdentity, StudyResult};
use crate::score::score;
use crate::study::Study;

/// The answer, without its cost and the study's identifier.
///
/// # Panics
/// If there is not one response for each point of the plan.
pub fn assemble(
    study: &Study,
    plan: &Plan,
    responses: &[Response],
    solver_version: &str,
) -> StudyResult {
    let scores = score(plan.campaign(), responses);
    let locations = rank(study, &scores);
    let layouts = rank_layouts(study, plan.campaign(), responses);
    let cut = &responses[0];
    let notes = notes(study, plan, cut, &scores, &locations, &layouts);
    StudyResult {
        study: StudyIdentity {
            id: String::new(),
            name: study.name.clone(),
            spec_sha256: study.spec_sha256(),
            version: format!(
                "strainsite {}, solver {solver_version}",
                env!("CARGO_PKG_VERSION")
            ),
        },
        model: largest_model(responses),
        inputs: study.inputs.iter().map(input_report).collect(),
        outputs: scores.outputs,
        locations,
        layouts,
        map: scores.map,
        notes,
        failed_points: Vec::new(),
        cut_point: CutPoint {
            values: plan.values()[0].clone(),
            reaction_n: cut.reaction_n,
            inflated_outer_radius_mm: cut.inflated.outer_radius_mm,
            locations: cut.locations.clone(),
            residual_history: cut.residual_history.clone(),
        },
        cost: StudyCost::default(),
    }
}

/// The largest model that any point needed: symmetric points are solved on less. The first of equals, so that it doesn't
/// depend on later points.
fn largest_model(responses: &[Response]) -> ModelSummary {
    let largest = responses
        .iter()
        .rev()
        .max_by_key(|response| response.model.dofs);
    largest
        .map(|response| response.model.clone())
        .unwrap_or_default()
}

fn input_report(input: &crate::study::Input) -> InputReport {
    InputReport {
        name: input.name.clone(),
        vary: input.vary.clone(),
        distribution: input.distribution_value(),
    }
}
