//! Lagrange elements on the reference square and cube.
//!
//! Nodes are numbered lexicographically, the first coordinate running fastest: 2^d nodes for order 1, 3^d for order 2.

use crate::quadrature;

/// Polynomial order of the displacements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// 8-node brick with a constant pressure (Q1P0).
    Linear,
    /// 27-node brick with a discontinuous linear pressure (Q2/P1).
    Quadratic,
}

impl Order {
    /// Nodes along an edge.
    pub fn edge_nodes(self) -> usize {
        match self {
            Self::Linear => 2,
            Self::Quadratic => 3,
        }
    }

    /// Nodes of a brick.
    pub fn brick_nodes(self) -> usize {
        self.edge_nodes().pow(3)
    }

    /// Nodes of a face.
    pub fn face_nodes(self) -> usize {
        self.edge_nodes().pow(2)
    }

    /// Pressure unknowns of a brick.
    pub fn pressure_modes(self) -> usize {
        match self {
            Self::Linear => 1,
            Self::Quadratic => 4,
        }
    }
}

/// Values and derivatives of the 1-D Lagrange polynomials on equidistant nodes of [-1, 1].
fn line(order: Order, x: f64) -> ([f64; 3], [f64; 3]) {
    match order {
        Order::Linear => ([0.5 * (1.0 - x), 0.5 * (1.0 + x), 0.0], [-0.5, 0.5, 0.0]),
        Order::Quadratic => (
            [0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)],
            [x - 0.5, -2.0 * x, x + 0.5],
        ),
    }
}

/// Shape functions of a face and their first derivatives at a point of the square.
pub fn face_shape(order: Order, point: [f64; 2]) -> (Vec<f64>, Vec<[f64; 2]>) {
    let n = order.edge_nodes();
    let (nx, dx) = line(order, point[0]);
    let (ny, dy) = line(order, point[1]);
    let mut values = Vec::with_capacity(n * n);
    let mut gradients = Vec::with_capacity(n * n);
    for j in 0..n {
        for i in 0..n {
            values.push(nx[i] * ny[j]);
            gradients.push([dx[i] * ny[j], nx[i] * dy[j]]);
        }
    }
    (values, gradients)
}

/// Shape function gradients of a brick with respect to its reference coordinates, one per node.
pub fn brick_gradients(order: Order, point: [f64; 3]) -> Vec<[f64; 3]> {
    let n = order.edge_nodes();
    let [(nx, dx), (ny, dy), (nz, dz)] = point.map(|x| line(order, x));
    let mut gradients = Vec::with_capacity(n * n * n);
    for k in 0..n {
        for j in 0..n {
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

/// Pressure modes of a brick at a reference point: 1, and for order 2 also the three coordinates.
pub fn pressure_modes(order: Order, point: [f64; 3]) -> Vec<f64> {
    match order {
        Order::Linear => vec![1.0],
        Order::Quadratic => vec![1.0, point[0], point[1], point[2]],
    }
}

/// One integration point of a reference face.
#[derive(Debug, Clone)]
pub struct FacePoint {
    /// Weight on the reference square.
    pub weight: f64,
    /// Shape functions.
    pub values: Vec<f64>,
    /// Their derivatives with respect to the reference coordinates.
    pub gradients: Vec<[f64; 2]>,
}

/// Integration points of a face with `n` x `n` Gauss points.
pub fn face_points(order: Order, n: usize) -> Vec<FacePoint> {
    quadrature::square(n)
        .into_iter()
        .map(|(point, weight)| {
            let (values, gradients) = face_shape(order, point);
            FacePoint {
                weight,
                values,
                gradients,
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_are_a_partition_of_unity() {
        for order in [Order::Linear, Order::Quadratic] {
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
        for order in [Order::Linear, Order::Quadratic] {
            let n = order.edge_nodes();
            let step = 2.0 / (n as f64 - 1.0);
            let gradients = brick_gradients(order, [0.2, 0.5, -0.4]);
            let mut jacobian = [[0.0; 3]; 3];
            for (a, g) in gradients.iter().enumerate() {
                let node = [a % n, a / n % n, a / (n * n)].map(|i| -1.0 + step * i as f64);
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
}
