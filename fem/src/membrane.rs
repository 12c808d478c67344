//! Fibre families embedded in the mesh: a membrane without thickness or bending.
//!
//! A family of direction `a` (unit, tangent to the reference surface) stores W(lambda) per reference area, where
//! lambda = |F a| is its stretch: W = k (lambda - 1)^2 / 2, with k in tension and a fraction of k in compression,
//! because cords buckle. The tension is continuous and zero in the reference state; its slope jumps there.

use crate::element::face_points;
use crate::mesh::{Mesh, Surface};
use crate::tensor::{Vector, cross, dot, norm};

/// Stiffness of a fibre family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FibreLaw {
    /// Stiffness in tension, N/mm.
    pub stiffness: f64,
    /// Stiffness in compression over that in tension, 0 to 1.
    pub compression_ratio: f64,
}

impl FibreLaw {
    fn slope(&self, stretch: f64) -> f64 {
        if stretch >= 1.0 {
            self.stiffness
        } else {
            self.stiffness * self.compression_ratio
        }
    }

    /// Stored energy per reference area, N/mm.
    pub fn energy(&self, stretch: f64) -> f64 {
        0.5 * self.slope(stretch) * (stretch - 1.0).powi(2)
    }

    /// Tension per reference length, and its derivative by the stretch, N/mm.
    pub fn tension(&self, stretch: f64) -> (f64, f64) {
        let slope = self.slope(stretch);
        (slope * (stretch - 1.0), slope)
    }
}

/// Direction of a family as a function of reference position and unit normal; its tangential part is taken.
pub type Direction<'d> = &'d dyn Fn(&Vector, &Vector) -> Vector;

/// Fibre families on a surface of the mesh, ready to be integrated.
#[derive(Debug)]
pub struct Membrane {
    /// The faces that carry the fibres.
    pub surface: Surface,
    families: Vec<FibreLaw>,
    points_per_face: usize,
    /// Derivative of the shape functions along the fibre: face, point, family, node.
    along: Vec<f64>,
    /// Reference area of each point: face, point.
    areas: Vec<f64>,
    /// Unit fibre direction in the reference state: face, point, family. Current fibres are this plus the displacements'
    /// derivative, so that an undeformed fibre is free of round-off however far from the origin.
    directions: Vec<Vector>,
}

