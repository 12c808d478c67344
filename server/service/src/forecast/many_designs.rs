//! Forecast of many designs, some at a time, so that a hundred thousand have room in memory.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use fem_client::solver::Solver;
use placement::estimate::{Machine, Workload, estimate};
use results::Estimate;

use super::known_solves::{known, measured};
use store::{Store, StoreError};

/// Designs that are looked at together.
pub const TOGETHER: usize = 256;

/// Number that stands for a content key where there are millions; of ten million keys two share one with a probability of 3e-6.
pub fn key_number(key: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    key.hash(&mut hasher);
    hasher.finish()
}

/// Forecast of designs one after the other: what one of them solves is known to those after it.
pub struct ManyDesigns<'m> {
    store: Option<&'m Store>,
    machine: Machine,
    /// Numbers of the keys of points that earlier designs ask for.
    earlier: HashSet<u64>,
}

/// Cost of a design, and what a database has of it.
pub struct Foreseen {
    /// Cost on this machine.
    pub estimate: Estimate,
    /// Keys of its points that are in the database.
    pub known: Vec<String>,
}

impl<'m> ManyDesigns<'m> {
    /// Begins with designs of which nothing is known but what a database has.
    ///
    /// # Errors
    /// When the database can't be read.
    pub async fn begin(
        store: Option<&'m Store>,
        solver: &dyn Solver,
        threads: usize,
    ) -> Result<Self, StoreError> {
        Ok(Self {
            store,
            machine: measured(store, solver, threads).await?,
            earlier: HashSet::new(),
        })
    }

    /// The next designs, in their order; of one without a workload nothing is foreseen.
    ///
    /// # Errors
    /// When the database can't be read.
    pub async fn next(
        &mut self,
        works: &[Option<Workload>],
    ) -> Result<Vec<Option<Foreseen>>, StoreError> {
        let there = known(self.store, works.iter().flatten()).await?;
        let foreseen = works.iter().map(|work| {
            let work = work.as_ref()?;
            let is_known =
                |key: &str| there.contains(key) || self.earlier.contains(&key_number(key));
            let estimate = estimate(work, &is_known, &self.machine);
            self.earlier.extend(work.keys().map(key_number));
            let known = work.keys().filter(|key| there.contains(*key));
            Some(Foreseen {
                estimate,
                known: known.map(str::to_owned).collect(),
            })
        });
        Ok(foreseen.collect())
    }
}
