//! The documents of estimators: what is learnt from recordings, and what was found.

use estimation::fit_report::RecordingFigures;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use store::StoreError;
use store::queue::estimator_rows::EstimatorRow;
use store::queue::study_rows::State;
use utoipa::ToSchema;

use crate::forces::fitting::LeftOutRows;

/// Recordings to learn forces from, and how.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct EstimatorDocument {
    /// Free text; the first recording's file where it is left out.
    #[schema(nullable = false, min_length = 1, max_length = 200)]
    pub name: Option<String>,
    /// What is to be done, as in a recipe of `strainsite force fit`: the tables `columns`, `preprocess`, `features`, `models` and `validation`, every field with a
    /// default.
    #[schema(value_type = Object, nullable = false, required = false)]
    pub recipe: Option<Value>,
    /// One a run.
    #[schema(min_items = 1, max_items = 1000)]
    pub recordings: Vec<RecordingDocument>,
}

/// A recording as text.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordingDocument {
    /// What faults, reports and plots call it.
    #[schema(min_length = 1, max_length = 200)]
    pub file: String,
    /// CSV: a header, then a row a line: seconds, signals, and forces where they were measured.
    pub text: String,
}

/// An estimator in its queue, at work, or at its end. Times are RFC 3339, UTC.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EstimatorSummary {
    /// UUID, ordered by time.
    pub id: String,
    /// Free text.
    pub name: String,
    /// Where it stands.
    pub state: State,
    /// Why it failed, a sentence.
    pub error: Option<String>,
    /// When it was submitted.
    pub created: String,
    /// When it was first started.
    pub started: Option<String>,
    /// When it ended.
    pub finished: Option<String>,
    /// The forces' columns, N.
    pub forces: Vec<String>,
    /// What it is learnt from.
    pub recordings: Vec<RecordingFigures>,
    /// How far it is while it runs; null otherwise.
    pub progress: Option<FitProgress>,
}

/// How far a fit is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct FitProgress {
    /// Models judged.
    pub done: usize,
    /// Of how many; 0 until that is known.
    pub of: usize,
}

/// An estimator with its recipe.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EstimatorDetail {
    /// Where it stands.
    #[serde(flatten)]
    pub summary: EstimatorSummary,
    /// The recipe as it was submitted.
    #[schema(value_type = Object)]
    pub recipe: Value,
}

/// One page of estimators, newest first.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EstimatorPage {
    /// The estimators.
    pub estimators: Vec<EstimatorSummary>,
    /// Where the next page begins; null on the last one.
    pub next_cursor: Option<String>,
}

/// Rows that weren't learnt from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct LeftOutForces {
    /// One list a force.
    pub forces: Vec<LeftOutRows>,
}

/// What is stored of a submission beside its recordings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StoredEstimator {
    /// The recipe as it was submitted.
    pub recipe: Value,
    /// The forces' columns.
    pub forces: Vec<String>,
    /// What it is learnt from.
    pub recordings: Vec<RecordingFigures>,
}

impl StoredEstimator {
    /// What a row of the database says.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when it can't be read.
    pub fn of(row: &EstimatorRow) -> Result<Self, StoreError> {
        serde_json::from_str(row.document()?).map_err(|_| StoreError::Damaged {
            table: "estimators",
            row: row.id.clone(),
        })
    }
}

impl EstimatorDetail {
    /// What a row of the database says, and how far its fit is.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when its document doesn't match its hash.
    pub fn of(row: &EstimatorRow, progress: Option<FitProgress>) -> Result<Self, StoreError> {
        let stored = StoredEstimator::of(row)?;
        let state = row.state();
        let summary = EstimatorSummary {
            id: row.id.clone(),
            name: row.name.clone(),
            state,
            error: row.error.clone(),
            created: row.created.clone(),
            started: row.started.clone(),
            finished: row.finished.clone(),
            forces: stored.forces,
            recordings: stored.recordings,
            progress: progress.filter(|_| state == State::Running),
        };
        Ok(Self {
            summary,
            recipe: stored.recipe,
        })
    }
}
