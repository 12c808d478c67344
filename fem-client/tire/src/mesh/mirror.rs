//! States of a tire mesh, mirrored about the contact centre or the wheel's middle plane.
//!
//! The first mirror changes the sign of theta, and with it of the displacement along x and of the pressure mode along theta; the second that of phi, of the
//! displacement along y and of the mode along phi.

use crate::mesh::tire_grid::{Extent, TireGrid};

/// The pressure modes along phi and theta; the modes are 1, phi, theta, rho along the brick's own axes.
const PHI_MODE: usize = 1;
const THETA_MODE: usize = 2;

impl TireGrid {
    /// Whether its lines before the contact centre mirror those behind it: those of a film aside of it don't.
    fn is_even(&self) -> bool {
        let mirrored = self.theta.iter().rev();
        // Lines that make room for a film are rounded on each side by themselves.
        let lines = self.theta.iter().zip(mirrored);
        lines.into_iter().all(|(a, b)| (a + b).abs() < 1e-12)
    }

    /// Unknowns (mm, then MPa) of the quarter mesh with this one's grid lines, mirrored to this half mesh. `None` when this is no half mesh, its lines aren't even or the length doesn't fit.
    pub(crate) fn mirror_quarter(&self, quarter: &[f64]) -> Option<Vec<f64>> {
        if self.extent != Extent::Half || !self.is_even() {
            return None;
        }
        let e = self.order.edge_nodes() - 1;
        let [nphi, ntheta, nrho] = self.bricks();
        let modes = self.order.pressure_modes();
        let (line, half) = (self.phi_nodes() * self.rho_nodes(), ntheta / 2);
        let displacements = 3 * line * (e * half + 1);
        if quarter.len() != displacements + modes * nphi * nrho * half {
            return None;
        }
        let (displacement, pressure) = quarter.split_at(displacements);
        let mut flat = Vec::with_capacity(2 * quarter.len());
        for theta in 0..self.theta_nodes() {
            let offset = theta.abs_diff(e * half);
            for u in displacement[3 * line * offset..3 * line * (offset + 1)].chunks_exact(3) {
                flat.extend([if theta < e * half { -u[0] } else { u[0] }, u[1], u[2]]);
            }
        }
        let row = modes * nphi * nrho;
        for theta in 0..ntheta {
            let source = if theta < half {
                half - 1 - theta
            } else {
                theta - half
            };
            for p in pressure[row * source..row * (source + 1)].chunks_exact(modes) {
                flat.extend(p.iter().enumerate().map(|(mode, &p)| {
                    if mode == THETA_MODE && theta < half {
                        -p
                    } else {
                        p
                    }
                }));
            }
        }
        Some(flat)
    }

    /// Unknowns (mm, then MPa) of the mesh with the lines of this one on one side of the middle plane, mirrored to this one, which has both. `None` when this one hasn't
    /// or the length doesn't fit.
    pub(crate) fn mirror_across(&self, side: &[f64]) -> Option<Vec<f64>> {
        if !self.extent.is_whole_across() {
            return None;
        }
        let e = self.order.edge_nodes() - 1;
        let [nphi, ntheta, nrho] = self.bricks();
        let (half, modes) = (nphi / 2, self.order.pressure_modes());
        let (line, stack) = (3 * self.rho_nodes(), modes * nrho);
        let section = line * (e * half + 1);
        let displacements = section * self.theta_nodes();
        if side.len() != displacements + stack * half * ntheta {
            return None;
        }
        let (displacement, pressure) = side.split_at(displacements);
        let mut flat = Vec::with_capacity(2 * side.len());
        for section in displacement.chunks_exact(section) {
            for phi in 0..self.phi_nodes() {
                let (offset, is_image) = (phi.abs_diff(e * half), phi < e * half);
                for u in section[line * offset..line * (offset + 1)].chunks_exact(3) {
                    flat.extend([u[0], if is_image { -u[1] } else { u[1] }, u[2]]);
                }
            }
        }
        for row in pressure.chunks_exact(stack * half) {
            for phi in 0..nphi {
                let is_image = phi < half;
                let source = if is_image { half - 1 - phi } else { phi - half };
                let bricks = row[stack * source..stack * (source + 1)].chunks_exact(modes);
                flat.extend(bricks.flatten().enumerate().map(|(k, &p)| {
                    let is_turned = is_image && k % modes == PHI_MODE;
                    if is_turned { -p } else { p }
                }));
            }
        }
        Some(flat)
    }

