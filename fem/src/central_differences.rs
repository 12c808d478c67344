//! Derivatives by central differences: what the stiffnesses of contact, pressure and membranes are held against.

use crate::tensor::Vector;

/// Derivative of forces (N) by the coordinates of nodes (mm), from steps of h to either side, N/mm: by rows, as stiffnesses are stored.
pub(crate) fn derivative(
    nodes: &[Vector],
    h: f64,
    forces: impl Fn(&[Vector]) -> Vec<f64>,
) -> Vec<f64> {
    let unknowns = 3 * nodes.len();
    let mut matrix = vec![0.0; unknowns * unknowns];
    for column in 0..unknowns {
        let shifted = |sign: f64| {
            let mut moved = nodes.to_vec();
            moved[column / 3][column % 3] += sign * h;
            forces(&moved)
        };
        let (plus, minus) = (shifted(1.0), shifted(-1.0));
        for row in 0..unknowns {
            matrix[row * unknowns + column] = (plus[row] - minus[row]) / (2.0 * h);
        }
    }
    matrix
}

/// Fails unless the upper triangles of two square matrices stored by rows agree entry by entry.
pub(crate) fn assert_upper_agrees(one: &[f64], other: &[f64], tolerance: f64) {
    let unknowns = one.len().isqrt();
    for row in 0..unknowns {
        for column in row..unknowns {
            let difference = one[row * unknowns + column] - other[row * unknowns + column];
            assert!(difference.abs() < tolerance, "{row} {column}");
        }
    }
}
