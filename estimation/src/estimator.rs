//! What was chosen and learnt from all rows, as data: the model file.

use serde::{Deserialize, Serialize};

use crate::features::StreamSettings;
use crate::interval::factor_by;
use crate::model::contract::{Effort, FitError, Prediction};
use crate::model::feature_scale::FeatureScale;
use crate::model::fitted::Fitted;
use crate::recipe::{FeatureSet, Kind, Recipe, SplitKind};
use crate::recording::named_columns::NamedColumns;
use crate::rows::{LabelledRows, Runs};
use crate::validation::{Candidate, Judged, Learner};

/// Version of the model file. One of another version is refused.
pub const VERSION: u32 = 1;
/// What a model file says it is.
pub const FORMAT: &str = "strainsite-estimator";
/// A signal may leave the range that was learnt by this share of it before a row is flagged.
const MARGIN: f64 = 0.05;
/// On public recordings of a soft sensor a process's error on another run was 1.4 and 1.6 times that on left-out parts of its own
/// (sensors of eFlesh, normal presses: 0.98 % of the range against 1.35 and 1.55 %).
const ANOTHER_RUN: f64 = 1.5;

/// Forces from signals.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Estimator {
    /// [`FORMAT`]
    pub format: String,
    /// [`VERSION`]
    pub version: u32,
    /// The columns' names.
    pub columns: NamedColumns,
    /// What is done with rows before models read them.
    pub stream: Stream,
    /// Typical intervals between the rows of the runs that were learnt from, s: least and greatest.
    pub interval_s: (f64, f64),
    /// Least and greatest value of each signal that was learnt from, as models are given it.
    pub ranges: Vec<(f64, f64)>,
    /// What intervals promise to hold: rows of another run, or of other cycles.
    pub promise: SplitKind,
    /// One model a force, in the order of the columns.
    pub forces: Vec<ForceModel>,
    /// What was asked for.
    pub recipe: Recipe,
}

/// What is done with rows, as numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stream {
    /// Whether each run's first reading is taken off.
    pub subtract_start: bool,
    /// Whether the sign is turned.
    pub turn_sign: bool,
    /// The clock, Hz.
    pub rate_hz: Option<f64>,
    /// Rows of the moving average.
    pub smooth_rows: usize,
    /// Rows of rolling mean and variance.
    pub window_rows: usize,
    /// A longer time between rows is a pause, s.
    pub pause_s: f64,
}

/// One force's model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForceModel {
    /// What it is given.
    pub features: FeatureSet,
    /// On which scale.
    pub scale: FeatureScale,
    /// The model.
    pub model: Fitted,
    /// Deviations times this are half an interval's width.
    pub factor: f64,
}

/// A force at a row, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The force.
    pub force: f64,
    /// The interval that promises 95 %: its low end.
    pub low: f64,
    /// Its high end.
    pub high: f64,
}

/// Limits of what a model file may ask for.
const MOST_ROWS: usize = 100_000;

impl Stream {
    /// As the recipe has it, with the first reading taken off or not.
    pub fn new(runs: &Runs, recipe: &Recipe, subtract_start: bool) -> Self {
        Self {
            subtract_start,
            turn_sign: recipe.preprocess.turn_sign,
            rate_hz: recipe.preprocess.rate_hz,
            smooth_rows: recipe.preprocess.smooth_rows,
            window_rows: recipe.features.window_rows,
            pause_s: runs.pause_s,
        }
    }

    /// For the stream of features.
    pub fn settings(&self) -> StreamSettings {
        StreamSettings {
            subtract_start: self.subtract_start,
            turn_sign: self.turn_sign,
            smooth_rows: self.smooth_rows,
            window_rows: self.window_rows,
            pause_s: self.pause_s,
        }
    }

    fn check(&self) -> Result<(), String> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let windows = (1..=MOST_ROWS).contains(&self.smooth_rows)
            && (1..=MOST_ROWS).contains(&self.window_rows);
        if windows && positive(self.pause_s) && self.rate_hz.is_none_or(positive) {
            Ok(())
        } else {
            Err("the stream's windows, pause and rate must be positive".to_owned())
        }
    }
}

impl ForceModel {
    /// Learns the chosen candidate from all rows of its force.
    ///
    /// # Errors
    /// See [`FitError`].
    pub fn learn(
        judged: &Judged,
        by: SplitKind,
        rows: &LabelledRows,
        recipe: &Recipe,
    ) -> Result<Self, FitError> {
        let Candidate { kind, features } = judged.candidate;
        let all: Vec<usize> = (0..rows.forces.len()).collect();
        let learner = Learner::learn(
            Candidate { kind, features },
            rows,
            &all,
            recipe,
            Effort::Whole,
        )?;
        Ok(Self {
            features,
            scale: learner.scale,
            model: learner.model,
            factor: interval_factor(judged, by),
        })
    }

    /// Which of all features of so many signals it reads.
    pub fn columns(&self, signals: usize) -> Vec<usize> {
        match self.model {
            Fitted::Mean(_) => Vec::new(),
            _ => crate::features::columns(self.features, signals),
        }
    }

