//! Runs a study: solves the points that the archive lacks, then analyses and ranks.

pub mod archive;
mod attempt;
mod finite;
pub mod memory;
mod points;
pub mod usage;

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use fem_client::document::fault::Fault;
use fem_client::scene::Scene;
use fem_client::solver::{Cost, Readout, Solver};
use gsa::method::analysis::Status;

pub(crate) use self::points::keys;
use self::points::{Answers, Place, Points};
use crate::result::{FailedPoint, StudyCost, StudyResult};
use crate::run::archive::{Archive, ArchiveError, Outcome};
use crate::run::usage::{cpu_s, peak_memory_bytes};
use crate::score::assemble::assemble;
use crate::score::indices;
use crate::score::indices::Coarse;
use crate::study::Study;
use crate::study::plan::{Plan, PlanError};

/// What happens during a run, as it happens.
#[derive(Debug, Clone, PartialEq)]
pub enum Event {
    /// The archive was searched; the solves begin. An adaptive method may go on to a longer plan, and every run goes on to the
    /// same points on a coarser mesh: it begins again then.
    Started {
        /// Points of the run, as far as that is known.
        points: usize,
        /// Those that are there already.
        reused: usize,
    },
    /// A point was solved, and is in the archive.
    PointSolved {
        /// Its ordinal in the plan.
        ordinal: usize,
        /// Points done so far, reused ones included; rises by one from event to event.
        done: usize,
        /// Points of the plan.
        of: usize,
        /// Wall-clock time of the solve, s.
        wall_s: f64,
        /// Newton iterations of the solve.
        newton_iterations: usize,
    },
    /// A point has no response: no equilibrium, which is in the archive, or its solve broke. Both count as done, a refused one
    /// doesn't.
    PointFailed {
        /// Its ordinal in the plan.
        ordinal: usize,
        /// As for solved points.
        done: usize,
        /// Points of the plan.
        of: usize,
        /// What happened.
        cause: String,
    },
    /// All points are there.
    Analysing,
}

/// Is told of events, from the solving threads, one at a time for points.
pub type Observer<'o> = &'o (dyn Fn(Event) + Sync);

/// Why a run gave no result. What was solved is in the archive in every case.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError {
    /// The cut point has no equilibrium or none was found, or the solver refused points.
    #[error("{}", failures(.failed))]
    PointsFailed {
        /// Each of them, in the order of the plan; at least one.
        failed: Vec<FailedPoint>,
    },
    /// So many points have no equilibrium that the others don't give any index.
    #[error("the other points don't give any index: {}", failures(.failed))]
    TooManyFailed {
        /// Each of them, in the order of the plan; at least one.
        failed: Vec<FailedPoint>,
    },
    /// The solver doesn't do what the scene asks for.
    #[error("the solver refuses the scene: {}", refusals(.faults))]
    Refused {
        /// What is wrong, where.
        faults: Vec<Fault>,
    },
    /// A point that an adaptive method asked for leaves the ranges of the scene.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The caller asked to stop; the same run later goes on where this one ended.
    #[error("stopped on request")]
    Stopped,
    /// The caller asked for a pause; the same run later goes on where this one ended.
    #[error("paused on request")]
    Paused,
    /// The time allowed is over before the cheapest model has answered.
    #[error(
        "a budget of {seconds} s is over before the draft has answered; what is solved is kept"
    )]
    Budget {
        /// The budget.
        seconds: f64,
    },
    /// The archive failed.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
    /// The archive has the cut point's response but not its equilibrium, from which the others start.
    #[error(
        "the archive has the response of the cut point ({key}) but not its start state: remove the entry"
    )]
    StartMissing {
        /// Content key of the cut point.
        key: String,
    },
}

impl RunError {
    /// The points that are to blame, if any are.
    pub fn failed_points(&self) -> &[FailedPoint] {
        match self {
            Self::PointsFailed { failed } | Self::TooManyFailed { failed } => failed,
            _ => &[],
        }
    }
}

