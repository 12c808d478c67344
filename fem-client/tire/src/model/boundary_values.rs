//! The boundary value problem of a scene.

use fem::load::contact::ContactSurface;
use fem::load::pressure::PressureSurface;
use fem::problem::Problem;
use fem::solid::SolidModel;
use fem_client::scene::Scene;

use super::carcass_layer::membranes;
use super::glued_film::glued_film;
use super::resting_ground::{friction, penalty};
use crate::mesh::tire_grid::TireGrid;
use crate::rubber::isochoric;

/// The boundary value problem of a scene on a grid.
pub(super) fn problem(scene: &Scene, grid: &TireGrid) -> Problem {
    let (mut mesh, layout) = grid.mesh();
    let membranes = membranes(scene, grid, &mesh);
    let sheet = glued_film(scene, grid, &mesh);
    mesh.nodes
        .extend(sheet.iter().flat_map(|sheet| &sheet.positions));
    let supports = supports(grid, mesh.nodes.len());
    let mut contact = ContactSurface::new(&mesh, grid.tread_surface(), penalty(scene));
    contact.friction = friction(scene);
    contact.may_push_across = scene.ground.may_push_across();
    let pressure = PressureSurface::new(grid.inner_surface());
    Problem {
        mesh,
        layout,
        solid: solid(scene),
        membranes,
        sheet,
        supports,
        pressure: Some(pressure),
        contact: Some(contact),
        dead_forces: vec![],
    }
}

fn solid(scene: &Scene) -> SolidModel {
    SolidModel {
        material: isochoric(&scene.material.law),
        compliance: 0.5 * scene.material.d1_per_mpa,
    }
}

/// Bead clamped, symmetry planes kept plane.
fn supports(grid: &TireGrid, nodes: usize) -> Vec<[Option<f64>; 3]> {
    let mut supports = vec![[None; 3]; nodes];
    let held = grid.held_nodes();
    for node in held.middle_plane {
        supports[node as usize][1] = Some(0.0);
    }
    for node in held.cross_plane {
        supports[node as usize][0] = Some(0.0);
    }
    for node in held.bead {
        supports[node as usize] = [Some(0.0); 3];
    }
    supports
}
