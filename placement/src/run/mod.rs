//! Runs a study: solves the points that the archive lacks, then analyses and ranks.

pub mod archive;
mod attempt;
mod finite;
pub mod memory;
mod planned_points;
mod point_readouts;
mod point_watch;
mod run_error;
mod run_event;
pub mod usage;

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use fem_client::scene::Scene;
use fem_client::solver::{Cost, Readout, Solver};
use gsa::method::analysis::Status;

pub(crate) use self::planned_points::Place;
pub(crate) use self::planned_points::keys;
use self::planned_points::{Answers, Points};
pub use self::run_error::RunError;
pub use self::run_event::{Event, Observer};
use crate::result::{StudyCost, StudyResult};
use crate::run::archive::{Archive, Outcome};
use crate::run::usage::{cpu_s, peak_memory_bytes};
use crate::score::analyst::Stopped;
use crate::score::assemble::assemble;
use crate::score::indices::Coarse;
use crate::score::readings::ranked_values;
use crate::study::Study;
use crate::study::plan::Plan;

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
    run_from(0, study, plan, context).map(|(result, _)| result)
}

/// What a study is run with.
#[derive(Clone, Copy)]
pub struct RunContext<'r> {
    /// Who solves.
    pub solver: &'r dyn Solver,
    /// Where solved points are kept.
    pub archive: &'r dyn Archive,
    /// Solves at once.
    pub threads: usize,
    /// Set to true by the caller to end the run; what is solved is kept.
    pub stop: &'r AtomicBool,
    /// Set to true by the caller to end the run once the solves in flight have ended, after one at least. A run with a budget of
    /// time goes on.
    pub pause: Option<&'r AtomicBool>,
    /// Is told what happens.
    pub observer: Observer<'r>,
}

/// Runs a study whose points have ordinals from `first` on; also says how many there were.
pub(crate) fn run_from(
    first: usize,
    study: &Study,
    plan: &Plan,
    context: RunContext<'_>,
) -> Result<(StudyResult, usize), RunError> {
    let RunContext {
        solver, observer, ..
    } = context;
    let (begun, cpu_before) = (Instant::now(), cpu_s());
    let mut plan = plan.clone();
    let coarser = solver.coarser(&study.scene);
    let meshes = 1 + usize::from(coarser.is_some());
    let readout = study.readout();
    let answers = |plan: &Plan, place: Place| {
        answers_of(&plan.points, plan.values(), &readout, place, context)
    };
    let mut solved = 0;
    let (outcomes, costs) = loop {
        let place = Place {
            first,
            of: first + meshes * plan.points.len(),
        };
        let Answers { points, reused } = answers(&plan, place)?;
        solved += points.len() - reused;
        let (outcomes, costs): (Vec<Outcome>, Vec<Cost>) = points.into_iter().unzip();
        let values = ranked_values(&outcomes, study.directions);
        if !plan.extend(study, &values.view())? {
            break (outcomes, costs);
        }
    };
    let reused = costs.len() - solved;
    let coarse = coarser.map(|coarser| {
        let place = Place {
            first: first + plan.points.len(),
            of: first + meshes * plan.points.len(),
        };
        let outcomes = on_coarser_mesh(answers(&plan.on_level(coarser.level), place))?;
        Ok::<_, RunError>(Coarse { coarser, outcomes })
    });
    let coarse = coarse.transpose()?;
    observer(Event::Analysing);
    let coarser_outcomes = coarse.as_ref().and_then(|coarse| coarse.outcomes.as_ref());
    let cost = || StudyCost {
        wall_s: begun.elapsed().as_secs_f64(),
        cpu_s: (cpu_s() - cpu_before).max(0.0),
        peak_memory_bytes: peak_memory_bytes(),
        coarser_solves: coarser_outcomes.map_or(0, Vec::len),
        ..solve_cost(&costs, reused)
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
    Ok((result, meshes * plan.points.len()))
}

/// Loads or solves scenes that start from the first one's equilibrium.
fn answers_of(
    scenes: &[Scene],
    values: &[Vec<f64>],
    readout: &Readout,
    place: Place,
    context: RunContext<'_>,
) -> Result<Answers, RunError> {
    let unless_stopped = |key| match context.stop.load(Ordering::Relaxed) {
        true => Err(RunError::Stopped),
        false => Ok(key),
    };
    let keys = keys(scenes, context.solver, readout).map(unless_stopped);
    let points = Points {
        scenes,
        values,
        readout,
        solver: context.solver,
        archive: context.archive,
        stop: context.stop,
        pause: context.pause,
        observer: context.observer,
        keys: keys.collect::<Result<_, _>>()?,
        place,
    };
    points.answers(context.threads)
}

/// What further scenes answer that are no points of the plan.
pub(crate) fn outcomes_of(
    scenes: &[Scene],
    values: &[Vec<f64>],
    readout: &Readout,
    place: Place,
    context: RunContext<'_>,
) -> Result<Vec<Outcome>, RunError> {
    let answers = answers_of(scenes, values, readout, place, context)?;
    Ok(answers
        .points
        .into_iter()
        .map(|(outcome, _)| outcome)
        .collect())
}

/// What the coarser mesh answered; nothing where a point broke or the cut point has no equilibrium there: that costs the
/// mesh error, not the study.
fn on_coarser_mesh(answers: Result<Answers, RunError>) -> Result<Option<Vec<Outcome>>, RunError> {
    match answers {
        Ok(answers) => Ok(Some(answers.points.into_iter().map(|(o, _)| o).collect())),
        Err(RunError::PointsFailed { .. } | RunError::Refused { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}

/// Whether the points gave something: indices of some output, or that none of them varies.
fn has_indices(result: &StudyResult) -> bool {
    let indexed = result.outputs.iter().any(|o| o.first_order.is_some());
    indexed || result.outputs.iter().all(|o| o.status != Status::Unusable)
}

/// What the solves took, whenever they were made.
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