    /// The force at a row of its features, unscaled.
    pub fn estimate(&self, features: impl IntoIterator<Item = f64>) -> Estimate {
        let Prediction { mean, deviation } = self.model.predict(&self.scale.scaled(features));
        let half = self.factor * deviation;
        Estimate {
            force: mean,
            low: mean - half,
            high: mean + half,
        }
    }

    /// Which kind of model it is.
    pub fn kind(&self) -> Kind {
        match self.model {
            Fitted::Mean(_) => Kind::Mean,
            Fitted::Ridge(_) => Kind::Ridge,
            Fitted::Gpr(_) => Kind::Gpr,
            Fitted::Ann(_) => Kind::Ann,
        }
    }
}

/// From the rows that were left out. Where these are of the runs that were learnt from, it is widened by what another run brings, but never beyond the training
/// mean's error: a model that hardly knows more than the mean loses no more on another run than that.
fn interval_factor(judged: &Judged, by: SplitKind) -> f64 {
    let widened = match by {
        SplitKind::Run => 1.0,
        _ => another_run(judged, by),
    };
    let found = factor_by(by, &judged.left_out).map(|factor| factor * widened);
    found.unwrap_or(f64::MIN_POSITIVE)
}

fn another_run(judged: &Judged, by: SplitKind) -> f64 {
    judged.on(by).map_or(ANOTHER_RUN, |figures| {
        let mean_over_model = figures.mean_rmse / figures.rmse;
        // Without any error there is nothing to widen.
        if mean_over_model.is_nan() {
            1.0
        } else {
            mean_over_model.clamp(1.0, ANOTHER_RUN)
        }
    })
}

impl Estimator {
    /// Makes an estimator that was read ready to use, and checks it as if anybody could have written it.
    ///
    /// # Errors
    /// A sentence about the first thing that is wrong.
    pub fn prepare(&mut self) -> Result<(), String> {
        if self.format != FORMAT {
            return Err(format!(
                "it is no model of strainsite: format must be \"{FORMAT}\""
            ));
        }
        if self.version != VERSION {
            return Err(format!(
                "its version is {}; this program reads version {VERSION}",
                self.version
            ));
        }
        self.stream.check()?;
        let signals = self.columns.signals.len();
        if signals == 0 || self.ranges.len() != signals {
            return Err(format!(
                "there must be a range for each of the {signals} signals"
            ));
        }
        let intervals = [self.interval_s, self.interval_s];
        if self
            .ranges
            .iter()
            .chain(&intervals)
            .any(|(low, high)| !(low.is_finite() && high.is_finite() && low <= high))
        {
            return Err("ranges must be finite, low before high".to_owned());
        }
        if self.forces.is_empty() || self.forces.len() != self.columns.forces.len() {
            return Err("there must be a model for each force".to_owned());
        }
        for force in &mut self.forces {
            let features = force.columns(signals).len();
            force.scale.check(features)?;
            force.model.prepare(features)?;
            if !(force.factor.is_finite() && force.factor >= 0.0) {
                return Err("a force's factor must be positive".to_owned());
            }
        }
        Ok(())
    }

    /// Whether a row is outside of what was learnt from.
    pub fn is_outside(&self, values: &[f64]) -> bool {
        is_outside(values, &self.ranges)
    }
}

/// Whether a signal is beyond the range that was learnt by more than a twentieth of it.
pub fn is_outside(values: &[f64], ranges: &[(f64, f64)]) -> bool {
    let beyond = |(x, (low, high)): (&f64, &(f64, f64))| {
        let margin = MARGIN * (high - low);
        *x < low - margin || *x > high + margin
    };
    values.iter().zip(ranges).any(beyond)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interval::{LeftOut, factor};
    use crate::validation::SplitFigures;

    #[test]
    fn another_run_is_never_worse_than_the_mean() {
        let left_out: Vec<LeftOut> = (0..20)
            .map(|row| LeftOut {
                row,
                group: row / 10,
                truth: (row + 1) as f64,
                mean: 0.0,
                deviation: 1.0,
            })
            .collect();
        let of = |rmse: f64, by: SplitKind| {
            let figures = SplitFigures {
                rmse,
                mean_rmse: 6.0,
                rmse_interval: None,
                nrmse_percent: None,
                mean_nrmse_percent: None,
                r2: None,
                intervals: None,
            };
            let judged = Judged {
                candidate: Candidate {
                    kind: Kind::Ridge,
                    features: FeatureSet::Raw,
                },
                splits: [(by, Ok(figures))].into(),
                left_out: left_out.clone(),
            };
            interval_factor(&judged, by)
        };
        // 19 of the 20 rows are within 19 deviations.
        let found = [1.0, 5.0, 6.0, 7.0].map(|rmse| of(rmse, SplitKind::Cycle));
        for (found, widened) in found.into_iter().zip([1.5, 6.0 / 5.0, 1.0, 1.0]) {
            assert!((found - 19.0 * widened).abs() < 1e-12, "{found}");
        }
        assert_eq!(Some(of(1.0, SplitKind::Run)), factor(&left_out));
    }
}
