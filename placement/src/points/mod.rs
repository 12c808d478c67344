//! Solves the points that the archive lacks, on threads of their own.
//!
//! - [`archive`]: where solved points are kept; [`memory`] keeps them for as long as the program runs
//! - `ground_images`: grounds of which a solver solves one for two
//! - `series`: series of points, what each starts from, and how all are solved
//! - `run_context`: what a run is done with; `run_event`, `run_error`: what is told meanwhile, and why nothing came of it
//! - [`worker_threads`]: work on as many threads as a user asks for; [`usage`]: time and memory of this process; [`machine_memory`]: how much there is

pub mod archive;
mod ground_images;
pub mod machine_memory;
pub mod memory;
mod run_context;
mod run_error;
mod run_event;
mod series;
pub mod usage;
pub mod worker_threads;

pub(crate) use self::ground_images::{mirror_class, mirror_key, tire};
pub use self::run_context::RunContext;
pub use self::run_error::RunError;
pub use self::run_event::{Event, Observer};
pub(crate) use self::series::{
    Answers, Place, PointReadouts, PointSeries, SceneSeries, Starts, answers_of_all, keys,
    outcomes, outcomes_of_all,
};
use crate::points::archive::Outcome;

/// Loads or solves the points of one series.
pub(crate) fn answers_of(
    series: PointSeries<'_>,
    place: Place,
    context: RunContext<'_>,
) -> Result<Answers, RunError> {
    let mut answers = answers_of_all(&[series], place, context)?;
    answers.remove(0)
}

/// Outcomes of one series, of scenes that are no points of the plan.
pub(crate) fn outcomes_of(
    series: PointSeries<'_>,
    place: Place,
    context: RunContext<'_>,
) -> Result<Vec<Outcome>, RunError> {
    Ok(answers_of(series, place, context)?.outcomes())
}
