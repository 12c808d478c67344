//! Posterior of a process: what training rows say of new rows, and of themselves when they are left out.

use faer::linalg::solvers::{DenseSolveCore, Llt, Solve};
use faer::{Col, Side};

use super::kernel::Kernel;
use super::point_rows::PointRows;
use super::row_pairs::RowPairs;
use crate::model::contract::Prediction;

/// A process conditioned on rows.
#[derive(Debug, Clone)]
pub struct Posterior {
    rows: PointRows,
    values: Vec<f64>,
    alpha: Vec<f64>,
    /// The rows of L, each up to its diagonal, one after another: a new row's variance reads them in this order.
    factor: Vec<f64>,
    llt: Llt<f64>,
}

impl PartialEq for Posterior {
    fn eq(&self, other: &Self) -> bool {
        self.factor == other.factor && self.alpha == other.alpha
    }
}

impl Posterior {
    /// Conditions on rows and their values; None where their covariance has no Cholesky factor.
    pub fn new(kernel: &Kernel, rows: &PointRows, values: &[f64]) -> Option<Self> {
        let pairs = RowPairs::new(rows);
        let covariance = kernel.covariance(&kernel.exponential(&pairs), &pairs);
        drop(pairs);
        let llt = Llt::new(covariance.as_ref(), Side::Lower).ok()?;
        let y = Col::from_fn(rows.len(), |i| values[i]);
        let alpha = llt.solve(&y);
        let lower = llt.L();
        let factor = (0..rows.len()).flat_map(|i| (0..=i).map(move |j| lower[(i, j)]));
        Some(Self {
            rows: rows.clone(),
            values: values.to_vec(),
            alpha: alpha.iter().copied().collect(),
            factor: factor.collect(),
            llt,
        })
    }

    /// alpha = K^-1 y
    pub fn alpha(&self) -> &[f64] {
        &self.alpha
    }

    /// Mean and deviation of a new reading, its noise included (eqs. 2.25 and 2.26).
    pub fn predict(&self, kernel: &Kernel, point: &[f64]) -> Prediction {
        let covariances = kernel.with_point(&self.rows, point);
        Prediction {
            mean: covariances
                .iter()
                .zip(&self.alpha)
                .map(|(k, a)| k * a)
                .sum(),
            deviation: self.variance(kernel, point).sqrt(),
        }
    }

    /// Variance of a new reading: v + n - |L^-1 k|^2, no less than the noise.
    pub fn variance(&self, kernel: &Kernel, point: &[f64]) -> f64 {
        let mut solved = kernel.with_point(&self.rows, point);
        let mut begin = 0;
        for i in 0..solved.len() {
            let (before, rest) = solved.split_at_mut(i);
            let row = &self.factor[begin..=begin + i];
            rest[0] = (rest[0] - dot(&row[..i], before)) / row[i];
            begin += i + 1;
        }
        let known = dot(&solved, &solved);
        (kernel.prior(point) - known).max(0.0) + kernel.noise
    }

    /// Predicts each row from the other rows: mean y_i - alpha_i / (K^-1)_ii, variance 1 / (K^-1)_ii (eqs. 5.12).
    pub fn left_out(&self) -> Vec<Prediction> {
        let inverse = self.llt.inverse();
        let of_row = |(i, (y, alpha)): (usize, (&f64, &f64))| Prediction {
            mean: y - alpha / inverse[(i, i)],
            deviation: inverse[(i, i)].recip().sqrt(),
        };
        self.values
            .iter()
            .zip(&self.alpha)
            .enumerate()
            .map(of_row)
            .collect()
    }
}

/// A scalar product in eight sums at a time.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (parts_a, parts_b) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = parts_a
        .remainder()
        .iter()
        .zip(parts_b.remainder())
        .map(|(x, y)| x * y)
        .sum();
    for (x, y) in parts_a.zip(parts_b) {
        for (sum, (x, y)) in sums.iter_mut().zip(x.iter().zip(y)) {
            *sum += x * y;
        }
    }
    sums.iter().sum::<f64>() + rest
}
