//! Places of films.

use serde::{Deserialize, Serialize};

/// A film of a layout.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmPlace {
    /// Wheel angle, degrees.
    pub theta_deg: f64,
    /// Section angle from the crown, degrees.
    pub phi_deg: f64,
    /// Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
    pub angle_deg: f64,
}
