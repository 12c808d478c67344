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
pub fn cofactor_derivative(a: &Tensor) -> Tensor4 {
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
}
