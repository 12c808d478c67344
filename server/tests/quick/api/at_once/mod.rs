//! Answers at once, beside the queue.

mod preview;
mod scene;

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};

use crate::app::slow;

/// The closed form, slow, counting its solves.
struct Counting {
    solver: ClosedFormSolver,
    begun: AtomicUsize,
}

impl Counting {
    fn slow() -> Arc<Self> {
        Arc::new(Self {
            solver: slow(),
            begun: AtomicUsize::new(0),
        })
    }
}

impl Solver for Counting {
    fn version(&self) -> String {
        self.solver.version()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.begun.fetch_add(1, Ordering::Relaxed);
        self.solver.solve(request)
    }
}
