//! Every model with every feature set on every split: what is learnt is never tested.
//!
//! Scale, outliers, hyperparameters and penalties are learnt from a fold's training rows alone. One [`Candidate`] of one force is one piece of work, which depends on
//! nothing but its arguments, so that whoever has cores can share the pieces out.

use std::collections::{BTreeMap, BTreeSet};

use ndarray::{Array2, ArrayView1, Axis};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::error_metrics::{nrmse_percent, r2, rmse, rmse_interval};
use crate::features::{GROUPS, MEANS, VALUES, columns};
use crate::interval::{Fared, LeftOut, factor_by, fared};
use crate::model::contract::{Effort, FitError, Prediction, Training};
use crate::model::even_subset::even_subset;
use crate::model::feature_scale::FeatureScale;
use crate::model::fitted::{Fitted, fit};
use crate::recipe::{FeatureSet, Kind, Recipe, Scale, SplitKind};
use crate::rows::LabelledRows;
use crate::split::{Fold, Gap, folds, strictest};

/// Time constants between what is learnt and what is tested by time: after three of them 5 % are left.
const TIME_CONSTANTS: f64 = 3.0;

/// Most rows that a split tests, evenly taken: neighbours tell nothing new of an error.
const MOST_TESTED: usize = 10_000;
/// Where one run was recorded, signals of left-out rows are moved by offsets with this standard deviation, as a share of their ranges: another session's
/// instruments read so far off at the best of times, and a force that hangs on small differences of large signals must show it.
pub const ANOTHER_SESSION: f64 = 0.005;
/// A gap takes at most this part of a typical cycle from what is learnt: of short cycles nothing would be left.
const GAP_SHARE: usize = 4;

/// Rows of a typical cycle.
fn cycle_rows(rows: &LabelledRows) -> usize {
    let cycles: BTreeSet<usize> = rows.places.iter().map(|place| place.cycle).collect();
    rows.places.len() / cycles.len().max(1)
}

/// A model with a feature set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Candidate {
    /// The model.
    pub kind: Kind,
    /// What it is given.
    pub features: FeatureSet,
}

/// All candidates of a recipe, the training mean first.
pub fn candidates(recipe: &Recipe) -> Vec<Candidate> {
    let mean = Candidate {
        kind: Kind::Mean,
        features: FeatureSet::Raw,
    };
    let kinds = recipe
        .models
        .kinds
        .iter()
        .filter(|kind| **kind != Kind::Mean);
    let with_sets = kinds.flat_map(|kind| {
        recipe.features.sets.iter().map(|features| Candidate {
            kind: *kind,
            features: *features,
        })
    });
    std::iter::once(mean).chain(with_sets).collect()
}

/// The splits of a force's rows.
#[derive(Debug, Clone)]
pub struct Splits {
    /// The one that chooses.
    pub by: SplitKind,
    /// The folds of each, or why there are none.
    pub folds: BTreeMap<SplitKind, Result<Vec<Fold>, String>>,
}

impl Splits {
    /// All splits of these rows; `interval_s` is the time between two.
    pub fn new(rows: &LabelledRows, recipe: &Recipe, interval_s: f64) -> Self {
        let windowed = recipe
            .features
            .sets
            .iter()
            .any(|set| *set != FeatureSet::Raw);
        let window = if windowed {
            recipe.features.window_rows
        } else {
            1
        };
        let window = window.max(recipe.preprocess.smooth_rows);
        let gap = Gap {
            rows: (window - 1).min(cycle_rows(rows) / GAP_SHARE),
            time_s: window as f64 * interval_s + TIME_CONSTANTS * recipe.validation.time_constant_s,
        };
        let of = |kind: SplitKind| (kind, folds(kind, &rows.places, gap, recipe.models.seed));
        Self {
            by: recipe
                .validation
                .by
                .unwrap_or_else(|| strictest(&rows.places)),
            folds: SplitKind::ALL.map(of).into(),
        }
    }
}

/// How a candidate fared on one split.
#[derive(Debug, Clone, PartialEq)]
pub struct SplitFigures {
    /// N
    pub rmse: f64,
    /// 95 % of the bootstrap's samples of cycles, N.
    pub rmse_interval: Option<(f64, f64)>,
    /// RMSE over the range of the tested forces, %.
    pub nrmse_percent: Option<f64>,
    /// The same of the training mean.
    pub mean_nrmse_percent: Option<f64>,
    /// RMSE of the training mean, N.
    pub mean_rmse: f64,
    /// Coefficient of determination.
    pub r2: Option<f64>,
    /// Intervals whose factor was learnt from other groups.
    pub intervals: Option<Fared>,
}

/// A candidate on all splits.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// Which.
    pub candidate: Candidate,
    /// How it fared, or why it couldn't.
    pub splits: BTreeMap<SplitKind, Result<SplitFigures, String>>,
    /// What it said of rows that it hadn't learnt from, on the split that chooses.
    pub left_out: Vec<LeftOut>,
}

