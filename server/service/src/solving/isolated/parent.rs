//! The solver that starts a process for a solve, and waits for it.

use std::process::Command;
use std::sync::Arc;

use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use placement::points::usage::credit;

use super::messages::{Answer, Order};
use crate::solving::inner_tells;
use crate::work::own_process::{Start, Unanswered, Wish, ask};

type SolveResult = Result<Solved, SolveError>;

/// Another solver, which is also asked in a process of its own.
pub struct Isolated {
    solver: Arc<dyn Solver>,
    start: Start,
}

impl Isolated {
    /// Solves by `solver`, and in a process of its own by what the command starts: this program with
    /// [`ARGUMENT`](super::child::ARGUMENT), or what speaks like it.
    pub fn new(
        solver: Arc<dyn Solver>,
        start: impl Fn() -> Command + Send + Sync + 'static,
    ) -> Self {
        Self {
            solver,
            start: Box::new(start),
        }
    }
}

impl Solver for Isolated {
    fn version(&self) -> String {
        self.solver.version()
    }

    inner_tells!();

    fn solve(&self, request: &SolveRequest<'_>) -> SolveResult {
        self.solver.solve(request)
    }

    fn solve_isolated(&self, request: &SolveRequest<'_>) -> SolveResult {
        let order = serde_json::to_string(&Order::of(request)).map_err(broken)?;
        let wish = || match request.watch.is_stopped() {
            true => Wish::Stop,
            false => Wish::GoOn,
        };
        let answer = ask((self.start)(), &order, &wish, &|_| {}).map_err(unsolved)?;
        let answer: Answer = serde_json::from_str(&answer).map_err(broken)?;
        let (result, cpu_s) = answer.outcome();
        credit(cpu_s);
        result
    }
}

fn broken(detail: impl std::fmt::Display) -> SolveError {
    SolveError::Broken {
        detail: detail.to_string(),
    }
}

fn unsolved(reason: Unanswered) -> SolveError {
    match reason {
        Unanswered::Stopped => SolveError::Stopped,
        Unanswered::Crashed(detail) => SolveError::Crashed { detail },
        Unanswered::Broken(detail) => SolveError::Broken { detail },
    }
}
