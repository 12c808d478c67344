//! The covariance of two rows' forces.

use faer::Mat;
use serde::{Deserialize, Serialize};

use super::point_rows::PointRows;
use super::row_pairs::{RowPairs, add_products, add_squares};
use crate::model::contract::check_numbers;

/// k(x, x') = variance exp(-1/2 sum_j ((x_j - x'_j) / length_j)^2) + line/d sum_j x_j x'_j, of d features, and the noise beside it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kernel {
    /// Signal variance v.
    pub variance: f64,
    /// Length scales l: one for all features, or one for each.
    pub lengths: Vec<f64>,
    /// Noise variance n.
    pub noise: f64,
    /// Variance b of a line in the features at the root of d from their mean; none without a line.
    pub line: Option<f64>,
}

impl Kernel {
    /// Makes a kernel from the logarithms of variance, lengths, noise, and line where there is one, in this order.
    pub fn from_logs(logs: &[f64], line: bool) -> Self {
        let numbers: Vec<f64> = logs.iter().map(|x| x.exp()).collect();
        let noise = numbers.len() - 1 - usize::from(line);
        Self {
            variance: numbers[0],
            lengths: numbers[1..noise].to_vec(),
            noise: numbers[noise],
            line: line.then(|| numbers[noise + 1]),
        }
    }

    /// Length scale of a feature.
    pub fn length(&self, feature: usize) -> f64 {
        if self.lengths.len() == 1 {
            self.lengths[0]
        } else {
            self.lengths[feature]
        }
    }

    /// Variance at a point, without noise.
    pub fn prior(&self, point: &[f64]) -> f64 {
        let squares = || point.iter().map(|x| x * x).sum::<f64>() / point.len().max(1) as f64;
        self.variance + self.line.map_or(0.0, |line| line * squares())
    }

    /// k between all rows and a point.
    pub(crate) fn with_point(&self, rows: &PointRows, point: &[f64]) -> Vec<f64> {
        let mut squares = vec![0.0; rows.len()];
        for (feature, (column, x)) in rows.columns().zip(point).enumerate() {
            add_squares(&mut squares, column, *x, 1.0 / self.length(feature));
        }
        let mut found: Vec<f64> = squares
            .iter()
            .map(|s| self.variance * (-0.5 * s).exp())
            .collect();
        if let Some(line) = self.line {
            let share = line / point.len().max(1) as f64;
            for (column, x) in rows.columns().zip(point) {
                add_products(&mut found, column, share * x);
            }
        }
        found
    }

    /// The squared exponential between all rows: the lower triangle of rows x rows.
    pub fn exponential(&self, pairs: &RowPairs<'_>) -> Mat<f64> {
        let rows = pairs.rows();
        let n = rows.len();
        let mut found = Mat::zeros(n, n);
        for j in 0..n {
            let below = &mut found.col_as_slice_mut(j)[j..];
            if let [length] = self.lengths[..] {
                let squares = below.iter_mut().zip(pairs.squares_from(j));
                squares.for_each(|(s, square)| *s = square / (length * length));
            } else {
                for (feature, column) in rows.columns().enumerate() {
                    add_squares(below, &column[j..], column[j], 1.0 / self.length(feature));
                }
            }
            for s in below {
                *s = self.variance * (-0.5 * *s).exp();
            }
        }
        found
    }

    /// The covariance of rows with their noise, from its squared exponential: the lower triangle.
    pub fn covariance(&self, exponential: &Mat<f64>, pairs: &RowPairs<'_>) -> Mat<f64> {
        let mut found = exponential.clone();
        for j in 0..found.nrows() {
            let below = &mut found.col_as_slice_mut(j)[j..];
            if let Some(line) = self.line {
                add_products(below, pairs.products_from(j), line);
            }
            below[0] += self.noise;
        }
        found
    }

    pub(crate) fn check(&self, features: usize) -> Result<(), String> {
        if self.lengths.len() != 1 {
            check_numbers("a process's lengths", &self.lengths, features)?;
        }
        let positive = [self.variance, self.noise]
            .iter()
            .chain(&self.lengths)
            .all(|x| x.is_finite() && *x > 0.0);
        if positive {
            Ok(())
        } else {
            Err("a process's variance, lengths and noise must be positive".to_owned())
        }
    }
}
