//! Live pressure on a surface: a follower load with its tangent.
//!
//! The virtual work of a pressure p on the deformed surface is p times the integral of n . du da; on a reference face
//! n da = (x,1 x x,2) dxi1 dxi2. For a constant pressure on a surface whose edge is clamped or slides in a symmetry
//! plane the load has the potential -p V, so the assembled tangent is symmetric. A face alone is not: its skew part,
//! which cancels against its neighbours', is left out here.

use crate::cell::element::{FacePoint, face_points};
use crate::cell::mesh::Surface;
use crate::tensor::{Vector, cross};

/// A surface under pressure, oriented so that x,1 x x,2 points where the pressure pushes.
#[derive(Debug)]
pub struct PressureSurface {
    /// Faces under the pressure.
    pub surface: Surface,
    rule: Vec<FacePoint>,
}

impl PressureSurface {
    /// Prepares a surface.
    pub fn new(surface: Surface) -> Self {
        let rule = face_points(surface.order, surface.order.edge_nodes());
        Self { surface, rule }
    }

    /// Adds a face's residual (minus the load, N) under a pressure (MPa) and, when asked for, its symmetric stiffness (N/mm,
    /// upper triangle by rows).
    pub fn integrate(
        &self,
        pressure: f64,
        current: &[Vector],
        residual: &mut [f64],
        stiffness: Option<&mut [f64]>,
    ) {
        let mut stiffness = stiffness;
        for point in &self.rule {
            let [t1, t2] = point.tangents(current);
            let normal = cross(&t1, &t2);
            for (force, n) in residual.chunks_exact_mut(3).zip(&point.values) {
                for i in 0..3 {
                    force[i] -= pressure * point.weight * n * normal[i];
                }
            }
            if let Some(stiffness) = stiffness.as_deref_mut() {
                let scale = -pressure * point.weight;
                add_symmetric_tangent(scale, point, [&t1, &t2], stiffness);
            }
        }
    }

    /// Volume between the surface and the origin, mm^3, signed like the normal: the flux of the position over the number of
    /// directions in which the body extends.
    pub fn enclosed_volume(&self, positions: impl Fn(u32) -> Vector) -> f64 {
        let dimensions = self.surface.order.dimensions() as f64;
        let mut volume = 0.0;
        for face in self.surface.iter() {
            let nodes: Vec<Vector> = face.iter().map(|&n| positions(n)).collect();
            for point in &self.rule {
                let [t1, t2] = point.tangents(&nodes);
                let normal = cross(&t1, &t2);
                let x = [0, 1, 2].map(|i| {
                    nodes
                        .iter()
                        .zip(&point.values)
                        .map(|(x, n)| x[i] * n)
                        .sum::<f64>()
                });
                volume += point.weight * crate::tensor::dot(&x, &normal) / dimensions;
            }
        }
        volume
    }
}

/// The symmetric part of d(N_a n_i)/dx_bj = N_a e_ijk (N_b,1 t2 - N_b,2 t1)_k.
fn add_symmetric_tangent(
    scale: f64,
    point: &FacePoint,
    [t1, t2]: [&Vector; 2],
    stiffness: &mut [f64],
) {
    let nodes = point.values.len();
    let unknowns = 3 * nodes;
    let axis = |b: usize| {
        let g = point.gradients[b];
        [0, 1, 2].map(|k| g[0] * t2[k] - g[1] * t1[k])
    };
    let axes: Vec<Vector> = (0..nodes).map(axis).collect();
    for a in 0..nodes {
        for b in a..nodes {
            // Half of N_a [axis_b] plus its transpose -N_b [axis_a], where [v]_ij = e_ijk v_k.
            let v = [0, 1, 2].map(|k| {
                0.5 * scale * (point.values[a] * axes[b][k] - point.values[b] * axes[a][k])
            });
            let skew = [[0.0, v[2], -v[1]], [-v[2], 0.0, v[0]], [v[1], -v[0], 0.0]];
            for i in 0..3 {
                for j in 0..3 {
                    stiffness[(3 * a + i) * unknowns + 3 * b + j] += skew[i][j];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::element::Order;
    use crate::central_differences::derivative;

    /// Six faces of a cube, outward: the resultant vanishes and the enclosed volume is exact; the assembled tangent of
    /// the closed surface is the exact derivative, although each face's skew part was left out.
    fn cube() -> (Vec<Vector>, PressureSurface) {
        let nodes: Vec<Vector> = (0..8)
            .map(|a| [f64::from(a % 2), f64::from(a / 2 % 2), f64::from(a / 4)])
            .collect();
        let faces = vec![
            0, 2, 1, 3, 4, 5, 6, 7, // z = 0 down, z = 1 up
            0, 1, 4, 5, 2, 6, 3, 7, // y = 0, y = 1
            0, 4, 2, 6, 1, 3, 5, 7, // x = 0, x = 1
        ];
        (
            nodes,
            PressureSurface::new(Surface {
                order: Order::Linear,
                faces,
            }),
        )
    }

    fn assemble(nodes: &[Vector], surface: &PressureSurface) -> (Vec<f64>, Vec<f64>) {
        let (mut force, mut matrix) = (vec![0.0; 24], vec![0.0; 24 * 24]);
        for face in surface.surface.iter() {
            let current: Vec<Vector> = face.iter().map(|&n| nodes[n as usize]).collect();
            let (mut residual, mut stiffness) = (vec![0.0; 12], vec![0.0; 144]);
            surface.integrate(0.7, &current, &mut residual, Some(&mut stiffness));
            let dof = |local: usize| 3 * face[local / 3] as usize + local % 3;
            for r in 0..12 {
                force[dof(r)] += residual[r];
                for c in r..12 {
                    matrix[dof(r) * 24 + dof(c)] += stiffness[r * 12 + c];
                    if r != c {
                        matrix[dof(c) * 24 + dof(r)] += stiffness[r * 12 + c];
                    }
                }
            }
        }
        (force, matrix)
    }

    #[test]
    fn a_closed_surface_encloses_its_volume_without_resultant() {
        let (nodes, surface) = cube();
        assert!((surface.enclosed_volume(|n| nodes[n as usize]) - 1.0).abs() < 1e-15);
        let (force, _) = assemble(&nodes, &surface);
        for axis in 0..3 {
            assert!(force.iter().skip(axis).step_by(3).sum::<f64>().abs() < 1e-15);
        }
    }

    #[test]
    fn the_tangent_of_a_closed_surface_is_exact() {
        let (mut nodes, surface) = cube();
        nodes[3] = [1.1, 0.9, 0.2];
        nodes[4] = [-0.1, 0.05, 0.8];
        let (_, matrix) = assemble(&nodes, &surface);
        // The load is quadratic in the positions, so central differences with a large step are exact.
        let differences = derivative(&nodes, 0.25, |moved| assemble(moved, &surface).0);
        for (exact, difference) in matrix.iter().zip(&differences) {
            assert!((difference - exact).abs() < 1e-15);
        }
    }
}