fn failures(failed: &[FailedPoint]) -> String {
    let count = failed.len();
    match failed.first() {
        Some(FailedPoint {
            ordinal,
            values,
            cause,
        }) => format!(
            "{count} {} failed; the first is point {ordinal} at {values:?}: {cause}",
            if count == 1 { "point" } else { "points" }
        ),
        None => "points failed".to_owned(),
    }
}

fn refusals(faults: &[Fault]) -> String {
    faults
        .iter()
        .map(Fault::to_string)
        .collect::<Vec<_>>()
        .join("; ")
}

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
pub fn run(study: &Study, plan: &Plan, means: Means<'_>) -> Result<StudyResult, RunError> {
    run_from(0, study, plan, means).map(|(result, _)| result)
}

/// What a study is run with.
#[derive(Clone, Copy)]
pub struct Means<'r> {
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

/// The same where the points have ordinals from `first` on; also says how many there were.
pub(crate) fn run_from(
    first: usize,
    study: &Study,
    plan: &Plan,
    means: Means<'_>,
) -> Result<(StudyResult, usize), RunError> {
    let Means {
        solver, observer, ..
    } = means;
    let (begun, cpu_before) = (Instant::now(), cpu_s());
    let mut plan = plan.clone();
    let coarser = solver.coarser(&study.scene);
    let meshes = 1 + usize::from(coarser.is_some());
    let readout = study.readout();
    let answers =
        |plan: &Plan, place: Place| answers_of(&plan.points, plan.values(), &readout, place, means);
    let mut solved = 0;
    let (outcomes, costs) = loop {
        let place = Place {
            first,
            of: first + meshes * plan.points.len(),
        };
        let Answers { points, reused } = answers(&plan, place)?;
        solved += points.len() - reused;
        let (outcomes, costs): (Vec<Outcome>, Vec<Cost>) = points.into_iter().unzip();
        let values = indices::ranked_values(&outcomes, study.directions);
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
    let mut result = assemble(study, &plan, &outcomes, coarse.as_ref(), &solver.version());
    if !result.failed_points.is_empty() && !has_indices(&result) {
        return Err(RunError::TooManyFailed {
            failed: result.failed_points,
        });
    }
    result.cost = StudyCost {
        wall_s: begun.elapsed().as_secs_f64(),
        cpu_s: (cpu_s() - cpu_before).max(0.0),
        peak_memory_bytes: peak_memory_bytes(),
        coarser_solves: coarse
            .and_then(|coarse| coarse.outcomes)
            .map_or(0, |o| o.len()),
        ..solve_cost(&costs, reused)
    };
    Ok((result, meshes * plan.points.len()))
}

/// Loads or solves scenes that start from the first one's equilibrium.
fn answers_of(
    scenes: &[Scene],
    values: &[Vec<f64>],
    readout: &Readout,
    place: Place,
    means: Means<'_>,
) -> Result<Answers, RunError> {
    let points = Points {
        scenes,
        values,
        readout,
        solver: means.solver,
        archive: means.archive,
        stop: means.stop,
        pause: means.pause,
        observer: means.observer,
        keys: keys(scenes, means.solver, readout),
        place,
    };
    points.answers(means.threads)
}

/// What further scenes answer that are no points of the plan: they have ordinals from `first` on.
pub(crate) fn outcomes_of(
    scenes: &[Scene],
    values: &[Vec<f64>],
    readout: &Readout,
    first: usize,
    means: Means<'_>,
) -> Result<Vec<Outcome>, RunError> {
    let place = Place {
        first,
        of: first + scenes.len(),
    };
    let answers = answers_of(scenes, values, readout, place, means)?;
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
    let unusable = Status::Unusable.as_str();
    let indexed = result.outputs.iter().any(|o| o.first_order.is_some());
    indexed || result.outputs.iter().all(|o| o.status != unusable)
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
