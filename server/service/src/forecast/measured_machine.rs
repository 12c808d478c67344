//! Machine that solves, as a database's newest solves show it.

use std::num::NonZeroUsize;

use fem_client::solver::Solver;
use placement::estimate::Machine;

use store::points::evaluations;
use store::{Store, StoreError};

/// Machine with so many threads; without a database nothing is known of it but those.
///
/// # Errors
/// When the database can't be read.
pub(super) async fn measured(
    store: Option<&Store>,
    solver: &dyn Solver,
    threads: usize,
) -> Result<Machine, StoreError> {
    let mut samples = Vec::new();
    if let Some(store) = store {
        let mut connection = store.read().await?;
        samples = evaluations::samples(&mut connection).await?;
    }
    Ok(Machine::measured(solves_at_once(threads), &samples, solver))
}

/// Number of solves that run at once, each on a core.
pub(super) fn solves_at_once(threads: usize) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    threads.min(cores)
}
