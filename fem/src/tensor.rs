//! 3 x 3 algebra on plain arrays, row by row.

/// A vector in space.
pub type Vector = [f64; 3];
/// A second-order tensor, `t[i][j]`.
pub type Tensor = [[f64; 3]; 3];
/// A fourth-order tensor as a 9 x 9 matrix, index `3 i + j`.
pub type Tensor4 = [[f64; 9]; 9];

/// The identity tensor.
pub const IDENTITY: Tensor = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Scalar product.
pub fn dot(a: &Vector, b: &Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector product.
pub fn cross(a: &Vector, b: &Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Euclidean length.
pub fn norm(a: &Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Product of two tensors.
pub fn multiply(a: &Tensor, b: &Tensor) -> Tensor {
    let mut c = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
    c
}

/// Transpose.
pub fn transpose(a: &Tensor) -> Tensor {
    let mut c = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            c[i][j] = a[j][i];
        }
    }
    c
}

/// Cofactor, det(a) a^-T; defined for singular tensors too.
pub fn cofactor(a: &Tensor) -> Tensor {
    [
        cross(&a[1], &a[2]),
        cross(&a[2], &a[0]),
        cross(&a[0], &a[1]),
    ]
}

/// Determinant.
pub fn determinant(a: &Tensor) -> f64 {
    dot(&a[0], &cross(&a[1], &a[2]))
}

/// Derivative of the cofactor with respect to the tensor, symmetric:
/// d cof(a)_ij / d a_kl = eps_ikm eps_jln a_mn.
pub(crate) fn cofactor_derivative(a: &Tensor) -> Tensor4 {
    let mut d = [[0.0; 9]; 9];
    for i in 0..3 {
        for j in 0..3 {
            let (k1, k2) = ((i + 1) % 3, (i + 2) % 3);
            let (l1, l2) = ((j + 1) % 3, (j + 2) % 3);
            let row = &mut d[3 * i + j];
            row[3 * k1 + l1] = a[k2][l2];
            row[3 * k2 + l2] = a[k1][l1];
            row[3 * k1 + l2] = -a[k2][l1];
            row[3 * k2 + l1] = -a[k1][l2];
        }
    }
    d
}

/// Eigenvalues and orthonormal eigenvectors (in the columns) of a symmetric tensor, in no particular order.
///
/// Cyclic Jacobi rotations (G. H. Golub and C. F. Van Loan, Matrix Computations, 4th ed., section 8.5): the error is a few
/// round-offs of the largest eigenvalue however close the eigenvalues are, where the closed form loses half of the digits.
pub(crate) fn symmetric_eigen(a: &Tensor) -> (Vector, Tensor) {
    let (mut a, mut vectors) = (*a, IDENTITY);
    for _ in 0..MAX_SWEEPS {
        let beside = a[0][1].abs().max(a[0][2].abs()).max(a[1][2].abs());
        let size = a[0][0].abs().max(a[1][1].abs()).max(a[2][2].abs());
        // Quadratic in the next sweep: what is left is then below the round-off of the eigenvalues.
        if beside <= 1e-2 * f64::EPSILON * size {
            break;
        }
        for (p, q, r) in [(0, 1, 2), (0, 2, 1), (1, 2, 0)] {
            rotate(&mut a, &mut vectors, p, q, r);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], vectors)
}

/// The iteration converges quadratically and takes four to six sweeps; more only where numbers aren't finite.
const MAX_SWEEPS: usize = 12;

/// Makes a_pq zero by a rotation in the plane of p and q; r is the third axis.
fn rotate(a: &mut Tensor, vectors: &mut Tensor, p: usize, q: usize, r: usize) {
    let off = a[p][q];
    if off == 0.0 {
        return;
    }
    let tau = (a[q][q] - a[p][p]) / (2.0 * off);
    // Where tau^2 overflows, the angle is zero anyway.
    let t = tau.signum() / (tau.abs() + (1.0 + tau * tau).sqrt());
    let c = 1.0 / (1.0 + t * t).sqrt();
    let s = t * c;
    a[p][p] -= t * off;
    a[q][q] += t * off;
    a[p][q] = 0.0;
    let (rp, rq) = (a[p.min(r)][p.max(r)], a[q.min(r)][q.max(r)]);
    a[p.min(r)][p.max(r)] = c * rp - s * rq;
    a[q.min(r)][q.max(r)] = s * rp + c * rq;
    for row in vectors {
        (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Tensor = [[1.1, 0.2, -0.3], [0.4, 0.9, 0.15], [-0.05, 0.25, 1.3]];

    #[test]
    fn cofactor_times_transpose_is_the_determinant() {
        let product = multiply(&A, &transpose(&cofactor(&A)));
        for (i, row) in product.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                let expected = if i == j { determinant(&A) } else { 0.0 };
                assert!(
                    (value - expected).abs() < 1e-15,
                    "{i}{j}: {value} for {expected}"
                );
            }
        }
    }

    #[test]
    fn cofactor_derivative_is_exact_for_a_quadratic_map() {
        // The cofactor is quadratic in its argument, so a central difference has no truncation error.
        let exact = cofactor_derivative(&A);
        let h = 0.5;
        for column in 0..9 {
            let (mut plus, mut minus) = (A, A);
            plus[column / 3][column % 3] += h;
            minus[column / 3][column % 3] -= h;
            let (cp, cm) = (cofactor(&plus), cofactor(&minus));
            for row in 0..9 {
                let difference = (cp[row / 3][row % 3] - cm[row / 3][row % 3]) / (2.0 * h);
                assert!((difference - exact[row][column]).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn eigenvectors_rebuild_the_tensor_and_are_orthonormal() {
        let q = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]];
        for values in [
            [1.0, 2.0, 3.0],
            [1.0, 1.0, 1.0],
            [2.0, 2.0, 1.0],
            [1.0, 1.0 + 1e-15, 1.0 - 1e-9],
            [1e-6, 1.0, 1e6],
            [0.0, 0.0, 5.0],
        ] {
            let diagonal = [0, 1, 2].map(|i| [0, 1, 2].map(|j| values[i] * IDENTITY[i][j]));
            let a = multiply(&multiply(&q, &diagonal), &transpose(&q));
            let (mut found, vectors) = symmetric_eigen(&a);
            let rebuilt = multiply(
                &[0, 1, 2].map(|i| [0, 1, 2].map(|j| vectors[i][j] * found[j])),
                &transpose(&vectors),
            );
            let gram = multiply(&transpose(&vectors), &vectors);
            let size = values.into_iter().fold(0.0, f64::max);
            for i in 0..3 {
                for j in 0..3 {
                    // Six sweeps of three rotations, each exact to a few round-offs.
                    let tolerance = 50.0 * f64::EPSILON;
                    assert!(
                        (rebuilt[i][j] - a[i][j]).abs() < tolerance * size,
                        "{values:?}"
                    );
                    assert!(
                        (gram[i][j] - IDENTITY[i][j]).abs() < tolerance,
                        "{values:?}"
                    );
                }
            }
            found.sort_by(f64::total_cmp);
            let mut exact = values;
            exact.sort_by(f64::total_cmp);
            for (value, exact) in found.into_iter().zip(exact) {
                assert!(
                    (value - exact).abs() < 50.0 * f64::EPSILON * size,
                    "{found:?}"
                );
            }
        }
    }

    #[test]
    fn a_tensor_that_is_not_finite_ends_too() {
        let (values, _) = symmetric_eigen(&[[f64::NAN; 3]; 3]);
        assert!(values.iter().any(|v| v.is_nan()));
    }
}
