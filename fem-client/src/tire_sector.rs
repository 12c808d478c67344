//! A sector of a tire's mesh between two of its sections: its grid, and states cut out of the whole and put back.

use std::f64::consts::TAU;

use fem::problem::State;

use crate::tire_mesh::{Extent, TireGrid};

/// Neighbouring bricks along the wheel.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TireSector {
    pub(crate) grid: TireGrid,
    /// Node lines along the wheel, in the numbers of the whole.
    lines: Vec<usize>,
    /// Rows of bricks, in the numbers of the whole.
    rows: Vec<usize>,
}

/// The sector around the contact centre that reaches a wheel angle (rad) and what is beyond it; `None` when nothing is.
pub(crate) fn near_and_far(whole: &TireGrid, angle: f64) -> Option<[TireSector; 2]> {
    let count = whole.bricks()[1];
    let reached = |edges: &[f64]| {
        edges
            .iter()
            .filter(|&&edge| edge > 0.0 && edge < angle)
            .count()
            + 1
    };
    let (centre, half) = match whole.extent {
        Extent::Quarter => (0, count),
        Extent::Half | Extent::Full => (count / 2, count / 2),
    };
    let near = reached(&whole.theta);
    if near >= half {
        return None;
    }
    let (first, width) = match whole.extent {
        Extent::Quarter => (0, near),
        Extent::Half | Extent::Full => (centre - near, 2 * near),
    };
    Some([
        TireSector::new(whole, first, width),
        TireSector::new(whole, centre + near, count - width),
    ])
}

impl TireSector {
    fn new(whole: &TireGrid, first: usize, count: usize) -> Self {
        let e = whole.order.edge_nodes() - 1;
        let total = whole.bricks()[1];
        let edge = |k: usize| match k.checked_sub(total) {
            Some(beyond) if beyond > 0 => whole.theta[beyond] + TAU,
            _ => whole.theta[k],
        };
        Self {
            grid: TireGrid {
                is_closed: false,
                theta: (first..=first + count).map(edge).collect(),
                ..whole.clone()
            },
            lines: (first * e..=(first + count) * e)
                .map(|line| line % whole.theta_nodes())
                .collect(),
            rows: (first..first + count).map(|row| row % total).collect(),
        }
    }

    /// The sector's nodes in the sections that it shares with the other one.
    pub(crate) fn shared_nodes(&self, other: &Self) -> Vec<u32> {
        let is_shared = |line: &usize| other.lines.contains(line);
        let mut shared: Vec<usize> = self.lines.iter().copied().filter(is_shared).collect();
        shared.sort_unstable();
        let place = |line: usize| self.lines.iter().position(|own| *own == line);
        let places = shared.into_iter().filter_map(place);
        places.flat_map(|line| self.grid.section(line)).collect()
    }

    /// The sector's part of a state of the whole.
    pub(crate) fn cut(&self, state: &State) -> State {
        let (line, row) = self.sizes();
        let displacement = self.lines.iter();
        let pressure = self.rows.iter();
        State {
            displacement: displacement
                .flat_map(|k| state.displacement[k * line..(k + 1) * line].to_vec())
                .collect(),
            pressure: pressure
                .flat_map(|k| state.pressure[k * row..(k + 1) * row].to_vec())
                .collect(),
            anchors: Vec::new(),
        }
    }

    /// Puts a state of the sector into one of the whole.
    pub(crate) fn paste(&self, part: &State, whole: &mut State) {
        let (line, row) = self.sizes();
        for (k, values) in self.lines.iter().zip(part.displacement.chunks_exact(line)) {
            whole.displacement[k * line..(k + 1) * line].copy_from_slice(values);
        }
        for (k, values) in self.rows.iter().zip(part.pressure.chunks_exact(row)) {
            whole.pressure[k * row..(k + 1) * row].copy_from_slice(values);
        }
    }

    /// Nodes of a line and pressures of a row of bricks.
    fn sizes(&self) -> (usize, usize) {
        let [phi, _, rho] = self.grid.bricks();
        let line = self.grid.phi_nodes() * self.grid.rho_nodes();
        (line, phi * rho * self.grid.order.pressure_modes())
    }
}

#[cfg(test)]
mod tests {
    use fem::element::Order;

    use super::*;
    use crate::tire_mesh::tests::{SHAPE, plan};

    #[test]
    fn near_and_far_are_the_whole() {
        for (order, extent) in [
            (Order::Linear, Extent::Half),
            (Order::Quadratic, Extent::Half),
            (Order::Quadratic, Extent::Quarter),
        ] {
            let whole = TireGrid::new(SHAPE, &plan(order), extent);
            let (mesh, _) = whole.mesh();
            let pressures = mesh.brick_count() * order.pressure_modes();
            let state = State {
                displacement: mesh.nodes.clone(),
                pressure: (0..pressures).map(|k| k as f64).collect(),
                anchors: vec![],
            };
            let parts = near_and_far(&whole, 0.5).expect("0.5 rad is less than pi");
            let mut joined = State {
                displacement: vec![[f64::NAN; 3]; mesh.nodes.len()],
                pressure: vec![f64::NAN; pressures],
                anchors: vec![],
            };
            for part in &parts {
                let cut = part.cut(&state);
                let (own, _) = part.grid.mesh();
                for (a, b) in own
                    .nodes
                    .iter()
                    .flatten()
                    .zip(cut.displacement.iter().flatten())
                {
                    // Sines and cosines of angles a turn apart, rounded.
                    assert!((a - b).abs() < 1e-13, "{order:?} {extent:?}");
                }
                part.paste(&cut, &mut joined);
            }
            assert_eq!(joined, state);
            let [near, far] = &parts;
            let shared = [near.shared_nodes(far), far.shared_nodes(near)];
            let sections = if extent == Extent::Half { 2 } else { 1 };
            assert_eq!(
                shared[0].len(),
                sections * whole.phi_nodes() * whole.rho_nodes()
            );
            let [(near_mesh, _), (far_mesh, _)] = [near.grid.mesh(), far.grid.mesh()];
            for (a, b) in shared[0].iter().zip(&shared[1]) {
                let (a, b) = (near_mesh.nodes[*a as usize], far_mesh.nodes[*b as usize]);
                assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-13), "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn a_sector_ends_at_the_next_section() {
        let whole = TireGrid::new(SHAPE, &plan(Order::Linear), Extent::Half);
        let [near, far] = near_and_far(&whole, 0.3).expect("0.3 rad is less than pi");
        let end = near.grid.theta[near.grid.theta.len() - 1];
        assert!(end >= 0.3 && near.grid.theta[near.grid.theta.len() - 2] < 0.3);
        assert_eq!(near.grid.theta[0], -end);
        assert_eq!(far.grid.theta[0], end);
        assert!(near_and_far(&whole, 3.1).is_none());
    }
}
