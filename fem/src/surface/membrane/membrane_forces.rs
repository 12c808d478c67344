//! Nodal forces and stiffness of a membrane.

use super::layers::Membrane;
use crate::surface::surface_law::InPlane;
use crate::tensor::{Tensor, Vector};

impl Membrane {
    /// Adds one face's nodal forces (N) and, when asked for, its stiffness (N/mm, upper triangle by rows) to the buffers.
    pub fn integrate(
        &self,
        face: usize,
        displacement: &[Vector],
        residual: &mut [f64],
        stiffness: Option<&mut [f64]>,
    ) {
        let mut stiffness = stiffness;
        for point in 0..self.points_per_face {
            let area = self.areas[face * self.points_per_face + point];
            let gradients = self.shape_gradients(face, point, displacement.len());
            let (current, strain) = self.kinematics(face, point, displacement);
            let (tensions, moduli) = self.response(&strain);
            let s = [[tensions[0], tensions[2]], [tensions[2], tensions[1]]];
            let forces = s.map(|row| {
                [0, 1, 2].map(|i| area * (row[0] * current[0][i] + row[1] * current[1][i]))
            });
            for (force, n) in residual.chunks_exact_mut(3).zip(gradients) {
                for i in 0..3 {
                    force[i] += n[0] * forces[0][i] + n[1] * forces[1][i];
                }
            }
            if let Some(stiffness) = stiffness.as_deref_mut() {
                add_stiffness(gradients, &blocks(area, &current, &s, &moduli), stiffness);
            }
        }
    }
}

/// Component of a tension or strain that belongs to a pair of axes.
const COMPONENT: [[usize; 2]; 2] = [[0, 2], [2, 1]];

/// The tensors that N_a,A N_b,B multiply, by A and B.
fn blocks(
    area: f64,
    current: &[Vector; 2],
    s: &[[f64; 2]; 2],
    moduli: &[InPlane; 3],
) -> [[Tensor; 2]; 2] {
    [0, 1].map(|a| {
        [0, 1].map(|b| {
            let mut block = [[0.0; 3]; 3];
            for c in 0..2 {
                for d in 0..2 {
                    let modulus = area * moduli[COMPONENT[a][c]][COMPONENT[b][d]];
                    for i in 0..3 {
                        for j in 0..3 {
                            block[i][j] += modulus * current[c][i] * current[d][j];
                        }
                    }
                }
            }
            for (i, row) in block.iter_mut().enumerate() {
                row[i] += area * s[a][b];
            }
            block
        })
    })
}

