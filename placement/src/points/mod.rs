//! Solves the points that the archive lacks, on threads of their own.
//!
//! - [`archive`]: where solved points are kept; [`memory`] keeps them for as long as the program runs
//! - `planned_points`: solves a plan's points; `attempt` solves one, `point_readouts` says what is read off, `point_watch` tells how far a solve is
//! - `finite`: refuses what isn't a number
//! - `run_event`, `run_error`: what is told meanwhile, and why nothing came of it
//! - [`worker_threads`]: work on as many threads as a user asks for; [`usage`]: time and memory of this process; [`machine_memory`]: how much there is

pub mod archive;
mod attempt;
mod finite;
pub mod machine_memory;
pub mod memory;
mod planned_points;
mod point_readouts;
mod point_watch;
mod run_error;
mod run_event;
pub mod usage;
pub mod worker_threads;

use std::sync::atomic::{AtomicBool, Ordering};

use fem_client::scene::Scene;
use fem_client::solver::{Readout, Solver};

use self::planned_points::Points;
pub(crate) use self::planned_points::{Answers, Place, keys};
pub use self::run_error::RunError;
pub use self::run_event::{Event, Observer};
use crate::points::archive::{Archive, Outcome};

/// Context of a study's run.
#[derive(Clone, Copy)]
pub struct RunContext<'r> {
    /// Solver of the points.
    pub solver: &'r dyn Solver,
    /// Archive of solved points.
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

/// Loads or solves scenes that start from the first one's equilibrium.
pub(crate) fn answers_of(
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

/// Solves further scenes that are no points of the plan.
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
