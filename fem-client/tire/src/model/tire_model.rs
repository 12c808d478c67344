//! A tire scene, ready to be solved.

use fem::load::obstacle::{GroundAxes, HeightField};
use fem::problem::{Problem, State};
use fem::surface::chart::Chart;
use fem::surface::membrane::Membrane;
use fem::surface::sheet::Sheet;
use fem_client::scene::{Ground, Scene};
use fem_client::solver::ModelSummary;

use super::boundary_values::problem;
use super::choices::{left_out, modelled};
use super::dimensions::shape;
use super::glued_film::Place;
use super::resting_ground::{ground_axes, profiled_ground};
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
            Extent::Half | Extent::Front => 2.0,
            Extent::Quarter => 4.0,
        }
    }

    /// Radius of the crown's outer surface at the contact centre in a state without contact, mm.
    pub fn crown_radius(&self, state: &State) -> f64 {
        -state.position(&self.problem.mesh, self.grid.lowest_node())[2]
    }

    /// The ground of a scene below a state without contact.
    pub fn ground_below(&self, ground: &Ground, state: &State) -> HeightField {
        let distance = self.touching_distance(state, &ground_axes(ground));
        profiled_ground(ground, distance, self.grid.shape.centre_radius)
    }

    /// Distance of ground with these axes from the axle's middle at which it first touches a state without contact, mm.
    fn touching_distance(&self, state: &State, axes: &GroundAxes) -> f64 {
        if *axes == GroundAxes::LEVEL {
            return self.crown_radius(state);
        }
        let below = |node: u32| {
            let [_, _, z] = axes.coordinates(state.position(&self.problem.mesh, node));
            -z
        };
        let section: Vec<f64> = self.grid.outer_section().into_iter().map(below).collect();
        let along_edge = self.grid.order.edge_nodes() - 1;
        let edges = section.windows(along_edge + 1).step_by(along_edge);
        edges.map(largest).fold(f64::NEG_INFINITY, f64::max)
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
            Extent::Half | Extent::Front => "3d-half",
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

/// Largest value on an edge whose nodes have these: two, or three at even distances.
fn largest(edge: &[f64]) -> f64 {
    let ends = edge.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let &[first, middle, last] = edge else {
        return ends;
    };
    let (slope, bend) = (0.5 * (last - first), 0.5 * (first + last) - middle);
    // The vertex lies on the edge where the value falls to both sides.
    if bend < 0.0 && slope.abs() < -2.0 * bend {
        middle - 0.25 * slope * slope / bend
    } else {
        ends
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
    if !grid.extent.is_whole_across() {
        mirrors.push((1, 0.0));
    }
    if !grid.extent.is_whole_along() {
        mirrors.extend([(0, 0.0), (0, 0.5 * circumference)]);
    }
    Chart {
        surface: grid.inner_surface(),
        coordinates: grid.inner_chart(),
        mirrors,
        period: grid.extent.is_whole_along().then_some(circumference),
    }
}
