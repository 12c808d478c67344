//! Extremes over a whole pressed tire, as the other code prints them.

use fem::cell::element::{brick_points, face_rule, face_shape};
use fem::problem::State;
use fem::tensor::determinant;
use fem_client::scene::Scene;
use fem_client::solver::Extremes;
use tire::model::{TireModel, cord_families};

use super::pressing::{CONTACT_HALF_WIDTH, Pressed};
use super::reading::deformation_gradient;

/// Stretches of the cords; the empty range without carcass.
pub fn cord_stretches(model: &TireModel, scene: &Scene, state: &State) -> Extremes {
    let mut range = Extremes::NONE;
    if let (Some(carcass), Some(layer)) = (&scene.carcass, model.carcass()) {
        for (face, nodes) in layer.surface.iter().enumerate() {
            let displacement = nodes.iter().map(|&node| state.displacement[node as usize]);
            let displacement: Vec<[f64; 3]> = displacement.collect();
            for strain in layer.strains(face, &displacement) {
                for family in cord_families(carcass) {
                    range.include(family.stretch(&strain));
                }
            }
        }
    }
    range
}

/// Least determinant of the deformation gradient at the integration points.
pub fn least_volume_ratio(model: &TireModel, state: &State) -> f64 {
    let mesh = &model.problem.mesh;
    let points = brick_points(mesh.order);
    let bricks = (0..mesh.brick_count()).flat_map(|brick| {
        points.iter().map(move |(point, _)| {
            determinant(&deformation_gradient(&model.problem, state, brick, *point))
        })
    });
    bricks.fold(f64::INFINITY, f64::min)
}

/// Returns how far the contact points that lie below the ground reach along and across the wheel, mm.
pub fn patch(model: &TireModel, pressed: &Pressed) -> [f64; 2] {
    let mesh = &model.problem.mesh;
    let contact = model.problem.contact.as_ref().expect("a tire has a tread");
    let field = pressed.loads.ground.as_ref().expect("it is pressed");
    let rule = face_rule(mesh.order, mesh.order.edge_nodes() + 1);
    let mut reach: [f64; 2] = [0.0; 2];
    for nodes in contact.surface.iter() {
        for (local, _) in &rule {
            let (values, _) = face_shape(mesh.order, *local);
            let position = [0, 1, 2].map(|i| {
                let along = nodes
                    .iter()
                    .map(|&node| pressed.state.position(mesh, node)[i]);
                along.zip(&values).map(|(x, value)| x * value).sum::<f64>()
            });
            if field.height(position[0], 0.0).value - position[2] > CONTACT_HALF_WIDTH {
                reach = [0, 1].map(|i| reach[i].max(position[i].abs()));
            }
        }
    }
    reach
}
