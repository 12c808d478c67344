//! The reference tire, and one solve of it.

use std::sync::atomic::AtomicBool;

use fem_client::scene::Scene;
use fem_client::solver::{Readout, SolveRequest, Solved, StartState};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::MeshPlan;

static RUNNING: AtomicBool = AtomicBool::new(false);

/// The reference tire pressed evenly by a depth in mm, with the independent solution's bulk modulus (1000 shear moduli)
/// and contact stiffness.
pub fn reference(depth: f64) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.material.d1_per_mpa = 2.0 / 360.0;
    scene.contact.penalty_n_per_mm3 = Some(100.0);
    scene.ground.depths_mm = vec![depth; scene.ground.stations];
    scene
}

/// Solves a scene whose equilibrium is known to exist.
pub fn solve(
    solver: &EmbeddedSolver,
    scene: &Scene,
    plan: &MeshPlan,
    start: Option<&StartState>,
) -> Solved {
    let request = SolveRequest {
        scene,
        readout: &Readout::default(),
        start,
        watch: &RUNNING,
    };
    solver
        .solve_on(&request, plan)
        .expect("the reference tire has an equilibrium up to 2 mm")
}
