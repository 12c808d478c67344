//! Every model with every feature set on every split: what is learnt is never tested.
//!
//! Scale, outliers, hyperparameters and penalties are learnt from a fold's training rows alone. One [`Candidate`] of one force is one piece of work, which depends on
//! nothing but its arguments, so that whoever has cores can share the pieces out.

use std::collections::{BTreeMap, BTreeSet};

use ndarray::{Array2, Axis};

use crate::error_metrics::{nrmse_percent, r2, rmse, rmse_interval};
use crate::features::{GROUPS, columns};
use crate::interval::{Fared, LeftOut, fared};
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
    /// On later rows: what stands in for another run where there is one.
    pub later: Vec<LeftOut>,
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
        later: Vec::new(),
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
                    let figures = tested.figures(rows, recipe.models.seed);
                    match *kind {
                        kind if kind == splits.by => judged.left_out = tested.left_out,
                        SplitKind::Time => judged.later = tested.left_out,
                        _ => {}
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
    for fold in folds {
        let learner = Learner::learn(candidate, rows, &fold.train, recipe, Effort::Fold)?;
        let mean =
            fold.train.iter().map(|row| rows.forces[*row]).sum::<f64>() / fold.train.len() as f64;
        let test = even_subset(fold.test.len(), MOST_TESTED / folds.len());
        for row in test.into_iter().map(|place| &fold.test[place]) {
            let Prediction {
                mean: estimate,
                deviation,
            } = learner.predict(&rows.features.row(*row).to_vec());
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

impl Tested {
    fn figures(&self, rows: &LabelledRows, seed: u64) -> SplitFigures {
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
            intervals: fared(&self.left_out),
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
