//! The leading modes of snapshots of several sensors.

/// Largest entry off the diagonal, over the largest on it, at which rotations end.
const ROUNDING: f64 = 1e-14;
/// Sweeps of rotations at most: a dozen are enough.
const MOST_SWEEPS: usize = 60;

/// Rows of sensors in the modes that hold a share of the snapshots' sum of squares: eigenvectors of S S' by Jacobi's rotations, largest eigenvalue first.
/// `snapshots` has a row for each sensor.
pub(crate) fn leading_modes(snapshots: &[Vec<f64>], share: f64) -> Vec<Vec<f64>> {
    let count = snapshots.len();
    let product = |a: &Vec<f64>, b: &Vec<f64>| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut matrix: Vec<Vec<f64>> = snapshots
        .iter()
        .map(|a| snapshots.iter().map(|b| product(a, b)).collect())
        .collect();
    let mut vectors: Vec<Vec<f64>> = (0..count)
        .map(|i| (0..count).map(|j| f64::from(u8::from(i == j))).collect())
        .collect();
    for _ in 0..MOST_SWEEPS {
        let largest = (0..count).map(|i| matrix[i][i].abs()).fold(0.0, f64::max);
        let off = (0..count)
            .flat_map(|i| (0..i).map(move |j| (i, j)))
            .map(|(i, j)| matrix[i][j].abs())
            .fold(0.0, f64::max);
        if off <= ROUNDING * largest {
            break;
        }
        for p in 1..count {
            for q in 0..p {
                rotate(&mut matrix, &mut vectors, p, q);
            }
        }
    }
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&i, &j| matrix[j][j].total_cmp(&matrix[i][i]));
    let whole: f64 = (0..count).map(|i| matrix[i][i]).sum();
    let mut held = 0.0;
    let kept = order.iter().take_while(|&&i| {
        let goes_on = held < share * whole;
        held += matrix[i][i];
        goes_on
    });
    let kept: Vec<usize> = kept.copied().collect();
    vectors
        .iter()
        .map(|row| kept.iter().map(|&mode| row[mode]).collect())
        .collect()
}

/// Makes one entry off the diagonal vanish.
fn rotate(matrix: &mut [Vec<f64>], vectors: &mut [Vec<f64>], p: usize, q: usize) {
    if matrix[p][q] == 0.0 {
        return;
    }
    let theta = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
    let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = tangent * cosine;
    let turn = |a: f64, b: f64| (cosine * a - sine * b, sine * a + cosine * b);
    for row in matrix.iter_mut().chain(vectors) {
        (row[p], row[q]) = turn(row[p], row[q]);
    }
    for column in 0..matrix.len() {
        (matrix[p][column], matrix[q][column]) = turn(matrix[p][column], matrix[q][column]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modes_are_orthonormal_and_hold_what_they_say() {
        // Two modes of squares 9 and 1, turned by 30 degrees, and nothing else.
        let (sin, cos) = 30f64.to_radians().sin_cos();
        let snapshots = vec![vec![3.0 * cos, -sin], vec![3.0 * sin, cos], vec![0.0, 0.0]];
        let one = leading_modes(&snapshots, 0.9);
        assert!(one.iter().all(|row| row.len() == 1));
        assert!((one[0][0].abs() - cos).abs() < 1e-12 && (one[1][0].abs() - sin).abs() < 1e-12);
        let two = leading_modes(&snapshots, 0.99);
        assert!(two.iter().all(|row| row.len() == 2));
        let along: f64 = two.iter().map(|row| row[0] * row[1]).sum();
        assert!(along.abs() < 1e-12);
    }
}
