//! The process that solves.

use std::process::ExitCode;
use std::sync::atomic::AtomicBool;

use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use placement::points::usage::cpu_s;

use super::messages::{Answer, Order};
use crate::work::answering;

/// The program's only argument when it is started for this. It is no command of its users.
pub const ARGUMENT: &str = "solve-apart";

/// Answers the order on standard input.
pub fn answer(solver: &dyn Solver) -> ExitCode {
    answering::answer(|order| Answer::of(solved(solver, order), cpu_s()))
}

fn solved(solver: &dyn Solver, order: &str) -> Result<Solved, SolveError> {
    let order: Order = serde_json::from_str(order).map_err(|error| SolveError::Broken {
        detail: format!("its order can't be read: {error}"),
    })?;
    let (scene, readout, start) = order.parts()?;
    solver.solve(&SolveRequest {
        scene: &scene,
        readout: &readout,
        start: start.as_ref(),
        // The parent ends the process instead.
        watch: &AtomicBool::new(false),
    })
}
