//! A tire scene, ready to be solved.

use fem::problem::{Problem, State};
use fem::surface::chart::Chart;
use fem::surface::membrane::Membrane;
use fem::surface::sheet::Sheet;
use fem_client::scene::Scene;
use fem_client::solver::ModelSummary;

use super::boundary_values::problem;
use super::choices::{left_out, modelled};
use super::dimensions::shape;
use super::glued_film::Place;
use crate::mesh::tire_grid::{Extent, MeshPlan, TireGrid};

/// A tire scene, ready to be solved.
#[derive(Debug)]
pub struct TireModel {
    /// The boundary value problem.
    pub problem: Problem,
    /// Grid of the mesh.
    pub grid: TireGrid,
    /// Chart of the inner surface.
    pub chart: Chart,
}

impl TireModel {
    /// Builds the problem of a scene.
    pub fn new(scene: &Scene, plan: &MeshPlan, extent: Extent) -> Self {
        let grid = TireGrid::new(shape(scene), plan, extent);
        Self::on_grid(scene, around_film(scene, grid))
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

    /// The textile layer, when the scene has one.
    pub fn carcass(&self) -> Option<&Membrane> {
        self.grid.shape.carcass.and(self.problem.membranes.first())
    }

    /// The film, when the scene has one.
    pub fn film(&self) -> Option<&Sheet> {
        self.problem.sheet.as_ref()
    }

    /// Returns what is modelled and what is left out, with reasons.
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
            modelled: modelled(scene, &self.grid),
            left_out: left_out(scene, self.grid.extent),
        }
    }
}

/// A grid with lines for the film, where there is one.
fn around_film(scene: &Scene, grid: TireGrid) -> TireGrid {
    let Some(film) = &scene.film else {
        return grid;
    };
    let place = Place::of(film, &grid.shape);
    let patch = place.patch(scene.model.level, grid.extent);
    grid.around(&patch)
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
