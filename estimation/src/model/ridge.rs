//! Ridge regression: y = m + w (x - c), with the squared weights held short.
//!
//! w = (X'X + p n I)^-1 X'y of centred rows. The penalty p is the one whose errors on left-out runs are least, or on left-out cycles of one run; the root of the mean
//! square of those on left-out cycles, within runs, is the deviation of the noise. A new row's deviation has that of the weights in it: s^2 (1 + 1/n + x'(X'X + p n I)^-1 x).

use faer::linalg::solvers::{DenseSolveCore, Llt, Solve};
use faer::{Col, Mat, Side};
use ndarray::{Array1, Array2, Axis};
use serde::{Deserialize, Serialize};

use crate::error_metrics::left_out::LeftOut;
use crate::error_metrics::run_spread::residuals_of_runs;
use crate::model::contract::{FitError, Prediction, Training, check_deviation, check_numbers};

/// Folds of left-out cycles that choose the penalty.
const FOLDS: usize = 5;
/// Penalties that are tried, as powers of ten, of scaled features.
const PENALTIES: std::ops::RangeInclusive<i32> = -12..=4;

/// A line in the features.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ridge {
    mean: f64,
    centre: Vec<f64>,
    weights: Vec<f64>,
    noise: f64,
    rows: f64,
    /// (X'X + p n I)^-1, row by row.
    covariance: Vec<f64>,
}

/// Sums over rows from which any part can be taken away.
#[derive(Debug, Clone)]
struct Sums {
    rows: f64,
    x: Array1<f64>,
    y: f64,
    xx: Array2<f64>,
    xy: Array1<f64>,
}

/// A line: centre, mean, weights, and the factor of its normal matrix.
struct Line {
    centre: Array1<f64>,
    mean: f64,
    weights: Col<f64>,
    factor: Llt<f64>,
}

impl Ridge {
    /// Learns weights and penalty.
    ///
    /// # Errors
    /// When no penalty gives a normal matrix with a Cholesky factor.
    pub fn fit(training: &Training<'_>) -> Result<Self, FitError> {
        let all = Sums::of(training, &(0..training.forces.len()).collect::<Vec<_>>());
        let cycles = LeftOutParts::of(training, &all, parts(training.cycles));
        // Weights that tell runs apart are learnt by heart: another run has other gains.
        let runs = LeftOutParts::of(training, &all, parts(training.runs));
        let has_runs = training.runs.windows(2).any(|pair| pair[0] != pair[1]);
        let choosing = if has_runs { &runs } else { &cycles };
        let penalties = PENALTIES.map(|power| 10f64.powf(f64::from(power) / 2.0));
        let judged =
            penalties.filter_map(|penalty| Some((choosing.error(training, penalty)?, penalty)));
        let not_positive = FitError::NotPositive("normal matrix");
        let (_, penalty) = judged
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .ok_or(not_positive)?;
        let error = cycles
            .error_within_runs(training, penalty)
            .ok_or(not_positive)?;
        let line = all
            .line(penalty)
            .ok_or(FitError::NotPositive("normal matrix"))?;
        let inverse = line.factor.inverse();
        let features = line.centre.len();
        Ok(Self {
            mean: line.mean,
            centre: line.centre.to_vec(),
            weights: line.weights.iter().copied().collect(),
            noise: if error > 0.0 {
                error
            } else {
                f64::MIN_POSITIVE.sqrt()
            },
            rows: all.rows,
            covariance: (0..features)
                .flat_map(|i| (0..features).map(move |j| (i, j)))
                .map(|at| inverse[at])
                .collect(),
        })
    }

    /// The line's value, and how far readings are from it.
    pub fn predict(&self, features: &[f64]) -> Prediction {
        let x: Vec<f64> = features
            .iter()
            .zip(&self.centre)
            .map(|(x, c)| x - c)
            .collect();
        let dot = |a: &[f64]| a.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>();
        let spread: f64 = self
            .covariance
            .chunks_exact(x.len().max(1))
            .zip(&x)
            .map(|(row, x)| x * dot(row))
            .sum();
        Prediction {
            mean: self.mean + dot(&self.weights),
            deviation: self.noise * (1.0 + 1.0 / self.rows + spread.max(0.0)).sqrt(),
        }
    }

    pub(crate) fn prepare(&mut self, features: usize) -> Result<(), String> {
        check_numbers("a line's mean and rows", &[self.mean, self.rows], 2)?;
        check_numbers("a line's centre", &self.centre, features)?;
        check_numbers("a line's weights", &self.weights, features)?;
        check_numbers(
            "a line's covariance",
            &self.covariance,
            features.saturating_mul(features),
        )?;
        check_deviation("a line's rows", self.rows)?;
        check_deviation("a line's noise", self.noise)
    }
}

