//! Runs a study: solves the points that the archive lacks, then analyses and ranks.

use documents::study::Study;
use documents::study::plan::Plan;
use fem_client::solver::{Cost, Readout};
use gsa::method::analysis::Status;
use results::{StudyCost, StudyResult};

use crate::points::archive::Outcome;
use crate::points::usage::Stopwatch;
use crate::points::{
    Answers, Event, Place, PointSeries, RunContext, RunError, Starts, answers_of, answers_of_all,
};
use crate::score::analyst::Stopped;
use crate::score::assemble::assemble;
use crate::score::indices::Coarse;
use crate::score::map_slopes::MapSlopes;
use crate::score::readings::ranked_values;

/// Runs a study on `threads` threads and gives its result.
///
/// A point without an equilibrium, or whose solve broke twice or took too long, costs accuracy, not the study, as long as it
/// isn't the cut point and the others give indices.
///
/// Each outcome is in the archive before it is reported, so a run that ends in any way loses no solve. The result
/// is the same to the bit, its cost aside, on any number of threads and however often the run was interrupted, unless a solve broke. Its
/// `study.id` is left empty for the caller to fill.
///
/// # Errors
/// See [`RunError`].
pub fn run(study: &Study, plan: &Plan, context: RunContext<'_>) -> Result<StudyResult, RunError> {
    run_from(0, study, plan, context).map(|ran| ran.result)
}

/// Yield of a study's own points.
pub(crate) struct Ran {
    pub result: StudyResult,
    /// Points that there were, on all meshes.
    pub points: usize,
    /// Changes over the map by each input; `None` without a map.
    pub slopes: Option<MapSlopes>,
}

/// Runs a study whose points have ordinals from `first` on.
pub(crate) fn run_from(
    first: usize,
    study: &Study,
    plan: &Plan,
    context: RunContext<'_>,
) -> Result<Ran, RunError> {
    let RunContext {
        solver, observer, ..
    } = context;
    let watch = Stopwatch::start();
    let mut plan = plan.clone();
    let coarser = solver.coarser(&study.scene);
    let meshes = 1 + usize::from(coarser.is_some());
    let readout = study.readout();
    let place = |plan: &Plan| Place {
        first,
        of: first + meshes * plan.points.len(),
    };
    let on_coarser = |plan: &Plan| coarser.map(|coarser| plan.on_level(coarser.level));
    let mut solved = 0;
    let (outcomes, costs, beside) = loop {
        // A plan that may grow is whole before its points are solved on the coarser mesh.
        let beside = on_coarser(&plan).filter(|_| !study.method.kind.is_adaptive());
        let plans = std::iter::once(&plan).chain(&beside);
        let both: Vec<_> = plans.map(|plan| series_of(plan, &readout)).collect();
        let mut answers = answers_of_all(&both, place(&plan), context)?;
        let Answers { points, reused } = answers.remove(0)?;
        solved += points.len() - reused;
        let (outcomes, costs): (Vec<Outcome>, Vec<Cost>) = points.into_iter().unzip();
        let values = ranked_values(&outcomes, study.directions);
        if !plan.extend(study, &values.view())? {
            break (outcomes, costs, answers.pop());
        }
    };
    let reused = costs.len() - solved;
    let after = Place {
        first: first + plan.points.len(),
        ..place(&plan)
    };
    let of_coarser = |plan: Plan| answers_of(series_of(&plan, &readout), after, context);
    let coarse = beside.or_else(|| on_coarser(&plan).map(of_coarser));
    let coarse = coarser.zip(coarse).map(|(coarser, answers)| {
        let outcomes = on_coarser_mesh(answers)?;
        Ok::<_, RunError>(Coarse { coarser, outcomes })
    });
    let coarse = coarse.transpose()?;
    observer(Event::Analysing);
    let coarser_outcomes = coarse.as_ref().and_then(|coarse| coarse.outcomes.as_ref());
    let cost = || {
        let mut cost = solve_cost(&costs, reused);
        cost.coarser_solves = coarser_outcomes.map_or(0, Vec::len);
        watch.add_to(&mut cost);
        cost
    };
    let version = solver.version();
    let result = assemble(
        study,
        &plan,
        &outcomes,
        coarse.as_ref(),
        &version,
        context.stop,
        cost,
    )
    .map_err(|Stopped| RunError::Stopped)?;
    if !result.failed_points.is_empty() && !has_indices(&result) {
        return Err(RunError::TooManyFailed {
            failed: result.failed_points,
        });
    }
    Ok(Ran {
        result,
        points: meshes * plan.points.len(),
        slopes: MapSlopes::of(study, plan.values(), &outcomes),
    })
}

/// The points of a plan, which start from its cut point.
fn series_of<'p>(plan: &'p Plan, readout: &'p Readout) -> PointSeries<'p> {
    PointSeries {
        scenes: &plan.points,
        starts: Starts::from_first(plan.points.len()),
        values: plan.values(),
        readout,
    }
}

/// Returns what the coarser mesh answered; nothing where a point broke or the cut point has no equilibrium there: that costs the mesh error, not the study.
fn on_coarser_mesh(answers: Result<Answers, RunError>) -> Result<Option<Vec<Outcome>>, RunError> {
    match answers {
        Ok(answers) => Ok(Some(answers.outcomes())),
        Err(RunError::PointsFailed { .. } | RunError::Refused { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}

/// Whether the points gave something: indices of some output, or that none of them varies.
fn has_indices(result: &StudyResult) -> bool {
    let indexed = result.outputs.iter().any(|o| o.first_order.is_some());
    indexed || result.outputs.iter().all(|o| o.status != Status::Unusable)
}

/// Adds up what the solves took, whenever they were made.
fn solve_cost(costs: &[Cost], reused: usize) -> StudyCost {
    let sum = |part: fn(&Cost) -> f64| costs.iter().map(part).sum::<f64>();
    let wall = sum(|cost| cost.wall_s);
    let share = |part: f64| {
        if wall > 0.0 {
            (part / wall).clamp(0.0, 1.0)
        } else {
            0.0
        }
    };
    let factorisation = share(sum(|cost| cost.factorisation_s));
    let substitution = share(sum(|cost| cost.substitution_s));
    let assembly = share(sum(|cost| cost.assembly_s));
    StudyCost {
        solves: costs.len(),
        reused,
        newton_iterations: costs.iter().map(|cost| cost.newton_iterations).sum(),
        factorisations: costs.iter().map(|cost| cost.factorisations).sum(),
        factorisation_share: factorisation,
        substitution_share: substitution,
        assembly_share: assembly,
        other_share: if wall > 0.0 {
            (1.0 - factorisation - substitution - assembly).max(0.0)
        } else {
            0.0
        },
        ..StudyCost::default()
    }
}