impl Judged {
    /// Figures on a split.
    pub fn on(&self, split: SplitKind) -> Option<&SplitFigures> {
        self.splits.get(&split)?.as_ref().ok()
    }
}

/// Judges a candidate on all splits, or on the one that chooses alone.
///
/// # Errors
/// When the model can't be learnt on the split that chooses.
pub fn judge(
    candidate: Candidate,
    rows: &LabelledRows,
    splits: &Splits,
    recipe: &Recipe,
    all: bool,
) -> Result<Judged, String> {
    let mut judged = Judged {
        candidate,
        splits: BTreeMap::new(),
        left_out: Vec::new(),
    };
    for (kind, folds) in &splits.folds {
        if !all && *kind != splits.by {
            continue;
        }
        let figures = match folds {
            Ok(folds) => {
                let tested = tested(candidate, rows, folds, recipe, *kind)
                    .map_err(|error| error.to_string());
                tested.map(|tested| {
                    let figures = tested.figures(rows, *kind, recipe.models.seed);
                    if *kind == splits.by {
                        judged.left_out = tested.left_out;
                    }
                    figures
                })
            }
            Err(reason) => Err(reason.clone()),
        };
        judged.splits.insert(*kind, figures);
    }
    match judged.splits.get(&splits.by) {
        Some(Ok(_)) => Ok(judged),
        Some(Err(reason)) => Err(reason.clone()),
        None => Err("the split that chooses wasn't made".to_owned()),
    }
}

/// R2 on the split that chooses where each run's forces are rolled against its signals by half its length: what chance would do.
pub fn rolled_r2(
    candidate: Candidate,
    rows: &LabelledRows,
    splits: &Splits,
    recipe: &Recipe,
) -> Option<f64> {
    let mut rolled = rows.clone();
    let mut begin = 0;
    for end in 1..=rows.places.len() {
        if end == rows.places.len() || rows.places[end].run != rows.places[begin].run {
            rolled.forces[begin..end].rotate_left((end - begin) / 2);
            begin = end;
        }
    }
    let folds = splits.folds.get(&splits.by)?.as_ref().ok()?;
    let tested = tested(candidate, &rolled, folds, recipe, splits.by).ok()?;
    let (truth, estimate): (Vec<f64>, Vec<f64>) = tested
        .left_out
        .iter()
        .map(|row| (row.truth, row.mean))
        .unzip();
    r2(&truth, &estimate)
}

/// What was said of all tested rows.
struct Tested {
    left_out: Vec<LeftOut>,
    /// The training mean of each tested row's fold, N.
    means: Vec<f64>,
}

fn tested(
    candidate: Candidate,
    rows: &LabelledRows,
    folds: &[Fold],
    recipe: &Recipe,
    kind: SplitKind,
) -> Result<Tested, FitError> {
    let mut tested = Tested {
        left_out: Vec::new(),
        means: Vec::new(),
    };
    let session = (kind == SplitKind::Cycle && strictest(&rows.places) == SplitKind::Cycle)
        .then(|| Session::new(rows, recipe.models.seed));
    for fold in folds {
        let learner = Learner::learn(candidate, rows, &fold.train, recipe, Effort::Fold)?;
        let mean =
            fold.train.iter().map(|row| rows.forces[*row]).sum::<f64>() / fold.train.len() as f64;
        let test = even_subset(fold.test.len(), MOST_TESTED / folds.len());
        for row in test.into_iter().map(|place| &fold.test[place]) {
            let mut features = rows.features.row(*row).to_vec();
            if let Some(session) = &session {
                session.disturb(*row, &mut features);
            }
            let Prediction {
                mean: estimate,
                deviation,
            } = learner.predict(&features);
            let place = &rows.places[*row];
            tested.left_out.push(LeftOut {
                row: *row,
                group: if kind == SplitKind::Run {
                    place.run
                } else {
                    place.cycle
                },
                truth: rows.forces[*row],
                mean: estimate,
                deviation,
            });
            tested.means.push(mean);
        }
    }
    Ok(tested)
}

/// What another session's instruments may add to signals.
struct Session {
    /// Of each signal.
    ranges: Vec<f64>,
    seed: u64,
}

impl Session {
    fn new(rows: &LabelledRows, seed: u64) -> Self {
        let signals = rows.features.ncols() / GROUPS;
        let range = |column: ArrayView1<'_, f64>| {
            let low = column.iter().copied().fold(f64::INFINITY, f64::min);
            let high = column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            high - low
        };
        let columns = rows.features.columns();
        Self {
            ranges: columns.into_iter().take(signals).map(range).collect(),
            seed,
        }
    }

    /// Moves a row's signals, and with them their rolling means; slopes and variances don't know an offset. Each row meets a session of its own: an error
    /// over all rows is then that over as many sessions.
    fn disturb(&self, row: usize, features: &mut [f64]) {
        let mut generator = ChaCha8Rng::seed_from_u64(self.seed);
        generator.set_stream(row as u64);
        let signals = self.ranges.len();
        for (signal, range) in self.ranges.iter().enumerate() {
            // Drawn evenly from -root 3 to root 3: a variance of 1.
            let drawn = generator.random_range(-3f64.sqrt()..3f64.sqrt());
            for group in [VALUES, MEANS] {
                features[group * signals + signal] += ANOTHER_SESSION * range * drawn;
            }
        }
    }
}

