//! Rows that a model was tested on.

/// Prediction of a row that the model hadn't learnt from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOut {
    /// The row's number among all labelled rows.
    pub row: usize,
    /// Group that was left out with it: the number of its run or cycle.
    pub group: usize,
    /// The measured force, N.
    pub truth: f64,
    /// The estimate, N.
    pub mean: f64,
    /// The model's standard deviation, N.
    pub deviation: f64,
    /// Whether a reading of it or its force is suspect.
    pub is_suspect: bool,
}
