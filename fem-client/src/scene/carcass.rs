//! The textile layer.

use document::Table;
use document::fields::Range;

const ANGLE: Range = Range::new(0.0, 90.0, "degrees");
const STIFFNESS: Range = Range::new(0.0, 1e9, "N/mm");
const SHARE: Range = Range::new(0.0, 1.0, "");

/// Textile layer: two fibre families at +-angle to the circumference, a membrane within the wall.
#[derive(Debug, Clone, PartialEq, Table)]
pub struct Carcass {
    /// Angle of both families to the circumferential direction, degrees.
    #[field(default = 55.0, within = ANGLE)]
    pub angle_deg: f64,
    /// Stiffness of each family in tension, N/mm.
    #[field(default = 100.0, within = STIFFNESS)]
    pub stiffness_n_per_mm: f64,
    /// Position through the wall: 0 inner surface, 1 outer surface.
    #[field(default = 0.5, within = SHARE)]
    pub position: f64,
    /// Stiffness in compression over that in tension.
    #[field(default = 0.01, within = SHARE)]
    pub compression_ratio: f64,
}
