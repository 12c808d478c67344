//! The training rows' mean: what every model has to beat.

use serde::{Deserialize, Serialize};

use crate::model::contract::{Prediction, Training, check_deviation, check_numbers};

/// A number, whatever the signals say.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TrainingMean {
    mean: f64,
    deviation: f64,
}

impl TrainingMean {
    /// Mean and standard deviation of the training rows' forces.
    pub fn fit(training: &Training<'_>) -> Self {
        let (mean, deviation) = mean_and_deviation(training.forces);
        Self { mean, deviation }
    }

    /// The mean.
    pub fn predict(&self) -> Prediction {
        Prediction {
            mean: self.mean,
            deviation: self.deviation,
        }
    }

    pub(crate) fn check(&self) -> Result<(), String> {
        check_numbers("a mean", &[self.mean], 1)?;
        check_deviation("a mean's deviation", self.deviation)
    }
}

/// Mean and standard deviation, the latter 1 where nothing varies.
pub(crate) fn mean_and_deviation(forces: &[f64]) -> (f64, f64) {
    let count = forces.len().max(1) as f64;
    let mean = forces.iter().sum::<f64>() / count;
    let squares: f64 = forces.iter().map(|f| (f - mean) * (f - mean)).sum();
    let deviation = (squares / count).sqrt();
    (mean, if deviation > 0.0 { deviation } else { 1.0 })
}
