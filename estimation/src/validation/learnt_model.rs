//! A model with what it is given.

use ndarray::{Array2, ArrayView1, Axis};
use serde::{Deserialize, Serialize};
use statrs::distribution::{ContinuousCDF, Normal};

use crate::error_metrics::order_statistics::upper_median;
use crate::features::{GROUPS, columns};
use crate::model::contract::{Effort, FitError, Prediction, Training};
use crate::model::feature_scale::FeatureScale;
use crate::model::fitted::{Fitted, fit};
use crate::recipe::{FeatureSet, Kind, Recipe, SuspectRows};
use crate::rows::LabelledRows;
use crate::rows::suspect_rows::SuspectRow;
use crate::validation::candidate::Candidate;

/// A model that was learnt, with the features that it reads and their scale.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LearntModel {
    /// Features that it is given.
    pub features: FeatureSet,
    /// Scale of the features.
    pub scale: FeatureScale,
    /// The model.
    pub model: Fitted,
}

/// Ranges beyond which values aren't believed, by the feature's group: no load that is worth estimating is ten times as large as all that was learnt
/// from, or comes a hundred times as fast.
const REACH: [f64; GROUPS] = [10.0, 100.0, 10.0, 100.0, 10.0];
/// Fewer rows are learnt nothing from once some are left out.
const FEWEST_ROWS: usize = 10;
/// Median of the sizes of normal deviates, which their median's reciprocal 1.4826 makes a deviation of.
const NORMAL_MEDIAN: f64 = 0.6745;
/// Values on either side of the median that may be outliers, at least, and as one of so many.
const FEWEST_FAR: usize = 2;
const ONE_FAR_OF: usize = 10;

impl LearntModel {
    /// Learns scale and model from some of the rows.
    ///
    /// # Errors
    /// See [`FitError`].
    pub fn learn(
        candidate: Candidate,
        rows: &LabelledRows,
        train: &[usize],
        recipe: &Recipe,
        effort: Effort,
    ) -> Result<Self, FitError> {
        let signals = rows.features.ncols() / GROUPS;
        let columns: Vec<usize> = read_columns(candidate, signals).collect();
        let is_suspect =
            |row: &usize| holds_suspect(&rows.suspect[*row], columns.iter().map(|c| c / signals));
        let asked = train.len();
        let mut train = train.to_vec();
        if recipe.preprocess.suspect_rows == SuspectRows::LeaveOut {
            train.retain(|row| !is_suspect(row));
        }
        if let Some(most) = recipe.preprocess.outlier_z {
            train = without_outliers(&rows.features, &train, signals, most);
        }
        if train.len() < asked.min(FEWEST_ROWS) {
            return Err(FitError::TooFew);
        }
        let of = |meant: &[usize]| {
            let features = rows.features.select(Axis(0), meant);
            features.select(Axis(1), &columns)
        };
        // Whether suspect rows are learnt from or not, they say nothing of the scale.
        let sound: Vec<usize> = train.iter().filter(|r| !is_suspect(r)).copied().collect();
        let of_scale = if sound.is_empty() { &train } else { &sound };
        let reach = columns.iter().map(|column| REACH[column / signals]);
        let scale = FeatureScale::learn(recipe.preprocess.scale, &of(of_scale).view(), reach);
        let features = scale.scaled_rows(&of(&train).view());
        let forces: Vec<f64> = train.iter().map(|row| rows.forces[*row]).collect();
        let cycles: Vec<usize> = train.iter().map(|row| rows.places[*row].cycle).collect();
        let runs: Vec<usize> = train.iter().map(|row| rows.places[*row].run).collect();
        let training = Training {
            features: features.view(),
            forces: &forces,
            cycles: &cycles,
            runs: &runs,
        };
        Ok(Self {
            features: candidate.features,
            scale,
            model: fit(candidate.kind, &recipe.models, effort, &training)?,
        })
    }

    /// Learns from all rows what is kept.
    ///
    /// # Errors
    /// See [`FitError`].
    pub fn whole(
        candidate: Candidate,
        rows: &LabelledRows,
        recipe: &Recipe,
    ) -> Result<Self, FitError> {
        let all: Vec<usize> = (0..rows.forces.len()).collect();
        Self::learn(candidate, rows, &all, recipe, Effort::Whole)
    }

    /// Predicts the force from a row of all features.
    pub fn predict(&self, features: &[f64]) -> Prediction {
        let columns = read_columns(self.candidate(), features.len() / GROUPS);
        let read = columns.map(|column| features[column]);
        self.model.predict(&self.scale.scaled(read))
    }

    /// Model and features.
    pub fn candidate(&self) -> Candidate {
        let kind = match self.model {
            Fitted::Mean(_) => Kind::Mean,
            Fitted::Ridge(_) => Kind::Ridge,
            Fitted::Gpr(_) => Kind::Gpr,
            Fitted::Ann(_) => Kind::Ann,
        };
        Candidate {
            kind,
            features: self.features,
        }
    }

    /// Makes a model that was read ready to use with so many signals.
    ///
    /// # Errors
    /// A sentence about the first thing that is wrong.
    pub fn prepare(&mut self, signals: usize) -> Result<(), String> {
        let features = read_columns(self.candidate(), signals).count();
        self.scale.check(features)?;
        self.model.prepare(features)
    }
}

/// The columns that a candidate reads among all features of so many signals: the training mean reads none.
fn read_columns(candidate: Candidate, signals: usize) -> impl Iterator<Item = usize> {
    let reads = candidate.kind != Kind::Mean;
    columns(candidate.features, signals).filter(move |_| reads)
}

