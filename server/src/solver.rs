//! Which solver answers: chosen here and nowhere else.

use std::sync::Arc;

use fem_client::embedded::EmbeddedSolver;
use fem_client::solver::Solver;

/// The solver of the program.
pub fn solver() -> Arc<dyn Solver> {
    Arc::new(EmbeddedSolver::default())
}
