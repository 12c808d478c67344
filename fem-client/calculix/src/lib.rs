//! CalculiX as an external solver: a second opinion on the scenes that it can model.
//!
//! It gets the embedded solver's mesh with 8-node bricks between the nodes, and its displacements are read by the same
//! [`tire::readout::surface_reader::Reader`], so that only the solvers differ. A scene takes two runs: the first inflates the tire alone, because the
//! ground's height is measured from the inflated tire; the second inflates and presses. The modules, in reading order:
//!
//! - [`rigid_ground`]: the rigid ground as bricks
//! - [`deck`]: the input deck
//! - `program`: one run of the program
//! - `result_file`: what it printed
//! - `limits`: what is refused, and what is changed
//! - `case`: the runs of one scene

mod case;
pub mod deck;
mod limits;
mod program;
mod result_file;
pub mod rigid_ground;
#[cfg(all(test, unix))]
#[path = "../tests/quick/stand_in.rs"]
mod stand_in;

use std::path::Path;
use std::time::{Duration, Instant};

use fem::cell::element::Order;

use self::case::Case;
use self::program::Program;
use fem_client::scene::Scene;
use fem_client::solver::Coarser;
use fem_client::solver::gauge;
use fem_client::solver::sides;
use fem_client::solver::{
    Cost, Readout, SolveError, SolveRequest, Solved, Solver, StartState, by_depth_only,
};
use tire::mesh::tire_grid::{MeshPlan, MiddleSector};
use tire::mesh_error;
use tire::model::{mesh_plan, mesh_plan_for};

pub use self::program::NotInstalled;

/// Solves scenes with an installed CalculiX, one process per run. It always starts from nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct CalculixSolver {
    program: Program,
}

impl CalculixSolver {
    /// Uses the program at `path`, or of that name in the search path; a run may take `time_limit`.
    ///
    /// # Errors
    /// [`NotInstalled`] says what to install.
    pub fn new(path: &Path, time_limit: Duration) -> Result<Self, NotInstalled> {
        Program::new(path, time_limit).map(|program| Self { program })
    }

    /// Solves a scene on a mesh of the caller's choice, of 8-node bricks.
    ///
    /// # Errors
    /// As [`Solver::solve`].
    ///
    /// # Panics
    /// When the plan's order isn't linear.
    pub fn solve_on(
        &self,
        request: &SolveRequest<'_>,
        plan: &MeshPlan,
    ) -> Result<Solved, SolveError> {
        let begin = Instant::now();
        let mut faults = limits::faults(request.scene);
        faults.extend(by_depth_only(request.scene));
        faults.extend(gauge::faults(&request.readout.gauges, request.scene));
        faults.extend(sides::none_of(&request.readout.derivatives));
        if !faults.is_empty() {
            return Err(SolveError::Refused { faults });
        }
        let response = Case::new(request, plan, &self.program).response()?;
        Ok(Solved {
            cost: Cost {
                wall_s: begin.elapsed().as_secs_f64(),
                newton_iterations: response.newton_iterations,
                // CalculiX doesn't say how it spends its time.
                ..Cost::default()
            },
            response,
            state: StartState {
                inflated_key: String::new(),
                inflated: Vec::new(),
                pressure_mpa: request.scene.pressure.internal_mpa,
                depths_mm: request.scene.ground.depths_mm.clone(),
                camber_deg: request.scene.ground.camber_deg,
                equilibrium: Vec::new(),
            },
        })
    }
}

impl Solver for CalculixSolver {
    fn coarser(&self, scene: &Scene) -> Option<Coarser> {
        mesh_error::coarser(scene)
    }

    fn version(&self) -> String {
        format!(
            "calculix {} by strainsite {}+{}",
            self.program.version(),
            env!("CARGO_PKG_VERSION"),
            env!("SOLVER_SOURCES")
        )
    }

    fn cells(&self, scene: &Scene) -> usize {
        mesh_plan(scene, scene.model.level).cells()
    }

    fn cells_read(&self, scene: &Scene, readout: &Readout) -> usize {
        mesh_plan_for(scene, scene.model.level, readout).cells()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let plan = mesh_plan_for(request.scene, request.scene.model.level, request.readout);
        self.solve_on(request, &linear(&plan))
    }
}

/// The plan with 8-node bricks: a quadratic brick becomes two along each direction, so that the nodes are as many.
fn linear(plan: &MeshPlan) -> MeshPlan {
    let per_brick = plan.order.edge_nodes() - 1;
    MeshPlan {
        order: Order::Linear,
        fine: per_brick * plan.fine,
        middle: plan.middle.map(|middle| MiddleSector {
            bricks: per_brick * middle.bricks,
            ..middle
        }),
        coarse: per_brick * plan.coarse,
        meridional: per_brick * plan.meridional,
        layers: per_brick * plan.layers,
        ..*plan
    }
}
