//! Estimator: what was chosen and learnt from all rows, as data, the model file.

use ndarray::Array2;
use serde::{Deserialize, Serialize};

use crate::error_metrics::interval::factor_by;
use crate::features::{GROUPS, StreamSettings, columns};
use crate::model::contract::{FitError, Prediction};
use crate::recipe::{FeatureSet, Kind, MOST_BASELINE_S, Recipe, SplitKind};
use crate::recording::named_columns::NamedColumns;
use crate::relations::learnt_relations::Relations;
use crate::rows::{LabelledRows, Runs, Start};
use crate::validation::{Judged, LearntModel};

/// Version of the model file. One of another version is refused.
pub const VERSION: u32 = 2;
/// Name of the format, which a model file says it has.
pub const FORMAT: &str = "strainsite-estimator";
/// A signal may leave the range that was learnt by this share of it before a row is flagged.
const MARGIN: f64 = 0.05;
/// Another feature may leave its range by this share of it: slopes and variances of unseen runs do by half in some 1 % of their rows, and a spike in a window by a hundred times it.
const FEATURE_MARGIN: f64 = 0.5;
/// Ratio of a process's error on another run to that on left-out parts of its own: on public recordings of a soft sensor 1.4 and 1.6 (sensors of
/// eFlesh, normal presses: 0.98 % of the range against 1.35 and 1.55 %).
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
    /// Treatment of rows before models read them.
    pub stream: Stream,
    /// Signals without a force, in their own units; `None` where no run was unloaded, and in models of earlier versions.
    #[serde(default)]
    pub zero: Option<Vec<f64>>,
    /// Typical intervals between the rows of the runs that were learnt from, s: least and greatest.
    pub interval_s: (f64, f64),
    /// Least and greatest value of each signal that was learnt from, as models are given it.
    pub ranges: Vec<(f64, f64)>,
    /// Least and greatest value of all features that the models read; `None` in models of earlier versions.
    #[serde(default)]
    pub feature_ranges: Option<FeatureRanges>,
    /// Relations of the signals to each other; `None` where too little tells it, and in models of earlier versions.
    #[serde(default)]
    pub relations: Option<Relations>,
    /// Split whose left-out rows the intervals promise to hold: rows of another run, or of other cycles.
    pub promise: SplitKind,
    /// Models, one a force, in the order of the columns.
    pub forces: Vec<ForceModel>,
    /// Recipe that was asked for.
    pub recipe: Recipe,
}

/// Least and greatest value of features that were learnt from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FeatureRanges {
    /// Features that models read.
    pub features: FeatureSet,
    /// Ranges of them, group by group, each with an entry a signal.
    pub ranges: Vec<(f64, f64)>,
}

impl FeatureRanges {
    /// The ranges of what these models read, among all features of all rows of runs.
    pub fn of(forces: &[ForceModel], runs: &Runs, features: &Array2<f64>) -> Option<Self> {
        let members = forces.iter().flat_map(|force| &force.members);
        let read = members
            .map(|member| member.features)
            .reduce(FeatureSet::with)?;
        let columns = columns(read, features.ncols() / GROUPS);
        Some(Self {
            features: read,
            ranges: columns
                .map(|column| runs.feature_range(features, column))
                .collect(),
        })
    }

    /// Whether a feature is beyond its range by more than half of it.
    fn is_outside(&self, features: &[f64]) -> bool {
        let read = columns(self.features, features.len() / GROUPS);
        let mut pairs = read.zip(&self.ranges);
        pairs.any(|(column, range)| is_beyond(features[column], *range, FEATURE_MARGIN))
    }
}

/// Treatment of rows, as numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stream {
    /// Whether each run's first reading is taken off.
    pub subtract_start: bool,
    /// First readings whose median that is.
    #[serde(default = "crate::recipe::first_reading")]
    pub start_rows: usize,
    /// Whether the sign is turned.
    pub turn_sign: bool,
    /// The clock, Hz.
    pub rate_hz: Option<f64>,
    /// Rows of the moving average.
    pub smooth_rows: usize,
    /// Rows of rolling mean and variance.
    pub window_rows: usize,
    /// Seconds of the baseline's median; `None` where no model reads what is over it, as in models of earlier versions.
    #[serde(default)]
    pub baseline_s: Option<f64>,
    /// A longer time between rows is a pause, s.
    pub pause_s: f64,
}

/// Model of one force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForceModel {
    /// The models whose median is the estimate: one, or a blend's.
    pub members: Vec<LearntModel>,
    /// Deviations times this are half an interval's width.
    pub factor: f64,
    /// Force beyond which a first reading is a load by the model's zero, N; `None` in models of earlier versions.
    #[serde(default)]
    pub loaded_above_n: Option<f64>,
}