/// Adds the sum over A and B of N_a,A N_b,B `blocks`_AB to the upper triangle of a matrix stored by rows.
fn add_stiffness(gradients: &[[f64; 2]], blocks: &[[Tensor; 2]; 2], stiffness: &mut [f64]) {
    let unknowns = 3 * gradients.len();
    for (row_node, n) in gradients.iter().enumerate() {
        // The rows of this node: N_a,A blocks_AB, one tensor for each B.
        let rows = [0, 1].map(|b| {
            let [first, second] = [&blocks[0][b], &blocks[1][b]];
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| n[0] * first[i][j] + n[1] * second[i][j]))
        });
        for i in 0..3 {
            let row = 3 * row_node + i;
            let target = &mut stiffness[row * unknowns..(row + 1) * unknowns];
            for (column_node, m) in gradients.iter().enumerate().skip(row_node) {
                for j in 0..3 {
                    target[3 * column_node + j] += m[0] * rows[0][i][j] + m[1] * rows[1][i][j];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::element::Order;
    use crate::cell::mesh::{Mesh, Surface};
    use crate::central_differences::{assert_upper_agrees, derivative};
    use crate::surface::surface_law::{FibreFamily, SurfaceLaw};
    use crate::tensor::dot;

    fn family(angle: f64) -> FibreFamily {
        FibreFamily {
            angle,
            stiffness: 100.0,
            compression_ratio: 0.01,
        }
    }

    fn layers() -> Vec<Box<dyn SurfaceLaw>> {
        vec![Box::new(family(0.9)), Box::new(family(-0.9))]
    }

    fn along_x(_: &Vector, _: &Vector) -> Vector {
        [1.0, 0.0, 0.0]
    }

    /// A square of side 1 in the plane z = 0.
    fn square(order: Order) -> (Mesh, Surface) {
        let n = order.edge_nodes();
        let line = |i: usize| i as f64 / (n - 1) as f64;
        let nodes = (0..n * n).map(|a| [line(a % n), line(a / n), 0.0]);
        let mesh = Mesh {
            order,
            nodes: nodes.collect(),
            bricks: vec![],
        };
        let faces = (0..(n * n) as u32).collect();
        (mesh, Surface { order, faces })
    }

    /// A bent quadratic face and displacements of 20 %.
    fn bent_face() -> (Mesh, Surface, Vec<Vector>) {
        let (mut mesh, surface) = square(Order::Quadratic);
        for (a, x) in mesh.nodes.iter_mut().enumerate() {
            *x = [2.0 * x[0], 2.4 * x[1], 0.1 * (a * a % 5) as f64];
        }
        let displace = |x: &Vector| {
            let [x, y, _] = *x;
            [0.2 * x + 0.02 * y * y, 0.15 * y, 0.05 * x * y]
        };
        let displacement = mesh.nodes.iter().map(displace).collect();
        (mesh, surface, displacement)
    }

    fn forces(membrane: &Membrane, displacement: &[Vector]) -> Vec<f64> {
        let mut residual = vec![0.0; 3 * displacement.len()];
        membrane.integrate(0, displacement, &mut residual, None);
        residual
    }

    /// Force along x on the edge x = 1 of the unit square under the stretches (l1, l2).
    fn edge_force(law: Box<dyn SurfaceLaw>, l1: f64, l2: f64) -> f64 {
        let (mesh, surface) = square(Order::Linear);
        let membrane = Membrane::new(&mesh, surface, &along_x, vec![law]);
        let stretch = |x: &Vector| [(l1 - 1.0) * x[0], (l2 - 1.0) * x[1], 0.0];
        let displacement: Vec<Vector> = mesh.nodes.iter().map(stretch).collect();
        let forces = forces(&membrane, &displacement);
        forces[3] + forces[9]
    }

    /// A family at angle t has stretch sqrt(l^2 cos^2 + sin^2); the force along x follows from the energy of the square.
    #[test]
    fn a_stretched_square_of_fibres_gives_the_closed_form_force() {
        let (angle, l) = (0.7f64, 1.1f64);
        let force = edge_force(Box::new(family(angle)), l, 1.0);
        let stretch = (l * l * angle.cos().powi(2) + angle.sin().powi(2)).sqrt();
        let expected = 100.0 * (stretch - 1.0) * l * angle.cos().powi(2) / stretch;
        assert!((force - expected).abs() < 1e-13 * expected);
    }

    #[test]
    fn stiffness_is_the_derivative_of_the_forces() {
        let (mesh, surface, displacement) = bent_face();
        let membrane = Membrane::new(&mesh, surface, &along_x, layers());
        let mut stiffness = vec![0.0; 27 * 27];
        membrane.integrate(0, &displacement, &mut [0.0; 27], Some(&mut stiffness));
        // Truncation, h^2 times a third derivative, and round-off, eps f / h, with forces of order 100.
        let differences = derivative(&displacement, 1e-5, |moved| forces(&membrane, moved));
        assert_upper_agrees(&stiffness, &differences, 1e-6);
    }

    #[test]
    fn a_rotation_of_the_whole_turns_the_forces() {
        let (mesh, surface, displacement) = bent_face();
        let membrane = Membrane::new(&mesh, surface, &along_x, layers());
        let q = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]];
        let turn = |x: &Vector| q.map(|row| dot(&row, x));
        let turned = mesh.nodes.iter().zip(&displacement).map(|(x, u)| {
            let moved = turn(&[0, 1, 2].map(|i| x[i] + u[i]));
            [0, 1, 2].map(|i| moved[i] - x[i])
        });
        let turned: Vec<Vector> = turned.collect();
        let (here, there) = (forces(&membrane, &displacement), forces(&membrane, &turned));
        for (f, g) in here.chunks_exact(3).zip(there.chunks_exact(3)) {
            let expected = turn(&[f[0], f[1], f[2]]);
            for i in 0..3 {
                // Round-off of stiffnesses of order 100 at strains of order one.
                assert!((g[i] - expected[i]).abs() < 1e-12 * 100.0);
            }
        }
    }
}
