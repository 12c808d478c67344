//! A solver whose solves belong to a span of the log, whichever thread they run on.

use std::sync::Arc;

use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use tracing::Span;

use crate::solving::inner_tells;

/// Another solver, whose every line in the log says what it is at work for.
pub(crate) struct Traced {
    solver: Arc<dyn Solver>,
    span: Span,
}

impl Traced {
    /// Solves within this span.
    pub fn new(solver: Arc<dyn Solver>, span: Span) -> Self {
        Self { solver, span }
    }
}

impl Solver for Traced {
    fn version(&self) -> String {
        self.solver.version()
    }

    inner_tells!();

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.span.in_scope(|| self.solver.solve(request))
    }

    fn solve_isolated(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.span.in_scope(|| self.solver.solve_isolated(request))
    }
}
