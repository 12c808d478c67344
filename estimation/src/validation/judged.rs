//! A candidate on every split, and what chance would do in its place.

use std::collections::BTreeMap;

use crate::error_metrics::left_out::LeftOut;
use crate::error_metrics::r2;
use crate::recipe::{Recipe, SplitKind};
use crate::rows::LabelledRows;
use crate::validation::candidate::Candidate;
use crate::validation::split_set::Splits;
use crate::validation::tested_rows::{SplitFigures, Tested};

/// A candidate on all splits.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// Candidate that was judged.
    pub candidate: Candidate,
    /// The candidates that are learnt for it: itself, or those whose median a blend is.
    pub members: Vec<Candidate>,
    /// Outcome on each split, or why there is none.
    pub splits: BTreeMap<SplitKind, Result<Outcome, String>>,
}

/// Outcome of a candidate on a split.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Errors of the candidate.
    pub figures: SplitFigures,
    /// Predictions of the tested rows.
    pub tested: Tested,
}

impl Judged {
    /// Figures on a split.
    pub fn on(&self, split: SplitKind) -> Option<&SplitFigures> {
        Some(&self.outcome(split)?.figures)
    }

    /// RMSE that chooses, N: infinite where the split wasn't made.
    pub fn choosing_rmse(&self, split: SplitKind) -> f64 {
        self.on(split)
            .map_or(f64::INFINITY, |figures| figures.choosing().rmse)
    }

    /// Returns what it said of rows that it hadn't learnt from; nothing where the split wasn't made.
    pub fn left_out(&self, split: SplitKind) -> &[LeftOut] {
        self.outcome(split)
            .map_or(&[], |outcome| &outcome.tested.left_out)
    }

    fn outcome(&self, split: SplitKind) -> Option<&Outcome> {
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
    let made = splits
        .folds
        .iter()
        .filter(|(kind, _)| all || **kind == splits.by);
    let outcomes = made.map(|(kind, folds)| {
        let tested = folds.as_ref().map_err(String::clone).and_then(|folds| {
            Tested::of(candidate, rows, folds, recipe, *kind).map_err(|error| error.to_string())
        });
        let outcome = tested.map(|tested| Outcome {
            figures: tested.figures(rows, *kind, recipe.models.seed),
            tested,
        });
        (*kind, outcome)
    });
    let judged = Judged {
        candidate,
        members: vec![candidate],
        splits: outcomes.collect(),
    };
    match judged.splits.get(&splits.by) {
        Some(Ok(_)) => Ok(judged),
        Some(Err(reason)) => Err(reason.clone()),
        None => Err("the split that chooses wasn't made".to_owned()),
    }
}

/// Judges a candidate on the split that chooses where each run's forces are rolled against its signals by half its length; none where it can't be learnt.
pub fn rolled(
    candidate: Candidate,
    rows: &LabelledRows,
    splits: &Splits,
    recipe: &Recipe,
) -> Option<Tested> {
    let mut rolled = rows.clone();
    let mut begin = 0;
    for end in 1..=rows.places.len() {
        if end == rows.places.len() || rows.places[end].run != rows.places[begin].run {
            rolled.forces[begin..end].rotate_left((end - begin) / 2);
            begin = end;
        }
    }
    let folds = splits.folds.get(&splits.by)?.as_ref().ok()?;
    Tested::of(candidate, &rolled, folds, recipe, splits.by).ok()
}

/// R2 of what members said together of rolled forces: what chance would do.
pub fn rolled_r2(members: &[Tested]) -> Option<f64> {
    let members: Vec<&Tested> = members.iter().collect();
    let (truth, estimate) = Tested::together(&members)?.truths_and_estimates();
    r2(&truth, &estimate)
}
