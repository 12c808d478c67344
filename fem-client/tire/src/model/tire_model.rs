//! A tire scene, ready to be solved.

use fem::problem::{Problem, State};
use fem::surface::chart::Chart;
use fem::surface::membrane::Membrane;
use fem_client::scene::Scene;
use fem_client::solver::ModelSummary;

use super::boundary_values::problem;
use super::choices::{left_out, modelled};
use super::dimensions::shape;
use crate::mesh::tire_grid::{Extent, MeshPlan, TireGrid};

/// A tire scene, ready to be solved.
#[derive(Debug)]
pub struct TireModel {
    /// The boundary value problem.
    pub problem: Problem,
    /// Its grid.
    pub grid: TireGrid,
    /// Chart of the inner surface.
    pub chart: Chart,
}

impl TireModel {
    /// Builds the problem of a scene.
    pub fn new(scene: &Scene, plan: &MeshPlan, extent: Extent) -> Self {
        Self::on_grid(scene, TireGrid::new(shape(scene), plan, extent))
    }

    /// Builds the problem of a scene on a grid of its tire's shape.
    pub fn on_grid(scene: &Scene, grid: TireGrid) -> Self {
        Self {
            problem: problem(scene, &grid),
            chart: chart(&grid),
            grid,
        }
    }

    /// Factor from the model's forces to the whole tire's.
    pub fn multiplicity(&self) -> f64 {
        match self.grid.extent {
            Extent::Full => 1.0,
            Extent::Half => 2.0,
            Extent::Quarter => 4.0,
        }
    }

    /// Radius of the crown's outer surface at the contact centre in a state without contact, mm.
    pub fn crown_radius(&self, state: &State) -> f64 {
        -state.position(&self.problem.mesh, self.grid.lowest_node())[2]
    }

    /// A flat state (mm, then MPa) fitted to this mesh: its own, or a quarter's, mirrored to the half. `None` for any other length.
    pub fn fit(&self, flat: &[f64]) -> Option<State> {
        State::from_flat(&self.problem, flat)
            .or_else(|| State::from_flat(&self.problem, &self.grid.mirror_quarter(flat)?))
    }

    /// The textile layer, when the scene has one.
    pub fn carcass(&self) -> Option<&Membrane> {
        self.grid.shape.carcass.and(self.problem.membranes.first())
    }

    /// The film, when the scene has one.
    pub fn film(&self) -> Option<&Membrane> {
        let layers = usize::from(self.grid.shape.carcass.is_some());
        self.problem.membranes.get(layers)
    }

    /// What is modelled and what is left out, with reasons.
    pub fn summary(&self, scene: &Scene, dofs: usize) -> ModelSummary {
        let dimension = match self.grid.extent {
            Extent::Full => "3d",
            Extent::Half => "3d-half",
            Extent::Quarter => "3d-quarter",
        };
        ModelSummary {
            dimension: dimension.into(),
            level: scene.model.level.as_str().into(),
            elements: self.problem.mesh.brick_count(),
            dofs,
            modelled: modelled(scene, self.grid.order),
            left_out: left_out(scene, self.grid.extent),
        }
    }
}

/// Chart of the inner surface: lengths along the crown and the section, mm.
fn chart(grid: &TireGrid) -> Chart {
    let circumference = std::f64::consts::TAU * grid.crown_radius();
    let mut mirrors = Vec::new();
    if grid.extent != Extent::Full {
        mirrors.push((1, 0.0));
    }
    if grid.extent == Extent::Quarter {
        mirrors.extend([(0, 0.0), (0, 0.5 * circumference)]);
    }
    Chart {
        surface: grid.inner_surface(),
        coordinates: grid.inner_chart(),
        mirrors,
        period: (grid.extent != Extent::Quarter).then_some(circumference),
    }
}
