//! The splits of a force's rows, and which of them chooses.

use std::collections::{BTreeMap, BTreeSet};

use crate::recipe::{FeatureSet, Recipe, SplitKind};
use crate::rows::LabelledRows;
use crate::split::{Fold, Gap, folds, strictest};

/// Time constants between what is learnt and what is tested by time: after three of them 5 % are left.
const TIME_CONSTANTS: f64 = 3.0;
/// A gap takes at most this part of a typical cycle from what is learnt: of short cycles nothing would be left.
const GAP_SHARE: usize = 4;

/// Rows of a typical cycle.
fn cycle_rows(rows: &LabelledRows) -> usize {
    let cycles: BTreeSet<usize> = rows.places.iter().map(|place| place.cycle).collect();
    rows.places.len() / cycles.len().max(1)
}

/// Rows that features of a row are made of, itself among them.
fn rows_looked_back(recipe: &Recipe, interval_s: f64) -> usize {
    let features = &recipe.features;
    let windowed = features.sets.iter().any(|set| *set != FeatureSet::Raw);
    let window = if windowed { features.window_rows } else { 1 };
    let baseline = features.baseline_s().unwrap_or(0.0) / interval_s;
    let rows = window.max(1 + baseline.ceil() as usize);
    rows.max(recipe.preprocess.smooth_rows)
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
        let window = rows_looked_back(recipe, interval_s);
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

    /// The folds that leave runs out; none of a single run.
    pub fn of_runs(&self) -> &[Fold] {
        let folds = self.folds.get(&SplitKind::Run);
        folds
            .and_then(|folds| folds.as_ref().ok())
            .map_or(&[], Vec::as_slice)
    }
}
