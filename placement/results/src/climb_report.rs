//! The way to the accuracy asked for.

use serde::{Deserialize, Serialize};

/// The way from a draft to the accuracy asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Climb {
    /// Largest error of an index that was asked for.
    pub tolerance: Option<f64>,
    /// Wall-clock time that was allowed, s.
    pub budget_s: Option<f64>,
    /// Whether the claimed error is within the tolerance, or the budget gave an answer.
    pub met: bool,
    /// Rungs that were tried, in order; the answer is the last one's.
    pub rungs: Vec<ClimbRung>,
}

/// A step of the way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ClimbRung {
    /// Label in a few words.
    pub label: String,
    /// Mesh and method.
    pub fidelity: FidelityReport,
    /// Solves, those on the coarser mesh included.
    pub solves: usize,
    /// Largest claimed error of an index at P1, P2, ..., absolute.
    pub error_claimed: Option<f64>,
    /// The mesh's part of it.
    pub error_of_mesh: Option<f64>,
}

/// A fidelity as it stands in documents.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FidelityReport {
    /// Mesh level.
    pub level: String,
    /// Method.
    pub method: String,
    /// Gauss nodes for each input, at the start where the method adds some.
    pub nodes: usize,
    /// Points off the lines, at the start where the method adds some.
    pub check_points: usize,
}
