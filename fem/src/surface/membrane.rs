//! Elastic layers embedded in the mesh: membranes without thickness or bending.
//!
//! At each integration point the surface has orthonormal reference axes `a1`, `a2` with the derivatives `N,1`, `N,2` of the
//! shape functions along them. With g_A = u,A the current axes are x_A = a_A + g_A, and the strain is free of round-off
//! however far from the origin: 2 E_AB = a_A . g_B + a_B . g_A + g_A . g_B. Nodal forces and stiffness follow from the
//! tensions S and their moduli D:
//!
//! > f_a = S_AB N_a,A x_B,   K_ab = N_a,A N_b,B (D_(AC)(BD) x_C x x_D + S_AB 1).

use crate::cell::element::{FacePoint, face_point, face_rule};
use crate::cell::mesh::{Mesh, Surface};
use crate::surface::surface_law::{InPlane, SurfaceLaw};
use crate::tensor::{Tensor, Vector, cross, dot, norm};

/// First axis of the layers as a function of reference position and unit normal; its tangential part is taken.
pub type Direction<'d> = &'d dyn Fn(&Vector, &Vector) -> Vector;

/// A part of a face: the intervals of its two reference coordinates within -1 and 1.
pub type Window = [[f64; 2]; 2];

/// Layers on a surface of the mesh, ready to be integrated.
#[derive(Debug)]
pub struct Membrane {
    /// The faces that carry the layers.
    pub surface: Surface,
    laws: Vec<Box<dyn SurfaceLaw>>,
    points_per_face: usize,
    /// Derivatives of the shape functions along the axes: face, point, node.
    gradients: Vec<[f64; 2]>,
    /// Reference area of each point: face, point.
    areas: Vec<f64>,
    /// Reference axes: face, point.
    axes: Vec<[Vector; 2]>,
}

impl Membrane {
    /// Puts layers on a surface. The second axis is the normal times the first.
    pub fn new(
        mesh: &Mesh,
        surface: Surface,
        first_axis: Direction<'_>,
        laws: Vec<Box<dyn SurfaceLaw>>,
    ) -> Self {
        let windows = vec![[[-1.0, 1.0]; 2]; surface.face_count()];
        Self::on_windows(mesh, surface, &windows, first_axis, laws)
    }

    /// Puts layers on parts of a surface, one window for each face: its Gauss points are moved into the window.
    ///
    /// # Panics
    /// When there are more windows than faces.
    pub fn on_windows(
        mesh: &Mesh,
        surface: Surface,
        windows: &[Window],
        first_axis: Direction<'_>,
        laws: Vec<Box<dyn SurfaceLaw>>,
    ) -> Self {
        let rule = face_rule(mesh.order, mesh.order.edge_nodes());
        let mut membrane = Self {
            laws,
            points_per_face: rule.len(),
            gradients: Vec::new(),
            areas: Vec::new(),
            axes: Vec::new(),
            surface,
        };
        for (face, [first, second]) in windows.iter().enumerate() {
            let nodes = membrane.surface.face(face).iter();
            let nodes: Vec<Vector> = nodes.map(|&n| mesh.nodes[n as usize]).collect();
            let within = |[low, high]: &[f64; 2], x: f64| 0.5 * ((high + low) + (high - low) * x);
            let share = 0.25 * (first[1] - first[0]) * (second[1] - second[0]);
            for (local, weight) in &rule {
                let local = [within(first, local[0]), within(second, local[1])];
                let point = face_point(mesh.order, local, share * weight);
                membrane.add_point(&nodes, &point, first_axis);
            }
        }
        membrane
    }

    fn add_point(&mut self, nodes: &[Vector], point: &FacePoint, first_axis: Direction<'_>) {
        let [t1, t2] = point.tangents(nodes);
        let normal = cross(&t1, &t2);
        let area = norm(&normal);
        let normal = normal.map(|n| n / area);
        let position = [0, 1, 2].map(|i| {
            let terms = nodes.iter().zip(&point.values);
            terms.map(|(x, n)| x[i] * n).sum::<f64>()
        });
        let direction = first_axis(&position, &normal);
        let out_of_plane = dot(&direction, &normal);
        let tangential = [0, 1, 2].map(|i| direction[i] - out_of_plane * normal[i]);
        let length = norm(&tangential);
        let first = tangential.map(|c| c / length);
        let axes = [first, cross(&normal, &first)];
        // Dual tangents: t2 x n / area and n x t1 / area.
        let duals = [cross(&t2, &normal), cross(&normal, &t1)].map(|t| t.map(|c| c / area));
        let along = axes.map(|axis| [dot(&duals[0], &axis), dot(&duals[1], &axis)]);
        let gradient = |g: &[f64; 2]| along.map(|a| g[0] * a[0] + g[1] * a[1]);
        self.gradients.extend(point.gradients.iter().map(gradient));
        self.areas.push(point.weight * area);
        self.axes.push(axes);
    }

    /// Adds one face's nodal forces and, when asked for, its stiffness (upper triangle by rows) to the buffers.
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

    /// Stiffness of all layers times the root of the area: the force at a strain of order one, N.
    pub fn natural_force(&self) -> f64 {
        let stiffness: f64 = self.laws.iter().map(|law| law.stiffness()).sum();
        stiffness * self.area().sqrt()
    }

    /// Reference area that the layers cover.
    pub fn area(&self) -> f64 {
        self.areas.iter().sum()
    }

    /// Green-Lagrange strains at the integration points of one face.
    pub fn strains(&self, face: usize, displacement: &[Vector]) -> impl Iterator<Item = InPlane> {
        (0..self.points_per_face).map(move |point| self.kinematics(face, point, displacement).1)
    }

