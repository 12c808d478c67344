//! Coulomb friction on the ground, with a stiff spring in place of perfect sticking.
//!
//! Each contact point hangs on a spring of stiffness `eps_t` per area whose foot, the anchor, stands on the ground. The
//! traction -eps_t s follows the slip s from the anchor while it is below mu p; beyond, it keeps that size and its
//! direction, and the anchor is dragged along. Anchors move only when a load step is done, so that within a step the law
//! is a function of the slip, with a consistent tangent (P. Wriggers, Computational Contact Mechanics, 2nd ed., ch. 5).
//! Slip and traction are taken in the horizontal plane: exact on flat ground, to second order in its slope elsewhere.

/// Friction of a contact surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// Coulomb's coefficient mu; 0 is frictionless.
    pub coefficient: f64,
    /// Stiffness of sticking, force per area and slip, N/mm^3.
    pub stiffness: f64,
}

/// Traction on the body and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Traction {
    /// Traction along x and y, MPa.
    pub(crate) value: [f64; 2],
    /// Derivative by the slip.
    pub(crate) by_slip: [[f64; 2]; 2],
    /// Derivative by the contact pressure.
    pub(crate) by_pressure: [f64; 2],
}

impl Friction {
    /// No friction.
    pub const NONE: Self = Self {
        coefficient: 0.0,
        stiffness: 0.0,
    };

    /// Traction at a slip from the anchor, under a contact pressure.
    pub(crate) fn traction(&self, slip: [f64; 2], pressure: f64) -> Traction {
        let limit = self.coefficient * pressure;
        let length = slip[0].hypot(slip[1]);
        if self.stiffness * length <= limit {
            return Traction {
                value: slip.map(|s| -self.stiffness * s),
                by_slip: [[-self.stiffness, 0.0], [0.0, -self.stiffness]],
                by_pressure: [0.0; 2],
            };
        }
        let direction = slip.map(|s| s / length);
        let across = |i: usize, j: usize| {
            let same = if i == j { 1.0 } else { 0.0 };
            -limit / length * (same - direction[i] * direction[j])
        };
        Traction {
            value: direction.map(|d| -limit * d),
            by_slip: [[across(0, 0), across(0, 1)], [across(1, 0), across(1, 1)]],
            by_pressure: direction.map(|d| -self.coefficient * d),
        }
    }

    /// Returns the anchor's place after a load step that ended at `position` with this slip and pressure.
    pub(crate) fn anchor(&self, position: [f64; 2], slip: [f64; 2], pressure: f64) -> [f64; 2] {
        let traction = self.traction(slip, pressure).value;
        [0, 1].map(|i| position[i] + traction[i] / self.stiffness)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: Friction = Friction {
        coefficient: 0.4,
        stiffness: 50.0,
    };

    #[test]
    fn the_cone_is_never_left() {
        for k in 0..50 {
            let slip = [0.001 * f64::from(k), -0.0004 * f64::from(k)];
            let [x, y] = LAW.traction(slip, 0.3).value;
            assert!(x.hypot(y) <= 0.4 * 0.3 * (1.0 + 1e-15));
            assert!(x * slip[0] + y * slip[1] <= 0.0);
        }
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let h = 1e-7;
        for slip in [[0.001, 0.0005], [0.01, -0.02]] {
            let law = LAW.traction(slip, 0.3);
            for j in 0..2 {
                let at = |sign: f64| {
                    let mut moved = slip;
                    moved[j] += sign * h;
                    LAW.traction(moved, 0.3).value
                };
                for i in 0..2 {
                    let difference = (at(1.0)[i] - at(-1.0)[i]) / (2.0 * h);
                    // Round-off 1e-16 / h, truncation h^2 times limit / length^3 = 1e-9.
                    assert!((difference - law.by_slip[i][j]).abs() < 1e-7);
                }
            }
            for i in 0..2 {
                let at = |p: f64| LAW.traction(slip, p).value[i];
                let difference = (at(0.3 + h) - at(0.3 - h)) / (2.0 * h);
                assert!((difference - law.by_pressure[i]).abs() < 1e-7);
            }
        }
    }

    #[test]
    fn a_dragged_anchor_keeps_the_traction() {
        let (position, slip) = ([1.0, 2.0], [0.3, -0.4]);
        let anchor = LAW.anchor(position, slip, 0.3);
        let after = LAW.traction([position[0] - anchor[0], position[1] - anchor[1]], 0.3);
        let before = LAW.traction(slip, 0.3).value;
        for i in 0..2 {
            assert!((after.value[i] - before[i]).abs() < 1e-14);
        }
        // A sticking point's anchor stays.
        let small = [1e-4, 0.0];
        assert_eq!(LAW.anchor([1.0 + 1e-4, 2.0], small, 0.3), [1.0, 2.0]);
    }
}
