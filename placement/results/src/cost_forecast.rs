//! Forecast of what a study takes.

use serde::{Deserialize, Serialize};

/// Estimate of what a study will cost, and be worth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Estimate {
    /// Equilibria to solve.
    pub solves: SolveForecast,
    /// Wall-clock time; null where `reason` says why.
    pub wall_s: Option<Forecast>,
    /// Largest resident memory of the process, bytes.
    pub peak_memory_bytes: u64,
    /// Room that its points and result take in the database, bytes; 0 in results of earlier versions.
    #[serde(default)]
    pub database_bytes: u64,
    /// Accuracy that the answer is expected to have.
    pub accuracy: ExpectedAccuracy,
    /// Solves at once.
    pub threads: usize,
    /// Solves of this database by which the times were corrected for this machine; 0: the times are those of another machine.
    pub measured_solves: usize,
    /// Reasons why figures are ranges or null, whole sentences.
    pub reasons: Vec<String>,
    /// Values that the physics makes unlikely, each with what may have been meant.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub unlikely: Vec<String>,
}

/// Equilibria that are expected to be solved.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SolveForecast {
    /// Points on the meshes of the answer and of the rungs before it.
    pub own: usize,
    /// Points solved once more on coarser meshes, for the error of the mesh.
    pub coarser: usize,
    /// Solves that show what the model leaves out.
    pub effects: usize,
    /// Solves of films' signals, on both meshes.
    pub signals: usize,
    /// Solves of layouts' loads, on both meshes.
    pub layouts: usize,
    /// Solves of a rig's table of responses.
    pub tables: usize,
    /// Solves among these that the database has already: they cost nothing.
    pub known: usize,
    /// Solves that are left.
    pub left: CountForecast,
}

/// A number of solves with its range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct CountForecast {
    /// Least count.
    pub least: usize,
    /// Likeliest count, as far as can be told.
    pub expected: usize,
    /// Greatest count.
    pub most: usize,
}

/// A figure with its range.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Forecast {
    /// Least value.
    pub least: f64,
    /// Likeliest value, as far as can be told.
    pub expected: f64,
    /// Greatest value.
    pub most: f64,
}

/// Accuracy that studies of this kind had where that was measured: the largest error of the ten indices that the paper's study ranks by, absolute.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ExpectedAccuracy {
    /// Mesh and method of the answer, in a few words.
    pub fidelity: String,
    /// Difference from the finest reference.
    pub error_true: Option<f64>,
    /// Error that the answer claimed itself.
    pub error_claimed: Option<f64>,
    /// Reason why there are no figures.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}
