//! Certainty of an answer.

use serde::{Deserialize, Serialize};

/// Certainty of a first rank, by what the order goes by; surest first. Mirror images tie by symmetry: that isn't uncertainty.
#[derive(
    Debug,
    Default,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    utoipa::ToSchema,
)]
#[serde(rename_all = "lowercase")]
pub enum Certainty {
    /// The errors leave no doubt: first with a probability of 0.95 against every other, as wherever the difference is larger than both errors together.
    Certain,
    /// The difference from every other is larger than the larger of both errors, and for one that isn't enough to be certain.
    Likely,
    /// The difference from another, or from nothing at all, is within the larger of both errors.
    Tied,
    /// An error is missing, nothing else is ranked, or layouts lose the contact: one in twenty is off by more than 20 degrees.
    #[default]
    Unknown,
}

impl Certainty {
    /// Words, surest first.
    pub const ALL: [Self; 4] = [Self::Certain, Self::Likely, Self::Tied, Self::Unknown];

    /// Returns its name in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Certain => "certain",
            Self::Likely => "likely",
            Self::Tied => "tied",
            Self::Unknown => "unknown",
        }
    }
}
