//! Derivative of a response.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// Derivative of a response by one number of its scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Derivative {
    /// Path of the number, as in `ground.depths_mm[2]`.
    pub by: String,
    /// Derivatives under the names of the response's fields: their units per unit of the number.
    #[serde(flatten)]
    #[schema(value_type = std::collections::HashMap<String, Value>)]
    pub of: Map<String, Value>,
}
