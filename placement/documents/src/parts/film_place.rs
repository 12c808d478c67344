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

/// Angles that differ by less are one, degrees: rounding.
const SAME_DEG: f64 = 1e-9;

impl FilmPlace {
    /// Whether both are one film: at the same place, with their lengths along the same line.
    pub fn is_same(&self, other: &Self) -> bool {
        let apart = |a: f64, b: f64, turn: f64| (a - b + 0.5 * turn).rem_euclid(turn) - 0.5 * turn;
        apart(self.theta_deg, other.theta_deg, 360.0).abs() < SAME_DEG
            && (self.phi_deg - other.phi_deg).abs() < SAME_DEG
            && apart(self.angle_deg, other.angle_deg, 180.0).abs() < SAME_DEG
    }
}
