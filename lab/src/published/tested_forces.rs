//! A model of one force that learns from a recording, and how far off it is on readings that it didn't learn from.

use estimation::error_metrics::{nrmse_percent, r2, rmse};
use estimation::model::contract::Effort;
use estimation::recipe::Recipe;
use estimation::rows::LabelledRows;
use estimation::split::Fold;
use estimation::validation::{Candidate, LearntModel};

/// Figures of a virtual rig.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigFigures {
    /// Root of the mean squared error, N.
    pub rmse_n: f64,
    /// RMSE over the range of the tested forces, %.
    pub nrmse_percent: Option<f64>,
    /// NRMSE that the mean of the learnt forces would have reached, %.
    pub mean_nrmse_percent: Option<f64>,
    /// Coefficient of determination.
    pub r2: Option<f64>,
}

/// A model of one force that is to be learnt from a recording.
pub struct Model<'r> {
    /// Model and features.
    pub candidate: Candidate,
    /// Recipe by which it is learnt.
    pub recipe: &'r Recipe,
    /// The recording.
    pub rows: LabelledRows,
}

/// A model that was learnt, beside the mean of the forces it learnt from.
pub struct Learnt {
    learner: LearntModel,
    mean_n: f64,
}

impl Model<'_> {
    /// Learns from some rows of the recording.
    ///
    /// # Errors
    /// Why it isn't learnt.
    pub fn learn(&self, train: &[usize]) -> Result<Learnt, String> {
        if train.is_empty() {
            return Err("nothing touched in its recording".to_owned());
        }
        let learner = LearntModel::learn(
            self.candidate,
            &self.rows,
            train,
            self.recipe,
            Effort::Whole,
        );
        let sum: f64 = train.iter().map(|row| self.rows.forces[*row]).sum();
        Ok(Learnt {
            learner: learner.map_err(|error| error.to_string())?,
            mean_n: sum / train.len() as f64,
        })
    }

    /// Returns its figures on what each fold leaves out.
    ///
    /// # Errors
    /// Why it isn't learnt.
    pub(crate) fn on_folds(&self, folds: &[Fold]) -> Result<Option<RigFigures>, String> {
        let mut all = TestedRows::default();
        for fold in folds {
            let learnt = self.learn(&fold.train)?;
            all.add(&learnt, &self.rows, fold.test.iter().copied());
        }
        Ok(all.figures())
    }
}

impl Learnt {
    /// Returns its figures on some rows; none without rows.
    pub fn on(
        &self,
        rows: &LabelledRows,
        tested: impl Iterator<Item = usize>,
    ) -> Option<RigFigures> {
        let mut all = TestedRows::default();
        all.add(self, rows, tested);
        all.figures()
    }
}

/// Forces that were measured, with what was said of them.
#[derive(Default)]
struct TestedRows {
    truth: Vec<f64>,
    estimate: Vec<f64>,
    mean: Vec<f64>,
}

impl TestedRows {
    fn add(&mut self, learnt: &Learnt, rows: &LabelledRows, tested: impl Iterator<Item = usize>) {
        for row in tested {
            let features = rows.features.row(row).to_vec();
            self.truth.push(rows.forces[row]);
            self.estimate.push(learnt.learner.predict(&features).mean);
            self.mean.push(learnt.mean_n);
        }
    }

    fn figures(&self) -> Option<RigFigures> {
        let percent = |rmse| nrmse_percent(&self.truth, rmse).filter(|x| x.is_finite());
        let rmse_n = rmse(&self.truth, &self.estimate);
        rmse_n.is_finite().then(|| RigFigures {
            rmse_n,
            nrmse_percent: percent(rmse_n),
            mean_nrmse_percent: percent(rmse(&self.truth, &self.mean)),
            r2: r2(&self.truth, &self.estimate).filter(|x| x.is_finite()),
        })
    }
}
