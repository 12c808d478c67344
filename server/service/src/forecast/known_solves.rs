//! Solves of a database, as forecasts ask for them: which points it has, and how fast this machine is.

use std::collections::HashSet;
use std::num::NonZeroUsize;

use fem_client::solver::Solver;
use placement::estimate::{Machine, Workload};

use store::points::evaluations;
use store::{Store, StoreError};

/// Keys of these workloads' points that a database has; without one it has none.
///
/// # Errors
/// When the database can't be read.
pub(super) async fn known<'w>(
    store: Option<&Store>,
    works: impl Iterator<Item = &'w Workload>,
) -> Result<HashSet<String>, StoreError> {
    let Some(store) = store else {
        return Ok(HashSet::new());
    };
    let keys: Vec<&str> = works.flat_map(Workload::keys).collect();
    let mut connection = store.read().await?;
    evaluations::known(&mut connection, &keys).await
}

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