impl Membrane {
    /// Puts families on a surface.
    pub fn new(mesh: &Mesh, surface: Surface, families: &[(FibreLaw, Direction<'_>)]) -> Self {
        let rule = face_points(mesh.order, mesh.order.edge_nodes());
        let (mut along, mut areas, mut directions) = (Vec::new(), Vec::new(), Vec::new());
        for face in surface.iter() {
            let nodes: Vec<Vector> = face.iter().map(|&n| mesh.nodes[n as usize]).collect();
            for point in &rule {
                let [t1, t2] = point.tangents(&nodes);
                let normal = cross(&t1, &t2);
                let area = norm(&normal);
                let normal = normal.map(|n| n / area);
                areas.push(point.weight * area);
                let position = [0, 1, 2].map(|i| {
                    nodes
                        .iter()
                        .zip(&point.values)
                        .map(|(x, n)| x[i] * n)
                        .sum::<f64>()
                });
                for (_, direction) in families {
                    let [a, b] = surface_components(&direction(&position, &normal), &t1, &t2);
                    along.extend(point.gradients.iter().map(|g| g[0] * a + g[1] * b));
                    let fibre = [0, 1, 2].map(|i| a * t1[i] + b * t2[i]);
                    let length = norm(&fibre);
                    directions.push(fibre.map(|c| c / length));
                }
            }
        }
        Self {
            surface,
            families: families.iter().map(|(law, _)| *law).collect(),
            points_per_face: rule.len(),
            along,
            areas,
            directions,
        }
    }

    /// Adds one face's nodal forces and, when asked for, its stiffness (upper triangle by rows) to the buffers.
    pub fn integrate(
        &self,
        face: usize,
        displacement: &[Vector],
        residual: &mut [f64],
        stiffness: Option<&mut [f64]>,
    ) {
        let nodes = displacement.len();
        let mut stiffness = stiffness;
        for point in 0..self.points_per_face {
            let area = self.areas[face * self.points_per_face + point];
            for (family, law) in self.families.iter().enumerate() {
                let b = self.shape_along(face, point, family, nodes);
                let fibre = self.fibre(face, point, family, displacement);
                let stretch = norm(&fibre);
                let (tension, slope) = law.tension(stretch);
                let unit = fibre.map(|c| c / stretch);
                for (force, b) in residual.chunks_exact_mut(3).zip(b) {
                    for i in 0..3 {
                        force[i] += area * tension * b * unit[i];
                    }
                }
                if let Some(stiffness) = stiffness.as_deref_mut() {
                    let transverse = tension / stretch;
                    let block = [0, 1, 2].map(|i| {
                        [0, 1, 2].map(|j| {
                            let same = if i == j { transverse } else { 0.0 };
                            area * ((slope - transverse) * unit[i] * unit[j] + same)
                        })
                    });
                    add_outer(b, &block, stiffness);
                }
            }
        }
    }

    /// Stiffness of all families times the root of the area: the force at a strain of order one, N.
    pub fn natural_force(&self) -> f64 {
        let stiffness: f64 = self.families.iter().map(|law| law.stiffness).sum();
        stiffness * self.areas.iter().sum::<f64>().sqrt()
    }

    /// Smallest and largest fibre stretch of one face.
    pub fn stretch_range(&self, face: usize, displacement: &[Vector]) -> (f64, f64) {
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        for point in 0..self.points_per_face {
            for family in 0..self.families.len() {
                let stretch = norm(&self.fibre(face, point, family, displacement));
                range = (range.0.min(stretch), range.1.max(stretch));
            }
        }
        range
    }

    fn shape_along(&self, face: usize, point: usize, family: usize, nodes: usize) -> &[f64] {
        let offset = ((face * self.points_per_face + point) * self.families.len() + family) * nodes;
        &self.along[offset..offset + nodes]
    }

    /// Current fibre: its reference direction plus the derivative of the displacements along it.
    fn fibre(&self, face: usize, point: usize, family: usize, displacement: &[Vector]) -> Vector {
        let index = (face * self.points_per_face + point) * self.families.len() + family;
        let mut fibre = self.directions[index];
        let along = self.shape_along(face, point, family, displacement.len());
        for (u, b) in displacement.iter().zip(along) {
            for i in 0..3 {
                fibre[i] += b * u[i];
            }
        }
        fibre
    }
}

/// Components (a1, a2) of the unit tangential part of `direction`: a1 t1 + a2 t2.
fn surface_components(direction: &Vector, t1: &Vector, t2: &Vector) -> [f64; 2] {
    let (g11, g12, g22) = (dot(t1, t1), dot(t1, t2), dot(t2, t2));
    let (d1, d2) = (dot(direction, t1), dot(direction, t2));
    let determinant = g11 * g22 - g12 * g12;
    let a = [
        (g22 * d1 - g12 * d2) / determinant,
        (g11 * d2 - g12 * d1) / determinant,
    ];
    let length = (a[0] * a[0] * g11 + 2.0 * a[0] * a[1] * g12 + a[1] * a[1] * g22).sqrt();
    a.map(|c| c / length)
}

/// Adds b_a b_b `block` to the upper triangle of a matrix stored by rows.
pub(crate) fn add_outer(b: &[f64], block: &[[f64; 3]; 3], stiffness: &mut [f64]) {
    let unknowns = 3 * b.len();
    for (row_node, ba) in b.iter().enumerate() {
        for i in 0..3 {
            let row = 3 * row_node + i;
            let target = &mut stiffness[row * unknowns..(row + 1) * unknowns];
            for (column_node, bb) in b.iter().enumerate().skip(row_node) {
                for j in 0..3 {
                    target[3 * column_node + j] += ba * bb * block[i][j];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Order;

    const LAW: FibreLaw = FibreLaw {
        stiffness: 100.0,
        compression_ratio: 0.01,
    };

    #[test]
    fn tension_is_the_derivative_of_the_energy() {
        for stretch in [0.9, 0.999, 1.001, 1.2] {
            let h = 1e-4;
            // The law is piecewise quadratic, so the central difference is exact up to round-off eps W / h.
            let difference = (LAW.energy(stretch + h) - LAW.energy(stretch - h)) / (2.0 * h);
            assert!(
                (difference - LAW.tension(stretch).0).abs()
                    < 1e-9 + 100.0 * h * f64::from(u8::from((stretch - 1.0f64).abs() < h))
            );
        }
    }

    #[test]
    fn the_reference_state_is_stress_free() {
        assert_eq!(LAW.energy(1.0), 0.0);
        assert_eq!(LAW.tension(1.0).0, 0.0);
    }

    /// A unit square in the plane z = 0 stretched along x by l: a family at angle t has stretch
    /// sqrt(l^2 cos^2 + sin^2), and the force along x follows from the energy of the square.
    #[test]
    fn a_stretched_square_gives_the_closed_form_force() {
        let order = Order::Linear;
        let nodes = vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
        ];
        let mesh = Mesh {
            order,
            nodes,
            bricks: vec![],
        };
        let surface = Surface {
            order,
            faces: vec![0, 1, 2, 3],
        };
        let angle = 0.7f64;
        let direction = move |_: &Vector, _: &Vector| [angle.cos(), angle.sin(), 0.0];
        let membrane = Membrane::new(&mesh, surface, &[(LAW, &direction)]);
        let l = 1.1f64;
        let displacement: Vec<Vector> = mesh
            .nodes
            .iter()
            .map(|x| [(l - 1.0) * x[0], 0.0, 0.0])
            .collect();
        let mut residual = vec![0.0; 12];
        membrane.integrate(0, &displacement, &mut residual, None);
        let stretch = (l * l * angle.cos().powi(2) + angle.sin().powi(2)).sqrt();
        let expected = LAW.tension(stretch).0 * l * angle.cos().powi(2) / stretch;
        assert!((residual[3] + residual[9] - expected).abs() < 1e-13 * expected);
        let (low, high) = membrane.stretch_range(0, &displacement);
        assert!((low - stretch).abs() < 1e-15 && (high - stretch).abs() < 1e-15);
    }

    #[test]
    fn stiffness_is_the_derivative_of_the_forces() {
        let order = Order::Quadratic;
        let nodes: Vec<Vector> = (0..9)
            .map(|a| {
                [
                    f64::from(a % 3),
                    1.2 * f64::from(a / 3),
                    0.1 * f64::from(a * a % 5),
                ]
            })
            .collect();
        let mesh = Mesh {
            order,
            nodes,
            bricks: vec![],
        };
        let surface = Surface {
            order,
            faces: (0..9).collect(),
        };
        let direction = |_: &Vector, _: &Vector| [0.6, 0.8, 0.0];
        let membrane = Membrane::new(&mesh, surface, &[(LAW, &direction)]);
        let displacement: Vec<Vector> = mesh
            .nodes
            .iter()
            .map(|x| {
                [
                    0.2 * x[0] + 0.02 * x[1] * x[1],
                    0.15 * x[1],
                    0.05 * x[0] * x[1],
                ]
            })
            .collect();
        let mut stiffness = vec![0.0; 27 * 27];
        membrane.integrate(0, &displacement, &mut vec![0.0; 27], Some(&mut stiffness));
        let h = 1e-5;
        for column in 0..27 {
            let forces = |sign: f64| {
                let mut moved = displacement.clone();
                moved[column / 3][column % 3] += sign * h;
                let mut residual = vec![0.0; 27];
                membrane.integrate(0, &moved, &mut residual, None);
                residual
            };
            let (plus, minus) = (forces(1.0), forces(-1.0));
            for row in 0..=column {
                let difference = (plus[row] - minus[row]) / (2.0 * h);
                // Truncation h^2 f''' and round-off eps f / h, with forces of order 100.
                assert!(
                    (difference - stiffness[row * 27 + column]).abs() < 1e-6,
                    "{row} {column}"
                );
            }
        }
    }
}
