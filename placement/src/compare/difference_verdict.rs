//! Verdict on the difference between two studies.

use serde::{Deserialize, Serialize};

/// Verdict on a difference.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Difference beyond its error.
    Real,
    /// Difference within its error.
    Noise,
    /// Difference whose error isn't known.
    Unknown,
}

impl Verdict {
    pub(super) fn of(difference: f64, error: Option<f64>) -> Self {
        match error {
            Some(error) if difference.abs() > error => Self::Real,
            Some(_) => Self::Noise,
            None => Self::Unknown,
        }
    }

    /// The word in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Real => "real",
            Self::Noise => "noise",
            Self::Unknown => "unknown",
        }
    }
}
