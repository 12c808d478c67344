//! Question that a study's layouts answer.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Table;
use document::fields::Range;
use serde::{Deserialize, Serialize};

use crate::layouts::layout_bounds::MOST_FILMS;

/// Errors of an angle: half a turn at most.
const ANGLE: Range = Range::new(1e-3, 180.0, "degrees");
const FORCE: Range = Range::new(1e-6, 1e6, "N");
const FILMS: (u64, u64) = (1, MOST_FILMS as u64);

/// Question that a study's layouts answer: the best with so many films, or the fewest films that keep errors within limits.
#[derive(Debug, Clone, Copy, PartialEq, Table, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Question {
    /// Most films of a layout, those that are glued on already among them.
    #[field(within = FILMS)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub films: Option<usize>,
    /// Largest error of the contact angle that is allowed, degrees: of 95 in 100 contacts at the worst load.
    #[field(within = ANGLE)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub angle_deg: Option<f64>,
    /// Largest error of the vertical force that is allowed, N: root mean square at the worst load.
    #[field(within = FORCE)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub force_n: Option<f64>,
}

impl Question {
    /// Whether nothing is asked.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Whether errors have limits.
    pub fn has_limits(&self) -> bool {
        self.angle_deg.is_some() || self.force_n.is_some()
    }
}
