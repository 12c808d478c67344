//! Surfaces of a tire mesh: inner surface, carcass and tread, and the points of the inner surface by their angles.

use fem::cell::mesh::{Surface, SurfacePoint};

use crate::mesh::grid_lines::locate;
use crate::mesh::tire_grid::TireGrid;

impl TireGrid {
    /// Faces of a layer boundary, 0 the inner surface, ordered by theta, then phi; their normal x,1 x x,2 points outward.
    fn layer(&self, boundary: usize, keep: impl Fn(f64) -> bool) -> Surface {
        let [nphi, ntheta, _] = self.bricks();
        let e = self.order.edge_nodes();
        let rho = boundary * (e - 1);
        let mut faces = Vec::new();
        for theta in (0..ntheta).filter(|&t| keep(self.theta[t]) || keep(self.theta[t + 1])) {
            for phi in 0..nphi {
                for j in 0..e {
                    for i in 0..e {
                        faces.push(self.node([phi * (e - 1) + i, theta * (e - 1) + j, rho]));
                    }
                }
            }
        }
        Surface {
            order: self.order,
            faces,
        }
    }

    /// The inner surface.
    pub fn inner_surface(&self) -> Surface {
        self.layer(0, |_| true)
    }

    /// The layer boundary that carries the carcass.
    pub fn carcass_surface(&self) -> Option<Surface> {
        let carcass = self.shape.carcass?;
        let boundary = (0..self.rho.len()).min_by(|&a, &b| {
            (self.rho[a] - carcass)
                .abs()
                .total_cmp(&(self.rho[b] - carcass).abs())
        })?;
        Some(self.layer(boundary, |_| true))
    }

    /// The lower half of the outer surface: all that can come down on a ground below the wheel.
    pub(crate) fn tread_surface(&self) -> Surface {
        self.layer(self.rho.len() - 1, |theta| theta.cos() > 0.0)
    }

    /// Chart coordinates of the inner surface's face nodes: arc lengths (circumferential at the crown, meridional).
    pub(crate) fn inner_chart(&self) -> Vec<[f64; 2]> {
        let [nphi, ntheta, _] = self.bricks();
        let e = self.order.edge_nodes();
        let mut coordinates = Vec::new();
        for theta in 0..ntheta {
            for phi in 0..nphi {
                for j in 0..e {
                    for i in 0..e {
                        let angles = (
                            self.line(&self.theta, theta * (e - 1) + j),
                            self.line(&self.phi, phi * (e - 1) + i),
                        );
                        coordinates
                            .push([angles.0 * self.crown_radius(), angles.1 * self.shape.inner]);
                    }
                }
            }
        }
        coordinates
    }

    /// Radius of the inner surface at the crown, mm.
    pub fn crown_radius(&self) -> f64 {
        self.shape.centre_radius + self.shape.inner
    }

    /// Whether the wheel angle (rad) lies beyond the plane x = 0 of a quarter mesh.
    pub fn is_mirrored(&self, theta: f64) -> bool {
        !self.extent.is_whole_along() && wrapped(theta) < 0.0
    }

    /// Whether the section angle (rad) lies beyond the plane y = 0 of a mesh that ends there.
    pub(crate) fn is_mirrored_across(&self, phi: f64) -> bool {
        !self.extent.is_whole_across() && phi < 0.0
    }

    /// The point of the inner surface at these angles (rad); mirrored into the meshed part.
    pub fn inner_point(&self, theta: f64, phi: f64) -> SurfacePoint {
        let theta = if !self.extent.is_whole_along() {
            wrapped(theta).abs()
        } else {
            wrapped(theta)
        };
        let (row, local_theta) = locate(&self.theta, theta);
        let phi = match self.extent.is_whole_across() {
            true => phi,
            false => phi.abs(),
        };
        let (column, local_phi) = locate(&self.phi, phi);
        SurfacePoint {
            face: row * (self.phi.len() - 1) + column,
            local: [local_phi, local_theta],
        }
    }
}

/// A wheel angle (rad), between minus and plus half a turn.
fn wrapped(theta: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    theta - turn * (theta / turn).round()
}

#[cfg(test)]
mod tests {
    use fem::cell::element::Order;

    use super::*;
    use crate::mesh::tire_grid::Extent;
    use crate::mesh::tire_grid::tests::{SHAPE, plan};

    #[test]
    fn a_point_of_the_inner_surface_is_where_its_angles_say() {
        for extent in [Extent::Half, Extent::Quarter] {
            let grid = TireGrid::new(SHAPE, &plan(Order::Quadratic), extent);
            let surface = grid.inner_surface();
            let (mesh, _) = grid.mesh();
            for (theta, phi) in [
                (0.0, 0.0),
                (0.11, 0.3),
                (-0.2, 1.2),
                (3.1, 2.0),
                (-3.1, -0.4),
                (4.0, 0.1),
            ] {
                let point = grid.inner_point(theta, phi);
                let (values, _) = fem::cell::element::face_shape(grid.order, point.local);
                let nodes = surface.face(point.face);
                let at = [0, 1, 2].map(|i| {
                    nodes
                        .iter()
                        .zip(&values)
                        .map(|(&n, v)| v * mesh.nodes[n as usize][i])
                        .sum::<f64>()
                });
                let exact = SHAPE.position(theta, phi, SHAPE.inner);
                let mirrored = if extent == Extent::Quarter {
                    exact[0].abs()
                } else {
                    exact[0]
                };
                // Chords of a quadratic edge of angle h stray by R h^3 / 60 (h at most 0.9 far from the contact).
                let tolerance = 47.0 * 0.9f64.powi(3) / 60.0;
                assert!(
                    (at[0] - mirrored).abs() < tolerance && (at[2] - exact[2]).abs() < tolerance
                );
                assert!((at[1] - exact[1].abs()).abs() < 0.02);
            }
        }
    }
}
