//! Means of a run: who solves, where solves are kept, who may end it, who is told.

use std::sync::atomic::AtomicBool;

use fem_client::solver::Solver;

use super::run_event::Observer;
use crate::points::archive::Archive;

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
