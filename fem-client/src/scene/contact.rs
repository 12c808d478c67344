//! Contact of tire and ground.

use document::Table;
use document::fields::Range;

const FRICTION: Range = Range::new(0.0, 10.0, "");
const PENALTY: Range = Range::new(1e-6, 1e9, "N/mm^3");

/// Contact of tire and ground.
#[derive(Debug, Clone, PartialEq, Table)]
pub struct Contact {
    /// Coulomb friction coefficient.
    #[field(default = 0.0, within = FRICTION)]
    pub friction: f64,
    /// Contact stiffness, N/mm^3; absent: scaled from the rubber's stiffness and the wall.
    #[field(within = PENALTY)]
    pub penalty_n_per_mm3: Option<f64>,
}
