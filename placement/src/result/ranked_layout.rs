//! Locations and layouts in their order.

use serde::{Deserialize, Serialize};

/// One candidate location in the ranking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct RankedLocation {
    /// P1, P2, ...
    pub name: String,
    /// The input that is this location's own: the depth of the station below it.
    #[serde(default)]
    pub input: Option<String>,
    /// 1 is best.
    pub rank: usize,
    /// 100 times the first-order index of this location's own depth for the x strain at the centre.
    pub gsi_x_percent: Option<f64>,
    /// The same for the y strain.
    pub gsi_y_percent: Option<f64>,
    /// Error of `gsi_x_percent`, percentage points.
    #[serde(default)]
    pub gsi_x_error_percent: Option<f64>,
    /// The same for y.
    #[serde(default)]
    pub gsi_y_error_percent: Option<f64>,
    /// Mean over the x strains at all locations.
    pub mean_gsi_x_percent: Option<f64>,
    /// Mean over the y strains at all locations.
    pub mean_gsi_y_percent: Option<f64>,
    /// For the x strain at this location itself.
    pub own_gsi_x_percent: Option<f64>,
    /// For the y strain at this location itself.
    pub own_gsi_y_percent: Option<f64>,
    /// What M-DRM said for `gsi_x_percent`, valid or not: the paper's Table 2 as the paper computed it.
    pub mdrm_gsi_x_percent: Option<f64>,
    /// The same for y.
    pub mdrm_gsi_y_percent: Option<f64>,
    /// Rank by the x strain alone.
    pub rank_x: Option<usize>,
    /// Rank by the y strain alone.
    pub rank_y: Option<usize>,
    /// Whether the errors leave no doubt about this rank.
    pub rank_certain: bool,
}

impl RankedLocation {
    /// Whether an index that it is ranked by has a known error.
    pub(crate) fn knows_error(&self) -> bool {
        self.gsi_x_error_percent
            .or(self.gsi_y_error_percent)
            .is_some()
    }
}

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
    pub films: Vec<String>,
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
