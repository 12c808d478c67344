//! Stored points in a solver's place: what asks a solver gets what was solved before, and nothing else.

use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, Ordering};

use fem_client::scene::Scene;
use fem_client::solver::{Coarser, Cost, SolveError, SolveRequest, Solved, Solver, StartState};

use crate::points::archive::Outcome;
use results::Unsolved;

/// Answers with outcomes that are stored, whichever version solved them.
pub struct StoredSolves {
    by_scene: HashMap<String, Outcome>,
    coarser: Option<Coarser>,
    is_incomplete: AtomicBool,
}

impl StoredSolves {
    /// Holds outcomes by their canonical scenes; `coarser` is the mesh beside the study's.
    pub fn new(by_scene: HashMap<String, Outcome>, coarser: Option<Coarser>) -> Self {
        Self {
            by_scene,
            coarser,
            is_incomplete: AtomicBool::new(false),
        }
    }

    /// Whether something was asked that isn't stored.
    pub(crate) fn is_incomplete(&self) -> bool {
        self.is_incomplete.load(Ordering::Relaxed)
    }
}

impl Solver for StoredSolves {
    fn version(&self) -> String {
        "stored".to_owned()
    }

    fn coarser(&self, _: &Scene) -> Option<Coarser> {
        self.coarser
    }

    /// Returns what is stored of the scene. What isn't ends the run.
    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        match self.by_scene.get(&request.scene.canonical_json()) {
            Some(Ok(response)) => Ok(Solved {
                response: response.clone(),
                cost: Cost::default(),
                state: nowhere(),
            }),
            Some(Err(unsolved)) => Err(no_equilibrium(unsolved)),
            None => {
                self.is_incomplete.store(true, Ordering::Relaxed);
                Err(SolveError::Stopped)
            }
        }
    }
}

fn no_equilibrium(unsolved: &Unsolved) -> SolveError {
    SolveError::NoEquilibrium {
        status: unsolved.status,
        detail: unsolved.detail.clone(),
        reached: unsolved.reached.clone(),
    }
}

/// Returns an empty state: nothing starts from a stored point here.
fn nowhere() -> StartState {
    StartState {
        inflated_key: String::new(),
        inflated: Vec::new(),
        pressure_mpa: 0.0,
        depths_mm: Vec::new(),
        camber_deg: 0.0,
        equilibrium: Vec::new(),
    }
}
