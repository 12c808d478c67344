//! Gaussian process regression.
//!
//! y(x) = m + s f(x) + noise, with f of covariance k(x, x') = v exp(-1/2 sum_j ((x_j - x'_j)/l_j)^2) + b x.x'/d and noise of variance n
//! (Rasmussen and Williams 2006, chapters 2 and 5). m and s are mean and standard deviation of the training forces.
//!
//! | symbol | meaning |
//! |---|---|
//! | v, l, b, n | signal variance, length scales, variance of a line in d features, noise variance, of scaled forces |
//! | K = k(X, X) + n I = L L' | covariance of the training rows, its Cholesky factor |
//! | alpha = K^-1 y | weights of the mean |
//!
//! - `point_rows`, `row_pairs`: rows, and sums over the features of each pair of them
//! - `kernel`: k
//! - `likelihood`: log p(y | X) and its gradient
//! - `hyperparameters`: the search for its greatest value
//! - `process_posterior`: mean and deviation of new rows, and of rows left out
//!
//! The mean is conditioned on all rows that are kept. Where these are many, the deviation is that of an even subset of them: at most what
//! fewer rows leave uncertain, so never too small, and quick enough for a robot's controller.

mod hyperparameters;
mod kernel;
mod likelihood;
mod point_rows;
mod process_posterior;
mod row_pairs;

use serde::{Deserialize, Serialize};

pub(crate) use hyperparameters::SCREENED_ROWS;
pub use hyperparameters::{Bounds, Search, search};
pub use kernel::Kernel;
pub use likelihood::{Likelihood, log_likelihood};
pub use point_rows::PointRows;
pub use process_posterior::Posterior;
pub use row_pairs::RowPairs;

use crate::model::contract::{
    Effort, FitError, Prediction, Training, check_deviation, check_numbers,
};
use crate::model::even_subset::even_subset;
use crate::model::training_mean::mean_and_deviation;
use crate::recipe::{GprSettings, Lengths};

/// Rows whose posterior gives the deviation: half a megabyte of factor, which stays in a core's cache.
pub(crate) const DEVIATION_ROWS: usize = 360;
/// Sizes for folds: rows of the search, rows conditioned on, starts.
const FOLD_SEARCH_ROWS: usize = 250;
const FOLD_ROWS: usize = 800;
const FOLD_RESTARTS: usize = 6;

/// A Gaussian process that was learnt.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gpr {
    mean: f64,
    scale: f64,
    kernel: Kernel,
    rows: PointRows,
    alpha: Vec<f64>,
    /// Posterior of the even subset; made anew when the model is read.
    #[serde(skip)]
    spread: Option<Posterior>,
}

/// Sizes of a fit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sizes {
    /// Rows of the search.
    pub search_rows: usize,
    /// Rows conditioned on.
    pub most_rows: usize,
    /// Starts of the search.
    pub restarts: usize,
}

impl Sizes {
    /// Sizes of a fit to so many rows.
    pub(crate) fn of(settings: &GprSettings, effort: Effort, rows: usize) -> Self {
        let whole = Self {
            search_rows: settings.search_rows.min(rows),
            most_rows: settings.most_rows.min(rows),
            restarts: settings.restarts,
        };
        match effort {
            Effort::Whole => whole,
            Effort::Fold => Self {
                search_rows: whole.search_rows.min(FOLD_SEARCH_ROWS),
                most_rows: whole.most_rows.min(FOLD_ROWS),
                restarts: whole.restarts.min(FOLD_RESTARTS),
            },
        }
    }
}

impl Gpr {
    /// Learns hyperparameters on an even subset of the rows, then conditions on as many as are allowed.
    ///
    /// # Errors
    /// When the covariance has no Cholesky factor.
    pub fn fit(
        settings: &GprSettings,
        effort: Effort,
        seed: u64,
        training: &Training<'_>,
    ) -> Result<Self, FitError> {
        let (mean, scale) = mean_and_deviation(training.forces);
        let forces: Vec<f64> = training
            .forces
            .iter()
            .map(|force| (force - mean) / scale)
            .collect();
        let Sizes {
            search_rows,
            most_rows,
            restarts,
        } = Sizes::of(settings, effort, forces.len());
        let of = |rows: &[usize]| {
            let points =
                PointRows::from_rows(&training.features.select(ndarray::Axis(0), rows).view());
            let values: Vec<f64> = rows.iter().map(|row| forces[*row]).collect();
            (points, values)
        };
        let (points, values) = of(&even_subset(forces.len(), search_rows));
        let wanted = Search {
            each: settings.lengths == Lengths::Each,
            line: settings.line,
            restarts,
            seed,
            bounds: Bounds::default(),
        };
        let kernel =
            search(&points, &values, &wanted).ok_or(FitError::NotPositive("covariance"))?;
        let (rows, values) = of(&even_subset(forces.len(), most_rows));
        let conditioned =
            Posterior::new(&kernel, &rows, &values).ok_or(FitError::NotPositive("covariance"))?;
        let mut fitted = Self {
            mean,
            scale,
            kernel,
            alpha: conditioned.alpha().to_vec(),
            rows,
            spread: None,
        };
        fitted.spread = Some(
            fitted
                .subset_posterior()
                .ok_or(FitError::NotPositive("covariance"))?,
        );
        Ok(fitted)
    }

    /// The posterior of the subset that gives the deviation. Its mean isn't used: deviations don't depend on forces.
    fn subset_posterior(&self) -> Option<Posterior> {
        let subset = self
            .rows
            .select(&even_subset(self.rows.len(), DEVIATION_ROWS));
        let none = vec![0.0; subset.len()];
        Posterior::new(&self.kernel, &subset, &none)
    }

    /// Mean and deviation of a new reading, its noise included.
    pub fn predict(&self, features: &[f64]) -> Prediction {
        let covariances = self.kernel.with_point(&self.rows, features);
        let mean: f64 = covariances
            .iter()
            .zip(&self.alpha)
            .map(|(k, a)| k * a)
            .sum();
        let prior = self.kernel.prior(features) + self.kernel.noise;
        let variance = self
            .spread
            .as_ref()
            .map_or(prior, |spread| spread.variance(&self.kernel, features));
        Prediction {
            mean: self.mean + self.scale * mean,
            deviation: self.scale * variance.max(self.kernel.noise).sqrt(),
        }
    }

    pub(crate) fn prepare(&mut self, features: usize) -> Result<(), String> {
        self.rows.check(features)?;
        self.kernel.check(features)?;
        check_numbers("a process's weights", &self.alpha, self.rows.len())?;
        check_numbers("a process's mean", &[self.mean], 1)?;
        check_deviation("a process's scale", self.scale)?;
        self.spread = Some(
            self.subset_posterior()
                .ok_or("a process's covariance has no Cholesky factor")?,
        );
        Ok(())
    }
}
