//! The log marginal likelihood and its gradient.
//!
//! log p(y | X) = -1/2 y' alpha - sum_i ln L_ii - n/2 ln 2 pi (Rasmussen and Williams 2006, eq. 2.30), and by a hyperparameter t
//! 1/2 tr((alpha alpha' - K^-1) dK/dt) (eq. 5.9). Hyperparameters are taken by their logarithms.

use faer::linalg::solvers::{DenseSolveCore, Llt, Solve};
use faer::{Col, Mat, Side};

use super::kernel::Kernel;
use super::row_pairs::RowPairs;

/// The likelihood of hyperparameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Likelihood {
    /// log p(y | X)
    pub value: f64,
    /// Gradient by the logarithms of variance, each length, noise, and line where there is one.
    pub gradient: Vec<f64>,
}

/// log p(y | X) with its gradient; None where K has no Cholesky factor.
pub fn log_likelihood(kernel: &Kernel, pairs: &RowPairs<'_>, values: &[f64]) -> Option<Likelihood> {
    let n = values.len();
    let exponential = kernel.exponential(pairs);
    let covariance = kernel.covariance(&exponential, pairs);
    let factor = Llt::new(covariance.as_ref(), Side::Lower).ok()?;
    let y = Col::from_fn(n, |i| values[i]);
    let alpha = factor.solve(&y);
    let log_determinant: f64 = (0..n).map(|i| factor.L()[(i, i)].ln()).sum();
    let fit: f64 = (0..n).map(|i| y[i] * alpha[i]).sum();
    let value = -0.5 * fit - log_determinant - 0.5 * n as f64 * (2.0 * std::f64::consts::PI).ln();
    let inverse = factor.inverse();
    drop(covariance);
    Some(Likelihood {
        value,
        gradient: gradient(kernel, pairs, &exponential, &alpha, &inverse),
    })
}

/// Sums over the lower triangle: what is off the diagonal counts twice.
fn gradient(
    kernel: &Kernel,
    pairs: &RowPairs<'_>,
    exponential: &Mat<f64>,
    alpha: &Col<f64>,
    inverse: &Mat<f64>,
) -> Vec<f64> {
    let n = alpha.nrows();
    let (mut by_variance, mut by_noise, mut by_line) = (0.0, 0.0, 0.0);
    let mut by_length = vec![0.0; kernel.lengths.len()];
    let mut weights = vec![0.0; n];
    for j in 0..n {
        let (k, inverse) = (
            &exponential.col_as_slice(j)[j..],
            &inverse.col_as_slice(j)[j..],
        );
        let weights = &mut weights[..n - j];
        for (i, w) in weights.iter_mut().enumerate() {
            *w = alpha[j] * alpha[j + i] - inverse[i];
        }
        weights[0] *= 0.5;
        by_noise += kernel.noise * weights[0];
        by_line += kernel.line.map_or(0.0, |line| {
            line * sum_of_products(weights, pairs.products_from(j))
        });
        for (w, k) in weights.iter_mut().zip(k) {
            *w *= k;
        }
        by_variance += weights.iter().sum::<f64>();
        if let [length] = kernel.lengths[..] {
            by_length[0] += sum_of_products(weights, pairs.squares_from(j)) / (length * length);
        } else {
            for (feature, column) in pairs.rows().columns().enumerate() {
                by_length[feature] += kernel.length(feature).powi(-2)
                    * weighted_squares(weights, &column[j..], column[j]);
            }
        }
    }
    let line = kernel.line.map(|_| by_line);
    [vec![by_variance], by_length, vec![by_noise]]
        .into_iter()
        .flatten()
        .chain(line)
        .collect()
}

/// sum_i w_i y_i, in four sums at a time: as one, each addition would wait for the one before.
fn sum_of_products(weights: &[f64], column: &[f64]) -> f64 {
    in_fours(weights, column, |w, y| w * y)
}

/// sum_i w_i (y_i - x)^2, the same way.
fn weighted_squares(weights: &[f64], column: &[f64], x: f64) -> f64 {
    in_fours(weights, column, |w, y| w * (y - x) * (y - x))
}

fn in_fours(weights: &[f64], column: &[f64], of: impl Fn(f64, f64) -> f64) -> f64 {
    let mut sums = [0.0; 4];
    let (weight_parts, column_parts) = (weights.chunks_exact(4), column.chunks_exact(4));
    let rest = weight_parts
        .remainder()
        .iter()
        .zip(column_parts.remainder());
    let rest: f64 = rest.map(|(w, y)| of(*w, *y)).sum();
    for (weights, column) in weight_parts.zip(column_parts) {
        for (sum, (w, y)) in sums.iter_mut().zip(weights.iter().zip(column)) {
            *sum += of(*w, *y);
        }
    }
    sums.iter().sum::<f64>() + rest
}