    /// Unknowns (mm, then MPa) of this half mesh, left and right exchanged. `None` when this is no half mesh, its lines aren't even or the length doesn't fit.
    pub(crate) fn mirror_half(&self, flat: &[f64]) -> Option<Vec<f64>> {
        let [nphi, ntheta, nrho] = self.bricks();
        let modes = self.order.pressure_modes();
        let line = 3 * self.phi_nodes() * self.rho_nodes();
        let lines = self.theta_nodes();
        let row = modes * nphi * nrho;
        let fits = flat.len() == line * lines + row * ntheta;
        if self.extent != Extent::Half || !self.is_even() || !fits {
            return None;
        }
        let (displacement, pressure) = flat.split_at(line * lines);
        let mut mirrored = Vec::with_capacity(flat.len());
        for theta in 0..lines {
            let source = (lines - theta) % lines;
            for u in displacement[line * source..line * (source + 1)].chunks_exact(3) {
                mirrored.extend([-u[0], u[1], u[2]]);
            }
        }
        for theta in 0..ntheta {
            let source = ntheta - 1 - theta;
            for p in pressure[row * source..row * (source + 1)].chunks_exact(modes) {
                let signed = |(mode, &p): (usize, &f64)| if mode == THETA_MODE { -p } else { p };
                mirrored.extend(p.iter().enumerate().map(signed));
            }
        }
        Some(mirrored)
    }
}

#[cfg(test)]
mod tests {
    use fem::cell::element::Order;

    use super::*;
    use crate::mesh::tire_grid::{MeshPlan, TireShape};

    const SHAPE: TireShape = TireShape {
        centre_radius: 37.5,
        inner: 9.5,
        outer: 12.5,
        bead_angle: 2.0,
        carcass: None,
    };
    const PLAN: MeshPlan = MeshPlan {
        order: Order::Quadratic,
        fine_angle: 0.3,
        fine: 2,
        middle: None,
        coarse: 2,
        meridional: 2,
        meridional_growth: 2.0,
        layers: 1,
    };

    fn grid() -> TireGrid {
        TireGrid::new(SHAPE, &PLAN, Extent::Half)
    }

    #[test]
    fn mirrored_nodes_are_mirrored_positions() {
        let grid = grid();
        let (mesh, _) = grid.mesh();
        let pressures = mesh.brick_count() * mesh.order.pressure_modes();
        let positions: Vec<f64> = mesh
            .nodes
            .iter()
            .flatten()
            .copied()
            .chain(vec![0.0; pressures])
            .collect();
        let mirrored = grid.mirror_half(&positions).unwrap();
        for (a, b) in positions.iter().zip(&mirrored) {
            // Sines and cosines of opposite angles, rounded.
            assert!((a - b).abs() < 1e-13);
        }
    }

    #[test]
    fn both_sides_are_the_mirror_images_of_one() {
        for along in [false, true] {
            let extents = [false, true].map(|across| Extent::of(along, across));
            let [one, both] = extents.map(|extent| TireGrid::new(SHAPE, &PLAN, extent));
            let (mesh, _) = one.mesh();
            let modes = mesh.order.pressure_modes();
            let pressures = (0..mesh.brick_count() * modes).map(|k| k as f64);
            let positions = mesh.nodes.iter().flatten().copied().chain(pressures);
            let positions: Vec<f64> = positions.collect();
            let mirrored = both.mirror_across(&positions).unwrap();
            let (whole, _) = both.mesh();
            let nodes = 3 * whole.nodes.len();
            for (a, b) in whole.nodes.iter().flatten().zip(&mirrored) {
                assert!((a - b).abs() < 1e-13);
            }
            // A column of two bricks along phi has twice as many either side of the crown.
            let [image, own] = [0, PLAN.meridional].map(|phi| nodes + modes * phi);
            let first = |k: usize| mirrored[k..k + modes].to_vec();
            let last = first(image + modes * (PLAN.meridional - 1));
            assert_eq!(first(own), [0.0, 1.0, 2.0, 3.0]);
            assert_eq!(last, [0.0, -1.0, 2.0, 3.0]);
            assert_eq!(one.mirror_across(&positions), None);
            assert_eq!(both.mirror_across(&positions[1..]), None);
        }
    }

    #[test]
    fn a_grid_that_is_not_even_is_never_mirrored() {
        let mut grid = grid();
        let quarter = TireGrid {
            extent: Extent::Quarter,
            is_closed: false,
            theta: grid.theta[4..].to_vec(),
            ..grid.clone()
        };
        let (mesh, _) = quarter.mesh();
        let size = 3 * mesh.nodes.len() + mesh.brick_count() * mesh.order.pressure_modes();
        assert!(grid.mirror_quarter(&vec![0.0; size]).is_some());
        // A line more on one side.
        grid.theta.insert(5, 0.5 * (grid.theta[4] + grid.theta[5]));
        assert_eq!(grid.mirror_quarter(&vec![0.0; size]), None);
        let (mesh, _) = grid.mesh();
        let size = 3 * mesh.nodes.len() + mesh.brick_count() * mesh.order.pressure_modes();
        assert_eq!(grid.mirror_half(&vec![0.0; size]), None);
    }

    #[test]
    fn mirroring_twice_changes_nothing() {
        let grid = grid();
        let (mesh, _) = grid.mesh();
        let size = 3 * mesh.nodes.len() + mesh.brick_count() * mesh.order.pressure_modes();
        let state: Vec<f64> = (0..size).map(|k| (k as f64).sin()).collect();
        let once = grid.mirror_half(&state).unwrap();
        assert_ne!(once, state);
        assert_eq!(grid.mirror_half(&once).unwrap(), state);
        assert_eq!(grid.mirror_half(&state[1..]), None);
    }
}
