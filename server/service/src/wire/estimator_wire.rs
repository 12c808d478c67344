//! The documents of estimators: what is learnt from recordings, and what was found.

use estimation::fit_report::RecordingFigures;
use results::Forecast;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use store::StoreError;
use store::queue::estimator_rows::EstimatorRow;
use store::queue::study_rows::State;
use utoipa::ToSchema;

/// Recordings to learn forces from, and how.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct EstimatorDocument {
    /// Free text; the first recording's file where it is left out.
    #[schema(nullable = false, min_length = 1, max_length = 200)]
    pub name: Option<String>,
    /// Recipe, as in `strainsite force fit`: the tables `columns`, `preprocess`, `features`, `models` and `validation`, every field with a default.
    #[schema(value_type = RecipeDocument, nullable = false, required = false)]
    pub recipe: Option<Value>,
    /// Recordings, one a run.
    #[schema(min_items = 1, max_items = 1000)]
    pub recordings: Vec<RecordingDocument>,
}

/// A recipe: its schema is that of the document.
#[derive(Debug, ToSchema)]
pub(crate) struct RecipeDocument;

/// A recording as text.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordingDocument {
    /// Name that faults, reports and plots give it.
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
    /// State of the estimator.
    pub state: State,
    /// Reason why it failed, a sentence.
    pub error: Option<String>,
    /// Time at which it was submitted.
    pub created: String,
    /// Time at which it was first started.
    pub started: Option<String>,
    /// Time at which it ended.
    pub finished: Option<String>,
    /// The forces' columns, N.
    pub forces: Vec<String>,
    /// Recordings that it is learnt from.
    pub recordings: Vec<RecordingFigures>,
    /// Progress while it runs; null otherwise.
    pub progress: Option<FitProgress>,
    /// Estimate of what learning takes, once it has its turn; null for estimators of earlier versions.
    pub estimate: Option<FitEstimate>,
}

/// Estimate of what a fit takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct FitEstimate {
    /// Wall-clock time, s: by the sizes of the recordings, on another machine.
    pub wall_s: Forecast,
    /// Bound of the memory, bytes.
    pub peak_memory_bytes: u64,
    /// Threads that it has.
    pub threads: usize,
}

/// Progress of a fit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct FitProgress {
    /// Stage of the fit.
    pub stage: FitStage,
    /// Pieces of work of this stage that are done.
    pub done: usize,
    /// Pieces of work of this stage; 0 until that is known.
    pub of: usize,
}

/// Stage of a fit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FitStage {
    /// Recordings are read.
    #[default]
    Reading,
    /// Whether first readings are taken off is tried.
    StartValue,
    /// Models are judged on rows that they didn't learn from.
    Judging,
    /// The chosen models are learnt from all rows.
    Learning,
}

/// An estimator with its recipe.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EstimatorDetail {
    /// Summary of the estimator.
    #[serde(flatten)]
    pub summary: EstimatorSummary,
    /// The recipe as it was submitted.
    #[schema(value_type = Object)]
    pub recipe: Value,
    /// Zero that it was given; null where recordings begin as they did when it was learnt.
    pub zero: Option<EstimatorZero>,
}

/// Zero that an estimator was given: what its signals are without a force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct EstimatorZero {
    /// Recording without load that it is from.
    pub file: String,
    /// Time at which it was given.
    pub set: String,
    /// Signals' columns.
    pub signals: Vec<String>,
    /// Each signal's median over the recording's rows without a force, in its own unit.
    pub zero: Vec<f64>,
}

/// Recording without load, or nothing, which forgets an earlier zero.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct ZeroDocument {
    /// Name that faults give it.
    #[schema(min_length = 1, max_length = 200)]
    pub file: Option<String>,
    /// CSV: a header, then a row a line: seconds and signals; where it has forces, its rows without one count.
    pub text: Option<String>,
}

/// A page of estimators, newest first.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
pub struct EstimatorPage {
    /// The estimators.
    pub estimators: Vec<EstimatorSummary>,
    /// Cursor of the next page; null on the last one.
    pub next_cursor: Option<String>,
}

/// Rows that weren't learnt from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct LeftOutForces {
    /// Rows that were left out, one list a force.
    pub forces: Vec<LeftOutRows>,
}

/// Submission as it is stored, beside its recordings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct StoredEstimator {
    /// The recipe as it was submitted.
    pub recipe: Value,
    /// The forces' columns.
    pub forces: Vec<String>,
    /// Recordings that it is learnt from.
    pub recordings: Vec<RecordingFigures>,
    /// Count of the signals; 0 where an earlier version didn't say.
    #[serde(default)]
    pub signals: usize,
}

impl StoredEstimator {
    /// Reads what a row of the database says.
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
    /// Reads what a row of the database says, and adds how far its fit is and what it takes.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when its document doesn't match its hash.
    pub(crate) fn of(
        row: &EstimatorRow,
        progress: Option<FitProgress>,
        estimate: &dyn Fn(&StoredEstimator) -> Option<FitEstimate>,
    ) -> Result<Self, StoreError> {
        let stored = StoredEstimator::of(row)?;
        let estimate = estimate(&stored);
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
            estimate,
        };
        Ok(Self {
            summary,
            recipe: stored.recipe,
            zero: None,
        })
    }
}

/// Rows that the chosen model of a force hadn't learnt from: truth, estimate and interval.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct LeftOutRows {
    /// The force's column.
    pub force: String,
    /// Each row's run, by its place among the recordings.
    pub run: Vec<usize>,
    /// Each row's time, s.
    pub time_s: Vec<f64>,
    /// Measured force, N.
    pub truth_n: Vec<f64>,
    /// Estimated force, N.
    pub estimate_n: Vec<f64>,
    /// The interval's low end, N.
    pub low_n: Vec<f64>,
    /// The interval's high end, N.
    pub high_n: Vec<f64>,
}
