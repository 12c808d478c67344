//! Least and greatest values.

use serde::{Deserialize, Serialize};

/// Least and greatest value of a field.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Extremes {
    /// Least value.
    pub min: f64,
    /// Greatest value.
    pub max: f64,
}

impl Extremes {
    /// The range without values.
    pub const NONE: Self = Self {
        min: f64::INFINITY,
        max: f64::NEG_INFINITY,
    };

    /// Widens the range to a value.
    pub fn include(&mut self, value: f64) {
        self.min = self.min.min(value);
        self.max = self.max.max(value);
    }
}
