//! Models of one force, one contract: rows of features in, a mean and its standard deviation out.
//!
//! - [`feature_scale`]: features on one scale
//! - [`training_mean`], [`ridge`], [`gpr`], [`ann`]: the models
//! - `box_search`: the least value of a smooth function within bounds
//! - `even_subset`: fewer rows, evenly taken

pub mod ann;
mod box_search;
mod even_subset;
pub mod feature_scale;
pub mod gpr;
pub mod ridge;
pub mod training_mean;

use ndarray::ArrayView2;
use serde::{Deserialize, Serialize};

use crate::model::ann::Ensemble;
use crate::model::gpr::Gpr;
use crate::model::ridge::Ridge;
use crate::model::training_mean::TrainingMean;
use crate::recipe::{Kind, Models};

/// What a model says of a row: the force, and how far off it may be as one standard deviation, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prediction {
    /// N
    pub mean: f64,
    /// N, positive
    pub deviation: f64,
}

/// What a model is learnt from.
#[derive(Debug, Clone, Copy)]
pub struct Training<'a> {
    /// Rows x features, on one scale.
    pub features: ArrayView2<'a, f64>,
    /// The force of each row, N.
    pub forces: &'a [f64],
    /// The cycle of each row: what a model leaves out of its own learning, it leaves out by cycles.
    pub cycles: &'a [usize],
}

/// How much work is put into a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// For one fold of a split: fewer rows, starts and networks.
    Fold,
    /// For the model that is kept.
    Whole,
}

/// Why nothing was learnt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
    /// A covariance or normal matrix has no Cholesky factor.
    #[error("the {0} has no Cholesky factor: features are equal or too large")]
    NotPositive(&'static str),
    /// No network has a finite loss.
    #[error("no network has a finite loss")]
    NoLoss,
    /// Poisson's loss takes no negative forces.
    #[error("the Poisson loss takes forces of 0 and more; a training row has a negative one")]
    Negative,
}

/// A model that was learnt.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
pub enum Fitted {
    /// The training rows' mean.
    Mean(TrainingMean),
    /// A line in the features.
    Ridge(Ridge),
    /// A Gaussian process.
    Gpr(Gpr),
    /// The mean of neural networks.
    Ann(Ensemble),
}

/// Learns a model.
///
/// # Errors
/// See [`FitError`].
pub fn fit(
    kind: Kind,
    settings: &Models,
    effort: Effort,
    training: &Training<'_>,
) -> Result<Fitted, FitError> {
    Ok(match kind {
        Kind::Mean => Fitted::Mean(TrainingMean::fit(training)),
        Kind::Ridge => Fitted::Ridge(Ridge::fit(training)?),
        Kind::Gpr => Fitted::Gpr(Gpr::fit(&settings.gpr, effort, settings.seed, training)?),
        Kind::Ann => Fitted::Ann(Ensemble::fit(
            &settings.ann,
            effort,
            settings.seed,
            training,
        )?),
    })
}

impl Fitted {
    /// What it says of a row's features.
    pub fn predict(&self, features: &[f64]) -> Prediction {
        match self {
            Self::Mean(model) => model.predict(),
            Self::Ridge(model) => model.predict(features),
            Self::Gpr(model) => model.predict(features),
            Self::Ann(model) => model.predict(features),
        }
    }

    /// Makes a model that was read ready: what follows from its numbers isn't stored.
    ///
    /// # Errors
    /// A sentence, when its numbers don't make a model of so many features.
    pub fn prepare(&mut self, features: usize) -> Result<(), String> {
        match self {
            Self::Mean(model) => model.check(),
            Self::Ridge(model) => model.prepare(features),
            Self::Gpr(model) => model.prepare(features),
            Self::Ann(model) => model.check(features),
        }
    }
}

/// Numbers of a model that was read: finite, and so many.
fn check_numbers(what: &str, numbers: &[f64], count: usize) -> Result<(), String> {
    if numbers.len() != count {
        return Err(format!(
            "{what} must have {count} numbers; it has {}",
            numbers.len()
        ));
    }
    if numbers.iter().any(|x| !x.is_finite()) {
        return Err(format!("{what} has a number that isn't finite"));
    }
    Ok(())
}

/// A deviation of a model that was read.
fn check_deviation(what: &str, deviation: f64) -> Result<(), String> {
    if deviation.is_finite() && deviation > 0.0 {
        Ok(())
    } else {
        Err(format!("{what} must be positive; it is {deviation}"))
    }
}
