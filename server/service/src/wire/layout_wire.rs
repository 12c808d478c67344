//! Layouts that somebody moves by hand, on the wire.

use results::RankedLayout;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// Layouts to be scored.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct HandLayoutsDocument {
    /// The layouts.
    #[schema(min_items = 1, max_items = 50)]
    pub layouts: Vec<HandLayout>,
    /// Whether errors are simulated beside the bounds, of 4 layouts at most; false when left out.
    #[serde(default)]
    pub simulated: bool,
}

/// A layout film by film.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct HandLayout {
    /// Name of the layout, of at most 60 characters; its number when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(min_length = 1, max_length = 60)]
    pub name: Option<String>,
    /// Films of the layout, each at a place of its own.
    #[schema(min_items = 1, max_items = 96)]
    pub films: Vec<HandFilm>,
}

/// A film of a layout; an angle that is left out is 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct HandFilm {
    /// Wheel angle, degrees.
    #[serde(default)]
    #[schema(minimum = -360.0, maximum = 360.0)]
    pub theta_deg: f64,
    /// Section angle from the crown, degrees: one of the study's kinds.
    #[serde(default)]
    pub phi_deg: f64,
    /// Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
    #[serde(default)]
    #[schema(minimum = -360.0, maximum = 360.0)]
    pub angle_deg: f64,
}

/// Layouts with their scores.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ScoredLayouts {
    /// Layouts in the order of the request.
    pub layouts: Vec<RankedLayout>,
}
