//! Points without a response.

use fem_client::scene::slips::{Slip, noting};
use fem_client::solver::{NoEquilibrium, Reached};
use serde::de::IntoDeserializer;
use serde::de::value::StrDeserializer;
use serde::{Deserialize, Serialize};

/// Reason why a point has no equilibrium, as [`fem_client::solver::SolveError::NoEquilibrium`] says it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, thiserror::Error)]
#[error("{}: {detail}", status.as_str())]
pub struct Unsolved {
    /// The kind of failure.
    pub status: NoEquilibrium,
    /// Load, and how far it got, in words.
    pub detail: String,
    /// Loads reached.
    pub reached: Reached,
}

/// A point without a response.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FailedPoint {
    /// Ordinal in the plan.
    pub ordinal: usize,
    /// Input values.
    pub values: Vec<f64>,
    /// Cause of the failure.
    #[schema(value_type = String)]
    pub cause: Cause,
}

/// Cause of a missing response; in documents its text.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub struct Cause {
    /// The kind of missing equilibrium, where that is why.
    pub status: Option<NoEquilibrium>,
    text: String,
}

impl Cause {
    /// Another cause than a missing equilibrium.
    pub fn other(text: String) -> Self {
        Self { status: None, text }
    }

    /// The cause with the scene's unlikely values, which may be behind it.
    #[must_use]
    pub fn noting(self, slips: &[Slip]) -> Self {
        Self {
            text: noting(self.text, slips),
            ..self
        }
    }
}

impl From<&Unsolved> for Cause {
    fn from(unsolved: &Unsolved) -> Self {
        Self {
            status: Some(unsolved.status),
            text: unsolved.to_string(),
        }
    }
}

/// Reads the text as it was written: a missing equilibrium begins with its kind.
impl From<String> for Cause {
    fn from(text: String) -> Self {
        let kind: StrDeserializer<'_, serde::de::value::Error> = text
            .split(": ")
            .next()
            .unwrap_or_default()
            .into_deserializer();
        Self {
            status: NoEquilibrium::deserialize(kind).ok(),
            text,
        }
    }
}

impl From<Cause> for String {
    fn from(cause: Cause) -> Self {
        cause.text
    }
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.text)
    }
}