impl Tested {
    fn figures(&self, rows: &LabelledRows, kind: SplitKind, seed: u64) -> SplitFigures {
        let (truth, estimate): (Vec<f64>, Vec<f64>) = self
            .left_out
            .iter()
            .map(|row| (row.truth, row.mean))
            .unzip();
        let cycles: Vec<usize> = self
            .left_out
            .iter()
            .map(|row| rows.places[row.row].cycle)
            .collect();
        let error = rmse(&truth, &estimate);
        let mean_rmse = rmse(&truth, &self.means);
        SplitFigures {
            rmse: error,
            rmse_interval: rmse_interval(&truth, &estimate, &cycles, seed),
            nrmse_percent: nrmse_percent(&truth, error),
            mean_nrmse_percent: nrmse_percent(&truth, mean_rmse),
            mean_rmse,
            r2: r2(&truth, &estimate),
            intervals: fared(&self.left_out, |rows| factor_by(kind, rows)),
        }
    }
}

/// A model with the scale of its features.
#[derive(Debug, Clone)]
pub struct Learner {
    /// Which of all features it reads.
    pub columns: Vec<usize>,
    /// Their scale.
    pub scale: FeatureScale,
    /// The model.
    pub model: Fitted,
}

impl Learner {
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
        let train = match recipe.preprocess.outlier_z {
            Some(most) => without_outliers(&rows.features, train, signals, most),
            None => train.to_vec(),
        };
        let columns = match candidate.kind {
            Kind::Mean => Vec::new(),
            _ => columns(candidate.features, signals),
        };
        let features = rows
            .features
            .select(Axis(0), &train)
            .select(Axis(1), &columns);
        let scale = FeatureScale::learn(recipe.preprocess.scale, &features.view());
        let features = scale.scaled_rows(&features.view());
        let forces: Vec<f64> = train.iter().map(|row| rows.forces[*row]).collect();
        let cycles: Vec<usize> = train.iter().map(|row| rows.places[*row].cycle).collect();
        let training = Training {
            features: features.view(),
            forces: &forces,
            cycles: &cycles,
        };
        Ok(Self {
            columns,
            scale,
            model: fit(candidate.kind, &recipe.models, effort, &training)?,
        })
    }

    /// What the model says of a row of all features.
    pub fn predict(&self, features: &[f64]) -> Prediction {
        self.model.predict(
            &self
                .scale
                .scaled(self.columns.iter().map(|column| features[*column])),
        )
    }
}

/// Rows none of whose signals is further than so many standard deviations from its mean over these rows.
fn without_outliers(
    features: &Array2<f64>,
    train: &[usize],
    signals: usize,
    most: f64,
) -> Vec<usize> {
    let first: Vec<usize> = (0..signals).collect();
    let values = features.select(Axis(0), train).select(Axis(1), &first);
    let scale = FeatureScale::learn(Scale::Standardise, &values.view());
    let kept = |row: &usize| {
        let z = scale.scaled(features.row(*row).iter().take(signals).copied());
        z.iter().all(|z| z.abs() <= most)
    };
    train.iter().copied().filter(kept).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::split::Place;

    #[test]
    fn another_session_moves_values_and_means_alike() {
        // Two signals with ranges of 2 and 400.
        let ends = [[-1.0, 100.0], [1.0, 500.0]];
        let rows = LabelledRows {
            features: Array2::from_shape_fn((2, 2 * GROUPS), |(row, k)| ends[row][k % 2]),
            forces: vec![0.0, 1.0],
            places: vec![
                Place {
                    run: 0,
                    row: 0,
                    cycle: 0,
                    time_s: 0.0
                };
                2
            ],
        };
        let session = Session::new(&rows, 1);
        let moved = |row: usize| {
            let mut features = vec![0.0; 2 * GROUPS];
            session.disturb(row, &mut features);
            features
        };
        let [a, b, ..] = moved(7)[..] else {
            panic!("eight features")
        };
        assert_eq!(moved(7), [a, b, 0.0, 0.0, a, b, 0.0, 0.0]);
        assert_ne!(moved(8)[0], a);
        // Squares of evenly drawn numbers with variance 1 have a variance of 9/5 - 1: the mean of 4000 is known to 0.014, four of which are allowed.
        let square = |(moved, range): (f64, f64)| (moved / (0.005 * range)).powi(2);
        let squares: f64 = (0..2000)
            .map(moved)
            .map(|moved| square((moved[0], 2.0)) + square((moved[1], 400.0)))
            .sum();
        assert!((squares / 4000.0 - 1.0).abs() < 0.057, "{squares}");
    }
}
