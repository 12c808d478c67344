//! Lagrange elements on the reference square and cube.
//!
//! Nodes are numbered lexicographically, the first coordinate running fastest: 2^d nodes for order 1, 3^d for order 2.
//!
//! A plane-strain cell is a brick whose second line is a constant: one node across, no derivative, thickness 1. The body
//! lies in the plane (x, z) and its lateral displacements, along y, must be held. The lateral stretch is then exactly one,
//! and forces are per unit thickness.

use crate::cell::quadrature;
use crate::tensor::Vector;

/// Polynomial order of the displacements, in space or in the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// 8-node brick with a constant pressure (Q1P0).
    Linear,
    /// 27-node brick with a discontinuous linear pressure (Q2/P1).
    Quadratic,
    /// 4-node quadrilateral in plane strain with a constant pressure.
    PlaneLinear,
    /// 9-node quadrilateral in plane strain with a discontinuous linear pressure.
    PlaneQuadratic,
}

/// Half the thickness of a plane-strain cell: its reference coordinate across runs from -1 to 1.
const HALF_THICKNESS: f64 = 0.5;

impl Order {
    /// Every order, in space and in the plane.
    pub const ALL: [Self; 4] = [
        Self::Linear,
        Self::Quadratic,
        Self::PlaneLinear,
        Self::PlaneQuadratic,
    ];

    /// Whether cells are in plane strain.
    pub fn is_plane(self) -> bool {
        matches!(self, Self::PlaneLinear | Self::PlaneQuadratic)
    }

    /// Number of directions in which cells extend.
    pub fn dimensions(self) -> usize {
        if self.is_plane() { 2 } else { 3 }
    }

    /// Nodes along an edge.
    pub fn edge_nodes(self) -> usize {
        match self {
            Self::Linear | Self::PlaneLinear => 2,
            Self::Quadratic | Self::PlaneQuadratic => 3,
        }
    }

    /// Nodes across: along the second reference coordinate.
    fn nodes_across(self) -> usize {
        if self.is_plane() {
            1
        } else {
            self.edge_nodes()
        }
    }

    /// Nodes of a brick.
    pub fn brick_nodes(self) -> usize {
        self.edge_nodes().pow(self.dimensions() as u32)
    }

    /// Nodes of a face.
    pub(crate) fn face_nodes(self) -> usize {
        self.edge_nodes() * self.nodes_across()
    }

    /// Pressure unknowns of a brick.
    pub fn pressure_modes(self) -> usize {
        match self.edge_nodes() {
            2 => 1,
            _ => 1 + self.dimensions(),
        }
    }

    /// Derivative of the position by the reference coordinate across a plane-strain cell, which no node describes; zero
    /// for bricks.
    pub(crate) fn lateral_tangent(self) -> Vector {
        if self.is_plane() {
            [0.0, HALF_THICKNESS, 0.0]
        } else {
            [0.0; 3]
        }
    }
}

/// Values and derivatives of the 1-D Lagrange polynomials on `nodes` equidistant nodes of [-1, 1].
fn line(nodes: usize, x: f64) -> ([f64; 3], [f64; 3]) {
    match nodes {
        1 => ([1.0, 0.0, 0.0], [0.0; 3]),
        2 => ([0.5 * (1.0 - x), 0.5 * (1.0 + x), 0.0], [-0.5, 0.5, 0.0]),
        _ => (
            [0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)],
            [x - 0.5, -2.0 * x, x + 0.5],
        ),
    }
}

/// Shape functions of a face and their first derivatives at a point of the square.
pub fn face_shape(order: Order, point: [f64; 2]) -> (Vec<f64>, Vec<[f64; 2]>) {
    let (n, across) = (order.edge_nodes(), order.nodes_across());
    let (nx, dx) = line(n, point[0]);
    let (ny, dy) = line(across, point[1]);
    let mut values = Vec::with_capacity(n * across);
    let mut gradients = Vec::with_capacity(n * across);
    for j in 0..across {
        for i in 0..n {
            values.push(nx[i] * ny[j]);
            gradients.push([dx[i] * ny[j], nx[i] * dy[j]]);
        }
    }
    (values, gradients)
}

/// Shape function gradients of a brick with respect to its reference coordinates, one per node.
pub fn brick_gradients(order: Order, point: [f64; 3]) -> Vec<[f64; 3]> {
    let (n, across) = (order.edge_nodes(), order.nodes_across());
    let (nx, dx) = line(n, point[0]);
    let (ny, dy) = line(across, point[1]);
    let (nz, dz) = line(n, point[2]);
    let mut gradients = Vec::with_capacity(order.brick_nodes());
    for k in 0..n {
        for j in 0..across {
            for i in 0..n {
                gradients.push([
                    dx[i] * ny[j] * nz[k],
                    nx[i] * dy[j] * nz[k],
                    nx[i] * ny[j] * dz[k],
                ]);
            }
        }
    }
    gradients
}

