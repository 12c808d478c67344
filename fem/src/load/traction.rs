//! Dead tractions: forces per reference area that keep their direction as the body moves.

use crate::cell::element::face_points;
use crate::cell::mesh::{Mesh, Surface};
use crate::tensor::{Vector, cross, norm};

/// Consistent nodal forces of a uniform traction (MPa) on a surface: the integral of N_a t over the reference area, N.
pub fn nodal_forces(mesh: &Mesh, surface: &Surface, traction: Vector) -> Vec<(u32, Vector)> {
    let rule = face_points(surface.order, surface.order.edge_nodes());
    let mut forces = Vec::with_capacity(surface.faces.len());
    for face in surface.iter() {
        let nodes: Vec<Vector> = face.iter().map(|&n| mesh.nodes[n as usize]).collect();
        let areas = rule.iter().map(|point| {
            let [t1, t2] = point.tangents(&nodes);
            point.weight * norm(&cross(&t1, &t2))
        });
        let areas: Vec<f64> = areas.collect();
        for (local, &node) in face.iter().enumerate() {
            let points = rule.iter().zip(&areas);
            let share: f64 = points.map(|(point, area)| area * point.values[local]).sum();
            forces.push((node, traction.map(|t| share * t)));
        }
    }
    forces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::element::Order;

    #[test]
    fn a_line_of_order_two_takes_a_sixth_and_two_thirds() {
        let order = Order::PlaneQuadratic;
        let mesh = Mesh {
            order,
            nodes: vec![[0.0; 3], [1.5, 0.0, 2.0], [3.0, 0.0, 4.0]],
            bricks: vec![],
        };
        let faces = vec![0, 1, 2];
        let forces = nodal_forces(&mesh, &Surface { order, faces }, [0.0, 0.0, 6.0]);
        // Length 5, thickness 1.
        for ((_, force), share) in forces.iter().zip([1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0]) {
            assert!((force[2] - 30.0 * share).abs() < 1e-13, "{force:?}");
        }
    }
}
