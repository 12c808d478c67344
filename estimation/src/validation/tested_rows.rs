//! Rows that weren't learnt from: what was said of them, and how far off it was.

use crate::error_metrics::interval::{Fared, factor_by, fared};
use crate::error_metrics::left_out::LeftOut;
use crate::error_metrics::run_spread::rmse_range;
use crate::error_metrics::{nrmse_percent, r2, rmse, rmse_interval};
use crate::model::contract::{Effort, FitError, Prediction};
use crate::model::even_subset::even_subset;
use crate::recipe::{Recipe, SplitKind};
use crate::rows::LabelledRows;
use crate::split::{Fold, strictest};
use crate::validation::another_session::Session;
use crate::validation::candidate::Candidate;
use crate::validation::learnt_model::LearntModel;

/// Most rows that a split tests, evenly taken: neighbours tell nothing new of an error.
pub const MOST_TESTED: usize = 10_000;

/// Figures of a candidate on one split.
#[derive(Debug, Clone, PartialEq)]
pub struct SplitFigures {
    /// N
    pub rmse: f64,
    /// Range of a new run's RMSE, N; of other splits 95 % of the bootstrap's samples of cycles.
    pub rmse_interval: Option<(f64, f64)>,
    /// RMSE over the range of the tested forces, %.
    pub nrmse_percent: Option<f64>,
    /// NRMSE of the training mean, %.
    pub mean_nrmse_percent: Option<f64>,
    /// RMSE of the training mean, N.
    pub mean_rmse: f64,
    /// Errors of the tested rows that aren't suspect; none where none is.
    pub sound: Option<SoundErrors>,
    /// Coefficient of determination.
    pub r2: Option<f64>,
    /// Intervals whose factor was learnt from other groups.
    pub intervals: Option<Fared>,
}

/// Errors of the tested rows that aren't suspect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoundErrors {
    /// RMSE of the model, N.
    pub rmse: f64,
    /// RMSE of the training mean, N.
    pub mean_rmse: f64,
}

impl SplitFigures {
    /// Errors that choose: those of sound rows. Of a wrong reference, or a lone wrong reading, each model is as far off as it likes.
    pub fn choosing(&self) -> SoundErrors {
        let all = SoundErrors {
            rmse: self.rmse,
            mean_rmse: self.mean_rmse,
        };
        self.sound.unwrap_or(all)
    }
}

/// Predictions of all tested rows: the same rows in the same order, whoever makes them.
#[derive(Debug, Clone, PartialEq)]
pub struct Tested {
    /// Predictions, row by row.
    pub left_out: Vec<LeftOut>,
    /// The training mean of each tested row's fold, N.
    pub means: Vec<f64>,
}

impl Tested {
    /// Learns from each fold and says what it thinks of the rest of its rows.
    ///
    /// # Errors
    /// When the model can't be learnt.
    pub fn of(
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
            let model = LearntModel::learn(candidate, rows, &fold.train, recipe, Effort::Fold)?;
            let mean = mean_force(rows, &fold.train);
            let test = even_subset(fold.test.len(), MOST_TESTED / folds.len());
            for row in test.into_iter().map(|place| &fold.test[place]) {
                let mut features = rows.features.row(*row).to_vec();
                if let Some(session) = &session {
                    session.disturb(*row, &mut features);
                }
                let Prediction {
                    mean: estimate,
                    deviation,
                } = model.predict(&features);
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
                    is_suspect: rows.suspect[*row].is_suspect(),
                });
                tested.means.push(mean);
            }
        }
        Ok(tested)
    }

    /// Joins what several say; none of none.
    pub fn together(members: &[&Self]) -> Option<Self> {
        let mut found = (*members.first()?).clone();
        for (place, row) in found.left_out.iter_mut().enumerate() {
            let of_member = |member: &&Self| {
                let LeftOut {
                    mean, deviation, ..
                } = member.left_out[place];
                Prediction { mean, deviation }
            };
            let said: Vec<Prediction> = members.iter().map(of_member).collect();
            Prediction {
                mean: row.mean,
                deviation: row.deviation,
            } = Prediction::together(&said);
        }
        Some(found)
    }

    /// Measured and estimated forces, N.
    pub(crate) fn truths_and_estimates(&self) -> (Vec<f64>, Vec<f64>) {
        self.left_out
            .iter()
            .map(|row| (row.truth, row.mean))
            .unzip()
    }

    /// Errors and intervals.
    pub fn figures(&self, rows: &LabelledRows, kind: SplitKind, seed: u64) -> SplitFigures {
        let (truth, estimate) = self.truths_and_estimates();
        let cycles: Vec<usize> = self
            .left_out
            .iter()
            .map(|row| rows.places[row.row].cycle)
            .collect();
        let error = rmse(&truth, &estimate);
        let mean_rmse = rmse(&truth, &self.means);
        SplitFigures {
            rmse: error,
            rmse_interval: rmse_range(&self.left_out)
                .filter(|_| kind == SplitKind::Run)
                .or_else(|| rmse_interval(&truth, &estimate, &cycles, seed)),
            nrmse_percent: nrmse_percent(&truth, error),
            mean_nrmse_percent: nrmse_percent(&truth, mean_rmse),
            mean_rmse,
            sound: self.sound_errors(),
            r2: r2(&truth, &estimate),
            intervals: fared(&self.left_out, |rows| factor_by(kind, rows)),
        }
    }

    fn sound_errors(&self) -> Option<SoundErrors> {
        let pairs = self.left_out.iter().zip(&self.means);
        let sound: Vec<(f64, f64, f64)> = pairs
            .filter(|(row, _)| !row.is_suspect)
            .map(|(row, mean)| (row.truth, row.mean, *mean))
            .collect();
        if sound.is_empty() || sound.len() == self.left_out.len() {
            return None;
        }
        let of = |number: fn(&(f64, f64, f64)) -> f64| -> Vec<f64> {
            sound.iter().map(number).collect()
        };
        let truth = of(|row| row.0);
        Some(SoundErrors {
            rmse: rmse(&truth, &of(|row| row.1)),
            mean_rmse: rmse(&truth, &of(|row| row.2)),
        })
    }
}

/// Mean of the forces that are learnt from, N, suspect ones apart: what every model has to beat.
fn mean_force(rows: &LabelledRows, train: &[usize]) -> f64 {
    let mean = |meant: &[usize]| {
        let sum: f64 = meant.iter().map(|row| rows.forces[*row]).sum();
        sum / meant.len() as f64
    };
    let is_sound = |row: &usize| !rows.suspect[*row].force;
    let sound: Vec<usize> = train.iter().copied().filter(is_sound).collect();
    mean(if sound.is_empty() { train } else { &sound })
}
