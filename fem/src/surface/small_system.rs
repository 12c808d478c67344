//! Small dense systems of equations.

/// Gaussian elimination of a symmetric positive definite system with a few right-hand sides, which become its solutions.
pub(super) fn solve_spd<const N: usize>(matrix: &mut [Vec<f64>], rhs: &mut [[f64; N]]) {
    let n = rhs.len();
    for pivot in 0..n {
        // Beyond the last entry of its row, and so of its column, a pivot changes nothing: neighbours have neighbouring numbers.
        let last = matrix[pivot].iter().rposition(|value| *value != 0.0);
        let end = last.map_or(n, |last| last + 1);
        for row in pivot + 1..end {
            let factor = matrix[row][pivot] / matrix[pivot][pivot];
            let (upper, lower) = matrix.split_at_mut(row);
            let above = &upper[pivot][pivot..end];
            for (value, above) in lower[0][pivot..end].iter_mut().zip(above) {
                *value -= factor * above;
            }
            for k in 0..N {
                rhs[row][k] -= factor * rhs[pivot][k];
            }
        }
    }
    for row in (0..n).rev() {
        for k in 0..N {
            let known: f64 = (row + 1..n).map(|c| matrix[row][c] * rhs[c][k]).sum();
            rhs[row][k] = (rhs[row][k] - known) / matrix[row][row];
        }
    }
}