/// A force at a row, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The force.
    pub force: f64,
    /// The interval that promises 95 %: its low end.
    pub low: f64,
    /// High end of the interval.
    pub high: f64,
}

/// Limits of what a model file may ask for.
const MOST_ROWS: usize = 100_000;
const MOST_START_ROWS: usize = 1000;
const MOST_MEMBERS: usize = 12;

impl Stream {
    /// Makes the treatment that the recipe asks for, with this taken off.
    pub fn new(runs: &Runs, recipe: &Recipe, start: Start) -> Self {
        Self {
            subtract_start: start != Start::Kept,
            start_rows: recipe.preprocess.start_rows,
            turn_sign: recipe.preprocess.turn_sign,
            rate_hz: recipe.preprocess.rate_hz,
            smooth_rows: recipe.preprocess.smooth_rows,
            window_rows: recipe.features.window_rows,
            baseline_s: recipe.features.baseline_s(),
            pause_s: runs.pause_s,
        }
    }

    /// Returns the settings for the stream of features.
    pub fn settings(&self) -> StreamSettings {
        StreamSettings {
            subtract_start: self.subtract_start,
            start_rows: self.start_rows,
            turn_sign: self.turn_sign,
            smooth_rows: self.smooth_rows,
            window_rows: self.window_rows,
            baseline_s: self.baseline_s,
            pause_s: self.pause_s,
        }
    }

    fn check(&self) -> Result<(), String> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let windows = (1..=MOST_ROWS).contains(&self.smooth_rows)
            && (1..=MOST_ROWS).contains(&self.window_rows)
            && (1..=MOST_START_ROWS).contains(&self.start_rows);
        let seconds = |x: f64| positive(x) && x <= MOST_BASELINE_S;
        if !(windows && positive(self.pause_s) && self.rate_hz.is_none_or(positive)) {
            return Err("the stream's windows, pause and rate must be positive".to_owned());
        }
        if !self.baseline_s.is_none_or(seconds) {
            return Err(format!(
                "the stream's baseline must have 0 to {MOST_BASELINE_S} s"
            ));
        }
        Ok(())
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
        let members = judged.members.iter();
        let learnt = members.map(|member| LearntModel::whole(*member, rows, recipe));
        Ok(Self::of(
            learnt.collect::<Result<_, _>>()?,
            judged,
            by,
            rows,
        ))
    }

    /// Members that were learnt, with intervals as wide as their left-out rows ask for.
    pub fn of(
        members: Vec<LearntModel>,
        judged: &Judged,
        by: SplitKind,
        rows: &LabelledRows,
    ) -> Self {
        let sharper = match members.as_slice() {
            [line] if line.candidate().kind == Kind::Ridge => sharper(line, judged, by, rows),
            _ => 1.0,
        };
        Self {
            members,
            factor: sharper * interval_factor(judged, by),
            loaded_above_n: None,
        }
    }

    /// The force at a row of all features.
    pub fn estimate(&self, features: &[f64]) -> Estimate {
        let members = self.members.iter();
        let said: Vec<Prediction> = members.map(|member| member.predict(features)).collect();
        let Prediction { mean, deviation } = Prediction::together(&said);
        let half = self.factor * deviation;
        Estimate {
            force: mean,
            low: mean - half,
            high: mean + half,
        }
    }
}

/// Returns the interval's factor on deviations of models that were learnt from folds, learnt from the rows that were left out. Where these are of the runs that were learnt from, it is widened by what another run
/// brings, but never beyond the training mean's error: a model that hardly knows more than the mean loses no more on another run than that.
pub fn interval_factor(judged: &Judged, by: SplitKind) -> f64 {
    let widened = match by {
        SplitKind::Run => 1.0,
        _ => another_run(judged, by),
    };
    let found = factor_by(by, judged.left_out(by)).map(|factor| factor * widened);
    found.unwrap_or(f64::MIN_POSITIVE)
}

/// Factor by which the deviations of a line's folds are larger than its own at the same rows: intervals stay as wide as they were tested. A line from one run takes what
/// tells runs apart for unknown; one from several may not. Processes know the rows that they learnt from, so that theirs can't be compared.
fn sharper(line: &LearntModel, judged: &Judged, by: SplitKind, rows: &LabelledRows) -> f64 {
    let (mut of_folds, mut own) = (0.0, 0.0);
    for row in judged.left_out(by) {
        let features = rows.features.row(row.row).to_vec();
        of_folds += row.deviation.powi(2);
        own += line.predict(&features).deviation.powi(2);
    }
    let found = f64::sqrt(of_folds / own);
    if found.is_finite() && found > 0.0 {
        found
    } else {
        1.0
    }
}

