//! A turn of the crank, and where the ground is at an instant of it.
//!
//! The crank turns at constant speed, by the angle theta from -pi to pi, and the foot follows its cosine. It touches the ground for |theta| < theta0, which
//! is pi times the duty: depth = peak (cos theta - cos theta0) / (1 - cos theta0).
//!
//! The ground shifts along and across the wheel by a share of the shift at which the contact would slide at the depth of that instant. Each share goes in a
//! straight line from one value at touch-down to another at lift-off, so that no force follows from another within a stance, nor from stance to stance. This
//! course is assumed: the paper states none.

use std::f64::consts::{PI, TAU};

use crate::contact_response::{Contact, ContactResponse};

/// A turn of the crank, from the highest point to the next one.
#[derive(Debug, Clone, PartialEq)]
pub struct Stance {
    /// Number in the run, from 0.
    pub number: usize,
    /// Time at which its turn begins, s.
    pub begin_s: f64,
    /// Turns a second.
    pub hz: f64,
    /// Share of the turn in which the ground is touched.
    pub duty: f64,
    /// Wheel angle of the contact, degrees.
    pub contact_deg: f64,
    /// Load at the deepest point, N, but for shear and relaxation.
    pub load_n: f64,
    /// The greatest depth, mm.
    pub peak_mm: f64,
    /// Shares of the sliding shift, along and across, at touch-down and at lift-off.
    pub shear: [[f64; 2]; 2],
    /// Shares of the laws of what contacts differ in besides, from 0 to 1; none where they are alike.
    pub shares: Vec<f64>,
}

impl Stance {
    /// Returns the time at which its turn ends, s.
    pub(crate) fn end_s(&self) -> f64 {
        self.begin_s + self.hz.recip()
    }

    /// Part of the way from touch-down to lift-off at a time of contact.
    pub fn progress(&self, time_s: f64) -> f64 {
        let theta = TAU * (time_s - self.begin_s) * self.hz - PI;
        0.5 * (1.0 + theta / (PI * self.duty))
    }

    /// Returns the contact at a time within its turn, s.
    pub fn contact<R: ContactResponse + ?Sized>(&self, time_s: f64, response: &R) -> Contact {
        let theta = TAU * (time_s - self.begin_s) * self.hz - PI;
        let edge = PI * self.duty;
        if theta.abs() >= edge {
            return Contact::AIR;
        }
        let depth_mm = self.peak_mm * (theta.cos() - edge.cos()) / (1.0 - edge.cos());
        let progress = self.progress(time_s);
        let sliding = response.sticking_shift_mm(depth_mm);
        let [down, up] = self.shear;
        Contact {
            depth_mm,
            shift_mm: [0, 1].map(|axis| {
                let share = down[axis] + progress * (up[axis] - down[axis]);
                share * sliding[axis]
            }),
        }
    }
}

/// Deviation of a share along or across that goes evenly from one point of a disc of radius one to another, at a part of the way: each point has half of the radius.
pub(crate) fn shear_deviation(progress: f64) -> f64 {
    0.5 * progress.hypot(1.0 - progress)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bump_response::BumpResponse;

    const STANCE: Stance = Stance {
        number: 3,
        begin_s: 10.0,
        hz: 2.0,
        duty: 0.5,
        contact_deg: 12.0,
        load_n: 20.0,
        peak_mm: 1.5,
        shear: [[0.5, -0.4], [-0.1, 0.2]],
        shares: Vec::new(),
    };

    #[test]
    fn half_a_turn_touches_the_ground_with_the_crank_s_cosine() {
        let tire = BumpResponse::new(6);
        let at = |time_s| STANCE.contact(time_s, &tire).depth_mm;
        // The turn takes half a second; the ground is touched from a quarter to three quarters of it.
        assert_eq!(STANCE.end_s(), 10.5);
        for air in [10.0, 10.124, 10.376, 10.499] {
            assert_eq!(at(air), 0.0, "{air}");
        }
        // 1e-12: rounding of times near 10 s, some 2e-15 s, by at most 19 mm/s, and of cosines.
        for (time_s, turn) in [(10.25, 0.0), (10.2, -0.1), (10.3, 0.1), (10.15, -0.2)] {
            let expected = 1.5 * f64::cos(TAU * turn);
            assert!((at(time_s) - expected).abs() < 1e-12, "{time_s}");
        }
    }

    #[test]
    fn a_longer_contact_begins_earlier_and_is_as_deep() {
        let tire = BumpResponse::new(6);
        let stance = Stance {
            duty: 0.8,
            ..STANCE
        };
        let at = |turn: f64| stance.contact(10.25 + turn / 2.0, &tire).depth_mm;
        assert!((at(0.0) - 1.5).abs() < 1e-12);
        assert_eq!(at(0.401), 0.0);
        assert!(at(0.399) > 0.0 && at(-0.399) > 0.0);
        let edge = f64::cos(0.8 * PI);
        let expected = 1.5 * (f64::cos(TAU * 0.3) - edge) / (1.0 - edge);
        assert!((at(0.3) - expected).abs() < 1e-12);
    }

    #[test]
    fn shares_of_the_sliding_shift_go_in_a_line() {
        let tire = BumpResponse::new(6);
        for (turn, along, across) in [(0.0, 0.2, -0.1), (0.125, 0.05, 0.05), (-0.125, 0.35, -0.25)]
        {
            let contact = STANCE.contact(10.25 + turn / 2.0, &tire);
            let sliding = tire.sticking_shift_mm(contact.depth_mm);
            for (axis, share) in [along, across].into_iter().enumerate() {
                let found = contact.shift_mm[axis] / sliding[axis];
                assert!((found - share).abs() < 1e-12, "{turn} {axis} {found}");
            }
        }
    }
}