/// Whether a row's force is suspect, or the window of a feature of these groups holds a suspect reading.
fn holds_suspect(row: &SuspectRow, mut groups: impl Iterator<Item = usize>) -> bool {
    row.force || groups.any(|group| row.groups[group])
}

/// Rows none of whose signals is further than so many robust deviations from its median over these rows.
fn without_outliers(
    features: &Array2<f64>,
    train: &[usize],
    signals: usize,
    most: f64,
) -> Vec<usize> {
    let values = features.select(Axis(0), train);
    let spreads: Vec<Option<Spread>> = values
        .columns()
        .into_iter()
        .take(signals)
        .map(Spread::of)
        .collect();
    let is_near = |(x, spread): (&f64, &Option<Spread>)| {
        spread
            .as_ref()
            .is_none_or(|spread| spread.deviations(*x) <= most)
    };
    let kept = |row: &usize| features.row(*row).iter().zip(&spreads).all(is_near);
    train.iter().copied().filter(kept).collect()
}

/// Median of a signal, and its robust deviations below and above it: signals that rest and are loaded go further to one side.
struct Spread {
    median: f64,
    below: f64,
    above: f64,
}

impl Spread {
    /// Spread of these values; none of those that rest but for a few.
    fn of(values: ArrayView1<'_, f64>) -> Option<Self> {
        let median = upper_median(values.iter().copied())?;
        let of_side = |sign: f64| {
            let distances = values.iter().map(|x| sign * (x - median));
            robust_deviation(distances.filter(|distance| *distance >= 0.0).collect())
        };
        let (below, above) = (of_side(-1.0), of_side(1.0));
        // What never goes to one side is as far there as on the other.
        let or = |deviation: f64, other: f64| if deviation > 0.0 { deviation } else { other };
        (below.max(above) > 0.0).then_some(Self {
            median,
            below: or(below, above),
            above: or(above, below),
        })
    }

    /// Distance of a value from the median, in robust deviations.
    fn deviations(&self, x: f64) -> f64 {
        let side = if x < self.median {
            self.below
        } else {
            self.above
        };
        (x - self.median).abs() / side
    }
}

/// Deviation of normal deviates with such distances to one side of their median: by the median distance, or by what all but a tenth keep within where that
/// is wider, as of a signal that rests most of the time.
fn robust_deviation(mut distances: Vec<f64>) -> f64 {
    distances.sort_by(f64::total_cmp);
    let count = distances.len();
    let few = FEWEST_FAR.max(count / ONE_FAR_OF);
    let middle = distances.get(count / 2).map_or(0.0, |x| x / NORMAL_MEDIAN);
    let Some(widest) = count.checked_sub(1 + few).map(|place| distances[place]) else {
        return middle;
    };
    // Of n deviates the k + 1st from the end is near the quantile (k + 5/8) / (n + 1/4) (Blom 1958); both signs share it.
    let share = (few as f64 + 0.625) / (count as f64 + 0.25);
    let of_normal = Normal::standard().inverse_cdf(1.0 - 0.5 * share);
    middle.max(widest / of_normal)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept(signal: &[f64], most: f64) -> Vec<usize> {
        let features = Array2::from_shape_fn((signal.len(), GROUPS), |(row, group)| match group {
            0 => signal[row],
            _ => 1e6 * row as f64,
        });
        let train: Vec<usize> = (0..signal.len()).collect();
        without_outliers(&features, &train, 1, most)
    }

    #[test]
    fn outliers_are_told_by_median_and_deviations_that_they_do_not_move() {
        // 0 to 100: the median is 50, that of the distances to either side 25; 45 of 50 keep within 45, which is 28 deviations.
        let mut signal: Vec<f64> = (0..101).map(f64::from).collect();
        let spread = Spread::of(ArrayView1::from(&signal)).expect("varies");
        for deviation in [spread.below, spread.above] {
            assert!((deviation - 25.0 / 0.6745).abs() < 1e-12);
        }
        // 1.36 deviations are 50.4.
        assert_eq!(kept(&signal, 1.36).len(), 101);
        assert_eq!(kept(&signal, 1.34), (1..100).collect::<Vec<_>>());
        // Five spikes of a hundred: means and deviations would let them pass.
        (40..45).for_each(|row| signal[row] = 1e4);
        let without: Vec<usize> = (0..40).chain(45..101).collect();
        assert_eq!(kept(&signal, 4.0), without);
    }

    #[test]
    fn loads_of_a_signal_that_rests_are_no_outliers() {
        let rests = |loaded: usize| -> Vec<f64> {
            let x = |row: usize| match row {
                row if row < loaded => 100.0 + row as f64,
                row => (row as f64).sin(),
            };
            (0..200).map(x).collect()
        };
        // A tenth of a side may be far: ten of the 100 above the median.
        assert_eq!(kept(&rests(11), 4.0).len(), 200);
        assert_eq!(kept(&rests(10), 4.0).len(), 190);
        // Squares of what is evenly spread go to one side.
        let skewed: Vec<f64> = (0..100).map(|row| f64::from(row * row)).collect();
        assert_eq!(kept(&skewed, 2.0).len(), 100);
        // One that stands still but for a few rows tells no deviation.
        let still: Vec<f64> = (0..200).map(|row| f64::from(u8::from(row < 3))).collect();
        assert_eq!(kept(&still, 4.0).len(), 200);
    }
}