/// Pressure modes of a brick at a reference point: 1, and for order 2 also the coordinates of its directions.
pub fn pressure_modes(order: Order, point: [f64; 3]) -> Vec<f64> {
    match order {
        Order::Linear | Order::PlaneLinear => vec![1.0],
        Order::Quadratic => vec![1.0, point[0], point[1], point[2]],
        Order::PlaneQuadratic => vec![1.0, point[0], point[2]],
    }
}

/// Integration points and weights of a brick, as many along each line as it has nodes.
pub fn brick_points(order: Order) -> Vec<([f64; 3], f64)> {
    let n = order.edge_nodes();
    quadrature::brick([n, order.nodes_across(), n])
}

/// An integration point of a reference face.
#[derive(Debug, Clone)]
pub(crate) struct FacePoint {
    /// Weight on the reference square.
    pub weight: f64,
    /// Shape functions.
    pub values: Vec<f64>,
    /// Derivatives of the shape functions with respect to the reference coordinates.
    pub gradients: Vec<[f64; 2]>,
    /// Constant part of the second tangent: [`Order::lateral_tangent`].
    lateral: Vector,
}

impl FacePoint {
    /// Tangents of the face with these nodes: derivatives of the position by the two reference coordinates.
    pub fn tangents(&self, positions: &[Vector]) -> [Vector; 2] {
        let mut tangents = [[0.0; 3], self.lateral];
        for (x, g) in positions.iter().zip(&self.gradients) {
            for i in 0..3 {
                tangents[0][i] += g[0] * x[i];
                tangents[1][i] += g[1] * x[i];
            }
        }
        tangents
    }
}

/// A point of a reference face with its shape functions.
pub(crate) fn face_point(order: Order, local: [f64; 2], weight: f64) -> FacePoint {
    let (values, gradients) = face_shape(order, local);
    FacePoint {
        weight,
        values,
        gradients,
        lateral: order.lateral_tangent(),
    }
}

/// Points and weights of a face with `n` Gauss points along each of its lines.
pub fn face_rule(order: Order, n: usize) -> Vec<([f64; 2], f64)> {
    let across = if order.is_plane() { 1 } else { n };
    quadrature::rectangle([n, across])
}

/// Integration points of a face with `n` Gauss points along each of its lines.
pub(crate) fn face_points(order: Order, n: usize) -> Vec<FacePoint> {
    face_rule(order, n)
        .into_iter()
        .map(|(local, weight)| face_point(order, local, weight))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_are_a_partition_of_unity() {
        for order in Order::ALL {
            let (values, gradients) = face_shape(order, [0.3, -0.7]);
            assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-15);
            for axis in 0..2 {
                assert!(gradients.iter().map(|g| g[axis]).sum::<f64>().abs() < 1e-15);
            }
            for axis in 0..3 {
                let sum: f64 = brick_gradients(order, [0.3, -0.7, 0.1])
                    .iter()
                    .map(|g| g[axis])
                    .sum();
                assert!(sum.abs() < 1e-15);
            }
        }
    }

    #[test]
    fn gradients_reproduce_the_coordinates() {
        for order in Order::ALL {
            let (n, across) = (order.edge_nodes(), order.nodes_across());
            let step = 2.0 / (n as f64 - 1.0);
            let gradients = brick_gradients(order, [0.2, 0.5, -0.4]);
            let mut jacobian = [[0.0; 3]; 3];
            for i in 0..3 {
                // The reference cell is two thick, a plane-strain cell one.
                jacobian[i][1] = 2.0 * order.lateral_tangent()[i];
            }
            for (a, g) in gradients.iter().enumerate() {
                let node =
                    [a % n, a / n % across, a / (n * across)].map(|i| -1.0 + step * i as f64);
                for i in 0..3 {
                    for j in 0..3 {
                        jacobian[i][j] += node[i] * g[j];
                    }
                }
            }
            for (i, row) in jacobian.iter().enumerate() {
                for (j, value) in row.iter().enumerate() {
                    assert!((value - f64::from(u8::from(i == j))).abs() < 1e-15);
                }
            }
        }
    }

    #[test]
    fn rules_integrate_one_over_the_cell_and_its_face() {
        for order in Order::ALL {
            let volume: f64 = brick_points(order).iter().map(|p| p.1).sum();
            let area: f64 = face_points(order, 3).iter().map(|p| p.weight).sum();
            assert!(
                (volume - 8.0).abs() < 27.0 * 8.0 * f64::EPSILON,
                "{order:?}"
            );
            assert!((area - 4.0).abs() < 9.0 * 4.0 * f64::EPSILON, "{order:?}");
        }
    }

    #[test]
    fn a_line_along_x_is_a_face_with_its_normal_along_z() {
        let point = &face_points(Order::PlaneLinear, 2)[0];
        let [t1, t2] = point.tangents(&[[0.0; 3], [3.0, 0.0, 0.0]]);
        assert_eq!(crate::tensor::cross(&t1, &t2), [0.0, 0.0, 0.75]);
    }
}
