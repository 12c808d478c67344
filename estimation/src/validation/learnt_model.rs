//! A model with what it is given.

use ndarray::{Array2, Axis};
use serde::{Deserialize, Serialize};

use crate::features::{GROUPS, columns};
use crate::model::contract::{Effort, FitError, Prediction, Training};
use crate::model::feature_scale::FeatureScale;
use crate::model::fitted::{Fitted, fit};
use crate::recipe::{FeatureSet, Kind, Recipe, Scale};
use crate::rows::LabelledRows;
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
        let train = match recipe.preprocess.outlier_z {
            Some(most) => without_outliers(&rows.features, train, signals, most),
            None => train.to_vec(),
        };
        let columns: Vec<usize> = read_columns(candidate, signals).collect();
        let features = rows
            .features
            .select(Axis(0), &train)
            .select(Axis(1), &columns);
        let scale = FeatureScale::learn(recipe.preprocess.scale, &features.view());
        let features = scale.scaled_rows(&features.view());
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
