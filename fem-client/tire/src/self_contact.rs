//! Whether a pressed tire touches itself: the model has no contact of the wall with the wall, so a state in which it
//! passes through itself is no equilibrium of a tire.
//!
//! Seen in each meridional section, whose deformed inner surface is a polyline: it touches itself where it crosses the
//! wheel's middle plane, beyond which its mirror image lies, or where two of its edges cross.

use fem::problem::State;

use crate::model::TireModel;

/// Share of the section's radius that the polyline may cross the middle plane by: the crown lies on it, up to round-off.
const ROUND_OFF: f64 = 1e-9;

/// Whether the inner surface touches itself.
pub(crate) fn touches_itself(model: &TireModel, state: &State) -> bool {
    let tolerance = ROUND_OFF * model.grid.crown_radius();
    (0..model.grid.theta_nodes()).any(|theta| {
        let line = section(model, state, theta);
        // A whole section's other half is meshed: it crosses itself there.
        let is_halved = !model.grid.extent.is_whole_across();
        let beyond = is_halved && line.iter().any(|p| p[1] < -tolerance);
        beyond || crosses_itself(&line)
    })
}

/// Radial and lateral coordinates of the inner surface's nodes in one meridional section, from crown (or bead) to bead.
fn section(model: &TireModel, state: &State, theta: usize) -> Vec<[f64; 2]> {
    let mesh = &model.problem.mesh;
    let nodes = (0..model.grid.phi_nodes()).map(|phi| model.grid.inner_node(phi, theta));
    nodes
        .map(|node| {
            let reference = mesh.nodes[node as usize];
            let radius = reference[0].hypot(reference[2]);
            let [x, y, z] = state.position(mesh, node);
            [(x * reference[0] + z * reference[2]) / radius, y]
        })
        .collect()
}

fn crosses_itself(line: &[[f64; 2]]) -> bool {
    let edges: Vec<&[[f64; 2]]> = line.windows(2).collect();
    edges.iter().enumerate().any(|(i, a)| {
        edges[i + 1..]
            .iter()
            .skip(1)
            .any(|b| cross([a[0], a[1]], [b[0], b[1]]))
    })
}

/// Whether two segments cross: each has the other's ends on both sides.
fn cross(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> bool {
    let side = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) < 0.0
        && side(b[0], b[1], a[0]) * side(b[0], b[1], a[1]) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_crosses_itself_and_a_bend_does_not() {
        let bend = [[0.0, 0.0], [1.0, 0.0], [1.5, 1.0], [0.5, 1.2]];
        assert!(!crosses_itself(&bend));
        let looped = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
        assert!(crosses_itself(&looped));
    }
}
