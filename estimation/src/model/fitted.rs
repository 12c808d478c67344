//! A learnt model of any kind.

use serde::{Deserialize, Serialize};

use crate::model::ann::Ensemble;
use crate::model::contract::{Effort, FitError, Prediction, Training};
use crate::model::gpr::Gpr;
use crate::model::ridge::Ridge;
use crate::model::training_mean::TrainingMean;
use crate::recipe::{Kind, Models};

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
        Kind::Blend => return Err(FitError::NotAlone),
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
    /// Predicts the force from a row's features.
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
