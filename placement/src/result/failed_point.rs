//! Points without a response.

use fem_client::solver::NoEquilibrium;
use serde::de::IntoDeserializer;
use serde::de::value::StrDeserializer;
use serde::{Deserialize, Serialize};

use crate::run::archive::Unsolved;

/// A point without a response.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct FailedPoint {
    /// Ordinal in the plan.
    pub ordinal: usize,
    /// Input values.
    pub values: Vec<f64>,
    /// What happened.
    #[cfg_attr(feature = "openapi", schema(value_type = String))]
    pub cause: Cause,
}

/// Why a point has no response; in documents its text.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub struct Cause {
    /// The kind of missing equilibrium, where that is why.
    pub status: Option<NoEquilibrium>,
    text: String,
}

impl Cause {
    /// Another cause than a missing equilibrium.
    pub(crate) fn other(text: String) -> Self {
        Self { status: None, text }
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

/// As it was written: a missing equilibrium begins with its kind.
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