/// Rows of every fifth cycle; of every fifth row where there is one cycle.
fn parts(cycles: &[usize]) -> Vec<Vec<usize>> {
    let mut distinct: Vec<usize> = cycles.to_vec();
    distinct.sort_unstable();
    distinct.dedup();
    let one = distinct.len() < 2;
    let part = |row: usize| match one {
        true => row % FOLDS,
        false => distinct.partition_point(|other| *other < cycles[row]) % FOLDS,
    };
    let of_part = |number: usize| {
        (0..cycles.len())
            .filter(|row| part(*row) == number)
            .collect::<Vec<_>>()
    };
    (0..FOLDS)
        .map(of_part)
        .filter(|rows| !rows.is_empty())
        .collect()
}

/// Parts of the rows, and the sums of all others.
struct LeftOutParts {
    parts: Vec<Vec<usize>>,
    rest: Vec<Sums>,
}

impl LeftOutParts {
    fn of(training: &Training<'_>, all: &Sums, parts: Vec<Vec<usize>>) -> Self {
        let rest = parts.iter();
        let rest = rest.map(|part| all.without(&Sums::of(training, part)));
        Self {
            rest: rest.collect(),
            parts,
        }
    }

    /// Estimates of rows that a line wasn't learnt from.
    fn left_out(&self, training: &Training<'_>, penalty: f64) -> Option<Vec<LeftOut>> {
        let mut said = Vec::with_capacity(training.forces.len());
        for (part, sums) in self.parts.iter().zip(&self.rest) {
            let line = sums.line(penalty)?;
            for row in part {
                let x = training.features.row(*row);
                let moved = x.iter().zip(&line.centre).zip(line.weights.iter());
                said.push(LeftOut {
                    row: *row,
                    group: training.runs[*row],
                    truth: training.forces[*row],
                    mean: line.mean + moved.map(|((x, c), w)| w * (x - c)).sum::<f64>(),
                    deviation: 1.0,
                    is_suspect: false,
                });
            }
        }
        Some(said)
    }

    /// Root of the mean squared error on rows that a line wasn't learnt from.
    fn error(&self, training: &Training<'_>, penalty: f64) -> Option<f64> {
        let said = self.left_out(training, penalty)?;
        Some(root_mean_square(
            said.iter().map(|row| row.truth - row.mean),
        ))
    }

    /// Error once each run's own zero and gain are known: a line from one run and one from several then have the same noise.
    fn error_within_runs(&self, training: &Training<'_>, penalty: f64) -> Option<f64> {
        let said = self.left_out(training, penalty)?;
        let runs = residuals_of_runs(&said, |_| 1.0);
        Some(root_mean_square(
            runs.into_iter().flat_map(|run| run.within),
        ))
    }
}

fn root_mean_square(numbers: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = numbers.fold((0.0, 0.0), |(sum, count), x| (sum + x * x, count + 1.0));
    (sum / f64::max(count, 1.0)).sqrt()
}

impl Sums {
    fn of(training: &Training<'_>, rows: &[usize]) -> Self {
        let x = training.features.select(Axis(0), rows);
        let y: Array1<f64> = rows.iter().map(|row| training.forces[*row]).collect();
        Self {
            rows: rows.len() as f64,
            x: x.sum_axis(Axis(0)),
            y: y.sum(),
            xx: x.t().dot(&x),
            xy: x.t().dot(&y),
        }
    }

    fn without(&self, part: &Self) -> Self {
        Self {
            rows: self.rows - part.rows,
            x: &self.x - &part.x,
            y: self.y - part.y,
            xx: &self.xx - &part.xx,
            xy: &self.xy - &part.xy,
        }
    }

    fn line(&self, penalty: f64) -> Option<Line> {
        let centre = &self.x / self.rows.max(1.0);
        let mean = self.y / self.rows.max(1.0);
        let n = centre.len();
        let normal = Mat::from_fn(n, n, |i, j| {
            let diagonal = if i == j {
                penalty * self.rows.max(1.0)
            } else {
                0.0
            };
            self.xx[[i, j]] - self.rows * centre[i] * centre[j] + diagonal
        });
        let factor = Llt::new(normal.as_ref(), Side::Lower).ok()?;
        let weights = factor.solve(&Col::from_fn(n, |i| {
            self.xy[i] - self.rows * centre[i] * mean
        }));
        Some(Line {
            centre,
            mean,
            weights,
            factor,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_found_again() {
        let x = Array2::from_shape_fn((40, 2), |(i, j)| ((i * (j + 2)) as f64).sin());
        let y: Vec<f64> = x
            .rows()
            .into_iter()
            .map(|x| 3.0 + 2.0 * x[0] - x[1])
            .collect();
        let cycles: Vec<usize> = (0..40).map(|row| row / 4).collect();
        let training = Training {
            features: x.view(),
            forces: &y,
            cycles: &cycles,
            runs: &[0; 40],
        };
        let mut ridge = Ridge::fit(&training).expect("a line");
        // The least penalty, 1e-6, shortens the weights by a part of 1e-6 / 0.5, the variance of a sine.
        let found = ridge.predict(&[10.0, -5.0]);
        assert!((found.mean - 28.0).abs() < 1e-4, "{}", found.mean);
        assert!(found.deviation > 0.0 && found.deviation < 1e-3);
        assert!(ridge.prepare(2).is_ok() && ridge.prepare(3).is_err());
    }
}
