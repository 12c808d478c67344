//! Cords of a scene as a membrane on its grid.

use fem::cell::mesh::Mesh;
use fem::surface::membrane::Membrane;
use fem::surface::surface_law::{FibreFamily, SurfaceLaw};
use fem::tensor::Vector;
use fem_client::scene::{Carcass, Scene};

use crate::mesh::tire_grid::TireGrid;

/// The carcass, as far as the scene has one.
pub(super) fn membranes(scene: &Scene, grid: &TireGrid, mesh: &Mesh) -> Vec<Membrane> {
    let carcass = scene.carcass.iter();
    let carcass = carcass.filter_map(|carcass| membrane(carcass, grid, mesh));
    carcass.collect()
}

/// The unit vector along the circumference, in the rolling direction.
fn circumferential(position: &Vector, _normal: &Vector) -> Vector {
    let radius = position[0].hypot(position[2]);
    [-position[2] / radius, 0.0, position[0] / radius]
}

/// Both cord families, at plus and minus their angle to the circumference.
pub fn cord_families(carcass: &Carcass) -> [FibreFamily; 2] {
    [1.0, -1.0].map(|sign| FibreFamily {
        angle: sign * carcass.angle_deg.to_radians(),
        stiffness: carcass.stiffness_n_per_mm,
        compression_ratio: carcass.compression_ratio,
    })
}

fn membrane(carcass: &Carcass, grid: &TireGrid, mesh: &Mesh) -> Option<Membrane> {
    let laws = cord_families(carcass).map(|family| Box::new(family) as Box<dyn SurfaceLaw>);
    Some(Membrane::new(
        mesh,
        grid.carcass_surface()?,
        &circumferential,
        laws.into(),
    ))
}
