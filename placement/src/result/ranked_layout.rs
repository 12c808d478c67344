//! Layouts in their order.

use fem_client::solver::direction::Direction;
use serde::{Deserialize, Serialize};

/// One layout in the ranking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RankedLayout {
    /// 1 is best.
    pub rank: usize,
    /// Angle between neighbouring units, degrees.
    pub spacing_deg: f64,
    /// Number of units.
    pub units: usize,
    /// Meridional position.
    pub position: String,
    /// Films of each unit.
    #[cfg_attr(feature = "openapi", schema(value_type = Vec<String>))]
    pub films: Vec<Direction>,
    /// Its scores.
    pub score: LayoutScore,
}

/// How well a layout sees the contact, over all angles at which it can touch down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LayoutScore {
    /// Strain of the film that sees most, at the contact angle where that is least.
    pub weakest_signal: Option<f64>,
    /// Cramer-Rao bound of the contact angle, worst angle, degrees.
    pub worst_angle_error_deg: Option<f64>,
    /// Cramer-Rao bound of the contact angle, root mean square over the angles, degrees.
    pub rms_angle_error_deg: Option<f64>,
    /// Cramer-Rao bound of a uniform depth, worst angle, mm.
    pub worst_depth_error_mm: Option<f64>,
    /// Noise of each film assumed for the bounds, strain.
    pub noise_strain: f64,
    /// Why numbers are null.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}