    /// Sum of the layers' tensions and moduli.
    fn response(&self, strain: &InPlane) -> (InPlane, [InPlane; 3]) {
        let (mut tensions, mut moduli) = ([0.0; 3], [[0.0; 3]; 3]);
        for law in &self.laws {
            let (s, d) = law.tensions(strain);
            for v in 0..3 {
                tensions[v] += s[v];
                for w in 0..3 {
                    moduli[v][w] += d[v][w];
                }
            }
        }
        (tensions, moduli)
    }

    fn shape_gradients(&self, face: usize, point: usize, nodes: usize) -> &[[f64; 2]] {
        let offset = (face * self.points_per_face + point) * nodes;
        &self.gradients[offset..offset + nodes]
    }

    /// Current axes and Green-Lagrange strain.
    fn kinematics(
        &self,
        face: usize,
        point: usize,
        displacement: &[Vector],
    ) -> ([Vector; 2], InPlane) {
        let axes = &self.axes[face * self.points_per_face + point];
        let mut change = [[0.0; 3]; 2];
        let gradients = self.shape_gradients(face, point, displacement.len());
        for (u, n) in displacement.iter().zip(gradients) {
            for i in 0..3 {
                change[0][i] += n[0] * u[i];
                change[1][i] += n[1] * u[i];
            }
        }
        let doubled = |a: usize, b: usize| {
            dot(&axes[a], &change[b]) + dot(&axes[b], &change[a]) + dot(&change[a], &change[b])
        };
        let current = [0, 1].map(|a| [0, 1, 2].map(|i| axes[a][i] + change[a][i]));
        let strain = [0.5 * doubled(0, 0), 0.5 * doubled(1, 1), doubled(0, 1)];
        (current, strain)
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
    use crate::surface::surface_law::{FibreFamily, Film};

    const PVDF: Film = Film {
        modulus: 2500.0,
        poisson_ratio: 0.34,
        thickness: 0.05,
    };

    fn family(angle: f64) -> FibreFamily {
        FibreFamily {
            angle,
            stiffness: 100.0,
            compression_ratio: 0.01,
        }
    }

    fn layers() -> Vec<Box<dyn SurfaceLaw>> {
        vec![
            Box::new(family(0.9)),
            Box::new(family(-0.9)),
            Box::new(PVDF),
        ]
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
    fn a_stretched_film_gives_the_closed_forms() {
        let stiffness = PVDF.modulus * PVDF.thickness;
        let nu = PVDF.poisson_ratio;
        for l in [0.95f64, 1.001, 1.05] {
            let strain = 0.5 * (l * l - 1.0);
            // Uniaxial tension: E22 = -nu E11, S11 = h E E11, and the nominal tension is l S11.
            let lateral = (1.0 - 2.0 * nu * strain).sqrt();
            let uniaxial = edge_force(Box::new(PVDF), l, lateral);
            assert!((uniaxial - stiffness * strain * l).abs() < 1e-13 * stiffness);
            let equibiaxial = edge_force(Box::new(PVDF), l, l);
            let expected = stiffness / (1.0 - nu) * strain * l;
            assert!((equibiaxial - expected).abs() < 1e-13 * stiffness);
        }
    }

    #[test]
    fn stiffness_is_the_derivative_of_the_forces() {
        let (mesh, surface, displacement) = bent_face();
        let windows = [[[-0.5, 1.0], [-1.0, 0.25]]];
        for membrane in [
            Membrane::new(&mesh, surface.clone(), &along_x, layers()),
            Membrane::on_windows(&mesh, surface, &windows, &along_x, layers()),
        ] {
            let mut stiffness = vec![0.0; 27 * 27];
            membrane.integrate(0, &displacement, &mut [0.0; 27], Some(&mut stiffness));
            let h = 1e-5;
            for column in 0..27 {
                let shifted = |sign: f64| {
                    let mut moved = displacement.clone();
                    moved[column / 3][column % 3] += sign * h;
                    forces(&membrane, &moved)
                };
                let (plus, minus) = (shifted(1.0), shifted(-1.0));
                for row in 0..=column {
                    let difference = (plus[row] - minus[row]) / (2.0 * h);
                    // Truncation, h^2 times a third derivative, and round-off, eps f / h, with forces of order 100.
                    assert!(
                        (difference - stiffness[row * 27 + column]).abs() < 1e-6,
                        "{row} {column}"
                    );
                }
            }
        }
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

    #[test]
    fn windows_that_share_a_face_add_up_to_it() {
        let (mesh, surface) = square(Order::Quadratic);
        let windows = [
            [[-1.0, 0.3], [-1.0, 1.0]],
            [[0.3, 1.0], [-1.0, -0.2]],
            [[0.3, 1.0], [-0.2, 1.0]],
        ];
        let stretch = |x: &Vector| [0.1 * x[0], 0.0, 0.0];
        let displacement: Vec<Vector> = mesh.nodes.iter().map(stretch).collect();
        let whole = Membrane::new(&mesh, surface.clone(), &along_x, layers());
        let (mut area, mut sum) = (0.0, vec![0.0; 27]);
        for window in windows {
            let part = Membrane::on_windows(&mesh, surface.clone(), &[window], &along_x, layers());
            area += part.area();
            for (total, force) in sum.iter_mut().zip(forces(&part, &displacement)) {
                *total += force;
            }
        }
        // The strain is constant and the face flat, so both rules are exact.
        assert!((area - 1.0).abs() < 1e-14);
        for (a, b) in forces(&whole, &displacement).iter().zip(&sum) {
            assert!((a - b).abs() < 1e-13 * 100.0, "{a} {b}");
        }
    }
}
