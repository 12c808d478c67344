//! Tires on the draft mesh, solved more tightly than studies are, so that small differences mean something.

use std::sync::atomic::AtomicBool;

use fem::newton::iteration::NewtonSettings;

use crate::family::Unsolved;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{
    NoEquilibrium, Reached, Readout, SolveError, SolveRequest, Solved, Solver,
};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;
use tire::model::mesh_plan;

/// Largest relative residual of these equilibria: a thousandth of a study's.
pub(super) const TOLERANCE: f64 = 1e-11;
/// Noise that this tolerance leaves of a strain, absolute, and of the reaction, relative: a study's tolerance of 1e-8 leaves 1e-8 and 1e-7.
pub(crate) const STRAIN_NOISE: f64 = 1e-11;
/// See [`STRAIN_NOISE`].
pub(super) const REACTION_NOISE: f64 = 1e-10;

/// The shipped tire with its carcass, on the draft mesh.
pub(super) fn reference() -> Scene {
    let mut scene = Scene::preset("foot-tire").unwrap_or_default();
    scene.model.level = Level::Draft;
    scene
}

/// The embedded solver at this tolerance.
pub(crate) fn tight_solver() -> EmbeddedSolver {
    EmbeddedSolver::with_settings(NewtonSettings {
        tolerance: TOLERANCE,
        ..NewtonSettings::default()
    })
}

/// Solves scenes from nothing.
pub(super) struct Bench<'s> {
    solver: EmbeddedSolver,
    readout: Readout,
    stop: &'s AtomicBool,
}

impl<'s> Bench<'s> {
    /// Solves to the tolerance of this file.
    pub(crate) fn tight(stop: &'s AtomicBool) -> Self {
        Self {
            solver: tight_solver(),
            readout: Readout::default(),
            stop,
        }
    }

    /// Solves as studies do.
    pub fn usual(stop: &'s AtomicBool) -> Self {
        Self {
            solver: EmbeddedSolver::default(),
            readout: Readout::default(),
            stop,
        }
    }

    /// Solves on the mesh of the scene's level.
    pub fn solve(&self, scene: &Scene) -> Result<Solved, SolveError> {
        self.solver.solve(&self.request(scene))
    }

    /// Solves on another mesh.
    pub fn solve_on(&self, scene: &Scene, plan: &MeshPlan) -> Result<Solved, SolveError> {
        self.solver.solve_on(&self.request(scene), plan)
    }

    /// Returns why a scene has no equilibrium, which it must not have.
    pub fn refusal(&self, scene: &Scene) -> Result<Refusal, Unsolved> {
        self.refusal_on(scene, &mesh_plan(scene, scene.model.level))
    }

    /// Returns why a scene has no equilibrium on another mesh.
    pub(crate) fn refusal_on(&self, scene: &Scene, plan: &MeshPlan) -> Result<Refusal, Unsolved> {
        match self.solve_on(scene, plan) {
            Err(SolveError::NoEquilibrium {
                status,
                detail,
                reached,
            }) => Ok(Refusal {
                status,
                detail,
                reached,
            }),
            Err(other) => Err(other.into()),
            Ok(_) => Err(Unsolved::Other(format!(
                "an equilibrium was found at {} MPa where there is none",
                scene.pressure.internal_mpa
            ))),
        }
    }

    fn request<'r>(&'r self, scene: &'r Scene) -> SolveRequest<'r> {
        SolveRequest {
            scene,
            readout: &self.readout,
            start: None,
            watch: self.stop,
        }
    }
}

/// A named reason, and how far the solve got.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Refusal {
    /// Name of the state.
    pub status: NoEquilibrium,
    /// Explanation, in words.
    pub detail: String,
    /// Loads reached.
    pub reached: Reached,
}

impl Refusal {
    /// Name and words.
    pub fn text(&self) -> String {
        format!("{}: {}", self.status.as_str(), self.detail)
    }
}
