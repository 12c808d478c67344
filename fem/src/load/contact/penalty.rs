//! The pressure that a penetration costs.

/// Stiffness of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Penalty {
    /// Force per area and penetration, N/mm^3.
    pub stiffness: f64,
    /// Penetration over which the stiffness grows from zero to its full value, mm.
    pub ramp: f64,
}

impl Penalty {
    /// Pressure and its slope at a penetration.
    pub fn pressure(&self, penetration: f64) -> (f64, f64) {
        if penetration <= 0.0 {
            (0.0, 0.0)
        } else if penetration < self.ramp {
            let slope = self.stiffness * penetration / self.ramp;
            (0.5 * slope * penetration, slope)
        } else {
            (
                self.stiffness * (penetration - 0.5 * self.ramp),
                self.stiffness,
            )
        }
    }
}
