//! Films of the answer, as they are glued.

use serde::{Deserialize, Serialize};

/// A film of the answer, and where it is glued on the tire that isn't inflated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SheetFilm {
    /// Number of the film, from 1, around the wheel from the mark.
    pub number: usize,
    /// Wheel angle from the mark in the rolling direction, degrees.
    pub theta_deg: f64,
    /// Arc on the inner surface from the mark to the film's middle, around the wheel at its section angle, mm.
    pub arc_mm: f64,
    /// Arc once around the wheel there, mm.
    pub circle_mm: f64,
    /// Section angle from the crown, degrees.
    pub phi_deg: f64,
    /// Arc on the inner surface from the nearer bead, where the wall ends, to the film's middle, mm.
    pub from_bead_mm: f64,
    /// Arc from the crown to the film's middle, negative on the side of negative section angles, mm.
    pub from_crown_mm: f64,
    /// Direction of its length: `x`, `y`, or an angle such as `45`.
    pub direction: String,
    /// Length of the film, mm; null of a point.
    pub length_mm: Option<f64>,
    /// Width of the film, mm; null of a point.
    pub width_mm: Option<f64>,
    /// Arc from the mark to its connector, which is at the end nearer to a bead, and of a film along the wheel at the end ahead, mm.
    #[serde(default)]
    pub connector_arc_mm: Option<f64>,
    /// Arc from the nearer bead to its connector, mm.
    #[serde(default)]
    pub connector_from_bead_mm: Option<f64>,
    /// Length of a lead from its connector straight to the bead, and along that to the mark on the shorter way, mm.
    #[serde(default)]
    pub lead_mm: Option<f64>,
    /// Strain that it reads with the contact at it, at the depth below; null of glued films, and where it isn't known.
    #[serde(default)]
    pub expected_strain: Option<f64>,
    /// Open circuit's voltage that a glued film reads so, V; null of bare films.
    #[serde(default)]
    pub expected_v: Option<f64>,
    /// Depth of that contact: the load in the middle, mm.
    #[serde(default)]
    pub expected_depth_mm: Option<f64>,
}