fn another_run(judged: &Judged, by: SplitKind) -> f64 {
    judged.on(by).map_or(ANOTHER_RUN, |figures| {
        let errors = figures.choosing();
        let mean_over_model = errors.mean_rmse / errors.rmse;
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
        let zero = self.zero.as_ref();
        if zero.is_some_and(|zero| zero.len() != signals || !zero.iter().all(|x| x.is_finite())) {
            return Err(format!("the zero must be {signals} finite numbers"));
        }
        let intervals = [self.interval_s, self.interval_s];
        let others = self.feature_ranges.as_ref();
        if others
            .is_some_and(|others| others.ranges.len() != columns(others.features, signals).count())
        {
            return Err(format!(
                "there must be a range for each feature of the {signals} signals that models read"
            ));
        }
        if self
            .ranges
            .iter()
            .chain(others.iter().flat_map(|others| &others.ranges))
            .chain(&intervals)
            .any(|(low, high)| !(low.is_finite() && high.is_finite() && low <= high))
        {
            return Err("ranges must be finite, low before high".to_owned());
        }
        if let Some(relations) = &self.relations {
            relations.check(signals)?;
        }
        if self.forces.is_empty() || self.forces.len() != self.columns.forces.len() {
            return Err("there must be a model for each force".to_owned());
        }
        for force in &mut self.forces {
            if force.members.is_empty() || force.members.len() > MOST_MEMBERS {
                return Err(format!(
                    "a force must have 1 to {MOST_MEMBERS} models; it has {}",
                    force.members.len()
                ));
            }
            for member in &mut force.members {
                member.prepare(signals)?;
            }
            let loaded_above = force.loaded_above_n.unwrap_or_default();
            if ![force.factor, loaded_above]
                .iter()
                .all(|x| x.is_finite() && *x >= 0.0)
            {
                return Err(
                    "a force's factor and the load at which it begins loaded must be positive"
                        .to_owned(),
                );
            }
        }
        Ok(())
    }

    /// Whether a row of all features is outside of what was learnt from: a signal, or whatever else the models read.
    pub fn is_outside(&self, features: &[f64]) -> bool {
        let others = self.feature_ranges.as_ref();
        is_outside(features, &self.ranges)
            || others.is_some_and(|others| others.is_outside(features))
    }
}

/// Whether a signal is beyond the range that was learnt by more than a twentieth of it.
pub fn is_outside(values: &[f64], ranges: &[(f64, f64)]) -> bool {
    let mut pairs = values.iter().zip(ranges);
    pairs.any(|(x, range)| is_beyond(*x, *range, MARGIN))
}

fn is_beyond(x: f64, (low, high): (f64, f64), margin: f64) -> bool {
    let margin = margin * (high - low);
    x < low - margin || x > high + margin
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error_metrics::left_out::LeftOut;
    use crate::recipe::{FeatureSet, Kind};
    use crate::validation::{Candidate, Outcome, SplitFigures, Tested};

    #[test]
    fn another_run_is_never_worse_than_the_mean() {
        let left_out: Vec<LeftOut> = (0..20)
            .map(|row| LeftOut {
                row,
                group: row / 10,
                truth: (row + 1) as f64,
                mean: 0.0,
                deviation: 1.0,
                is_suspect: false,
            })
            .collect();
        let of = |rmse: f64, by: SplitKind| {
            let figures = SplitFigures {
                rmse,
                mean_rmse: 6.0,
                sound: None,
                rmse_interval: None,
                nrmse_percent: None,
                mean_nrmse_percent: None,
                r2: None,
                intervals: None,
            };
            let candidate = Candidate {
                kind: Kind::Ridge,
                features: FeatureSet::Raw,
            };
            let outcome = Outcome {
                figures,
                tested: Tested {
                    left_out: left_out.clone(),
                    means: Vec::new(),
                },
            };
            let judged = Judged {
                candidate,
                members: vec![candidate],
                splits: [(by, Ok(outcome))].into(),
            };
            interval_factor(&judged, by)
        };
        // 19 of the 20 rows are within 19 deviations.
        let found = [1.0, 5.0, 6.0, 7.0].map(|rmse| of(rmse, SplitKind::Cycle));
        for (found, widened) in found.into_iter().zip([1.5, 6.0 / 5.0, 1.0, 1.0]) {
            assert!((found - 19.0 * widened).abs() < 1e-12, "{found}");
        }
        assert_eq!(
            Some(of(1.0, SplitKind::Run)),
            factor_by(SplitKind::Run, &left_out)
        );
    }
}
