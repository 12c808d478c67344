//! Findings of what the figures of a study's layouts rest on.

use serde::{Deserialize, Serialize};

/// Figures of the layout that answers, with what they rest on changed, one at a time.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct AssumptionFindings {
    /// Rank of that layout.
    pub rank: usize,
    /// 95 of 100 contact angles are estimated better than this at the worst load, degrees, as assumed.
    pub angle_error_deg: f64,
    /// Error of the vertical force at the load where that is largest, root mean square, N, as assumed.
    pub force_error_n: f64,
    /// Changed assumptions, the one that changes the figures most first.
    pub changes: Vec<AssumptionChange>,
    /// Assumptions that weren't changed, in words: those that the document names no value of, and those whose scene has no answer.
    pub unchanged: Vec<String>,
}

/// Assumptions that the figures of the layout that answers rest on most, in words.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct RestsOn {
    /// The figures as assumed, and with each of the three changes that move them most; whole sentences.
    pub sentence: String,
    /// The one that moves them most in few characters, as in `pressure: 2.31 N`, and what would answer with a change in this one's place; empty where none moves a figure by a tenth.
    pub brief: String,
}

/// An assumption, changed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct AssumptionChange {
    /// Name of the assumption: `noise`, `drift`, `gain`, `place`, `pressure`, `camber` or `friction`.
    pub of: String,
    /// Change in words, as in `a pressure 10 % lower`.
    pub words: String,
    /// The angle's error then, degrees.
    pub angle_error_deg: f64,
    /// The force's error then, N.
    pub force_error_n: f64,
    /// Larger of both errors' ratios to those as assumed; of a smaller error one over that.
    pub times: f64,
    /// Rank of a layout of no more films that does better then, by more than chance; null where this one stays.
    pub better_rank: Option<usize>,
    /// Whether it keeps to the limits of the question then; null where none is asked, or none was kept as assumed.
    pub meets: Option<bool>,
}
