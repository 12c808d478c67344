//! Asks a solver for one equilibrium, and makes an answer of whatever comes of it.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use fem_client::solver::{
    Cost, NoEquilibrium, Reached, SolveError, SolveRequest, Solved, Solver, StartState,
};

use super::finite::not_finite;
use crate::points::archive::Outcome;
use results::Unsolved;

/// Outcome of a solve with its cost.
pub(super) type Costed = (Outcome, Cost);

/// An answer, with the state from which others may start if there is one.
pub(super) struct Found {
    pub answer: Costed,
    pub state: Option<StartState>,
    /// True of the request, whoever asks and whenever: worth keeping. What a broken solver left isn't.
    pub lasting: bool,
}

/// Process in which a point is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Process {
    /// The process of the run.
    Own,
    /// A process that may crash without ending this one.
    Apart,
}

/// Solves once. A solver that broke is asked once more; breaking again, or not coming to an end, costs this point alone.
///
/// # Errors
/// [`SolveError::Refused`], [`SolveError::Stopped`] and [`SolveError::Crashed`].
pub(super) fn ask(
    solver: &dyn Solver,
    request: &SolveRequest<'_>,
    process: Process,
) -> Result<Found, SolveError> {
    let begun = Instant::now();
    let found = match attempt(solver, request, process) {
        Err(SolveError::Broken { .. }) => attempt(solver, request, process),
        other => other,
    };
    let stopped = request.watch.is_stopped();
    match found {
        // What a solve says while it is being stopped may not be what it would have said.
        Ok(found) if found.answer.0.is_err() && stopped => Err(SolveError::Stopped),
        Err(SolveError::Broken { .. } | SolveError::OverTime { .. }) if stopped => {
            Err(SolveError::Stopped)
        }
        Err(SolveError::Broken { detail }) => Ok(given_up(detail, begun)),
        Err(error @ SolveError::OverTime { .. }) => Ok(given_up(error.to_string(), begun)),
        other => other,
    }
}

fn attempt(
    solver: &dyn Solver,
    request: &SolveRequest<'_>,
    process: Process,
) -> Result<Found, SolveError> {
    if request.watch.is_stopped() {
        return Err(SolveError::Stopped);
    }
    let begun = Instant::now();
    // Nothing of ours is half-changed by an unwinding solve: it only reads what it was given.
    let solve = || match process {
        Process::Own => solver.solve(request),
        Process::Apart => solver.solve_isolated(request),
    };
    let outcome = catch_unwind(AssertUnwindSafe(solve));
    let broken = |detail| SolveError::Broken { detail };
    let outcome = outcome.map_err(|panic| broken(format!("panic: {}", message(&*panic))))?;
    let found = found(outcome, begun)?;
    match not_finite(&found.answer.0) {
        Some(what) => Err(broken(format!("{what} isn't a finite number"))),
        None => Ok(found),
    }
}

/// Returns what a solve that began at this instant has found, unless it refused, broke or was stopped.
fn found(outcome: Result<Solved, SolveError>, begun: Instant) -> Result<Found, SolveError> {
    match outcome {
        Ok(solved) => Ok(Found {
            answer: (Ok(solved.response), solved.cost),
            state: Some(solved.state),
            lasting: true,
        }),
        Err(SolveError::NoEquilibrium {
            status,
            detail,
            reached,
        }) => Ok(Found {
            lasting: true,
            ..unsolved(status, detail, reached, begun)
        }),
        Err(error) => Err(error),
    }
}

fn given_up(detail: String, begun: Instant) -> Found {
    let status = NoEquilibrium::SolverFailed;
    unsolved(status, detail, Reached::default(), begun)
}

/// Returns what is said of a point that isn't solved any more.
pub(super) fn quarantined(crashes: usize, cause: &str) -> Found {
    let detail = format!(
        "solved alone in a process of its own, it ended that {crashes} times, at last by {cause}; strainsite db release lets it be tried again"
    );
    let status = NoEquilibrium::Quarantined;
    unsolved(status, detail, Reached::default(), Instant::now())
}

fn unsolved(status: NoEquilibrium, detail: String, reached: Reached, begun: Instant) -> Found {
    let unsolved = Unsolved {
        status,
        detail,
        reached,
    };
    let cost = Cost {
        wall_s: begun.elapsed().as_secs_f64(),
        ..Cost::default()
    };
    Found {
        answer: (Err(unsolved), cost),
        state: None,
        lasting: false,
    }
}

fn message(panic: &(dyn std::any::Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("no message")
}
