//! A solver whose version says on which numerics it runs.
//!
//! The same program gives other last digits on another processor: its libraries choose their instructions by what that has. Points of two such
//! processors in one study would break the promise that a result is the same to the bit, so they have different keys.

use std::sync::atomic::AtomicBool;
use std::sync::{Arc, OnceLock};

use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, SolveError, SolveRequest, Solved, Solver};

use crate::solving::inner_tells;
use store::content::sha256;

/// Fingerprint of the version and the numerics that points were stored with before keys told numerics apart: their keys stay as they are. Any other
/// sources of the solver have another fingerprint, and need no such exception.
const BEFORE: &str = "7ee1da29b2f5";
/// Hexadecimal digits of a fingerprint.
const DIGITS: usize = 12;

/// Another solver, with a fingerprint of its numerics in its version.
pub(crate) struct Fingerprinted {
    solver: Arc<dyn Solver>,
    version: OnceLock<String>,
}

impl Fingerprinted {
    /// Takes the fingerprint when the version is asked for first, which takes a draft solve.
    pub fn new(solver: Arc<dyn Solver>) -> Self {
        Self {
            solver,
            version: OnceLock::new(),
        }
    }
}

/// Digits that stand for all that a solver computes of a draft of the shipped tire from nothing: its geometry by the elementary functions, its
/// equilibrium by the factorisation. What chooses other instructions for the rest chooses others for these.
fn fingerprint(solver: &dyn Solver) -> String {
    let mut scene = Scene::preset("foot-tire").unwrap_or_default();
    scene.model.level = Level::Draft;
    let solved = solver.solve(&SolveRequest {
        scene: &scene,
        readout: &Readout::default(),
        start: None,
        watch: &AtomicBool::new(false),
    });
    let (response, state) = match solved {
        Ok(solved) => (
            serde_json::to_string(&solved.response).unwrap_or_default(),
            solved.state.to_bytes(),
        ),
        Err(error) => (format!("{error:?}"), Vec::new()),
    };
    let version = solver.version();
    let mut digits = sha256(&[version.as_bytes(), response.as_bytes(), &state]);
    digits.truncate(DIGITS);
    digits
}

/// A version with the fingerprint, but for the one that stands for the version alone.
fn named(version: String, fingerprint: &str) -> String {
    match fingerprint {
        BEFORE => version,
        digits => format!("{version} on {digits}"),
    }
}

impl Solver for Fingerprinted {
    fn version(&self) -> String {
        let version = || named(self.solver.version(), &fingerprint(self.solver.as_ref()));
        self.version.get_or_init(version).clone()
    }

    inner_tells!();

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.solver.solve(request)
    }

    fn solve_isolated(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        self.solver.solve_isolated(request)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fem_client::closed_form::ClosedFormSolver;

    #[test]
    fn numerics_have_a_name_of_their_own_but_for_those_from_before() {
        let version = || "solver 1".to_owned();
        assert_eq!(named(version(), BEFORE), version());
        assert_eq!(named(version(), "0a"), "solver 1 on 0a");
    }

    #[test]
    fn the_same_numerics_have_the_same_name() {
        let names = [(); 2].map(|()| {
            let solver = Fingerprinted::new(Arc::new(ClosedFormSolver::new()));
            solver.version()
        });
        assert_eq!(names[0], names[1]);
        assert_ne!(names[0], ClosedFormSolver::new().version());
    }
}
