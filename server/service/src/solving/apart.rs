//! A solver whose every solve is in a process of its own, where it knows one.

use std::sync::Arc;

use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};

use crate::solving::inner_tells;

/// Another solver, each of whose solves is isolated.
pub(crate) struct Apart {
    solver: Arc<dyn Solver>,
}

impl Apart {
    /// Solves by `solver`, apart.
    pub fn new(solver: Arc<dyn Solver>) -> Self {
        Self { solver }
    }
}

impl Solver for Apart {
    fn version(&self) -> String {
        self.solver.version()
    }

    inner_tells!();

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.solver.solve_isolated(request)
    }
}
