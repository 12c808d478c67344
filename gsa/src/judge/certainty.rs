//! Certainty of an order, from the errors of what is ordered.
//!
//! A claimed error covers the true one in some 95 % of cases, two standard deviations of a normal law. With independent
//! errors e_a and e_b
//!
//! ```text
//! P(A > B) = Phi(2 (a - b) / sqrt(e_a^2 + e_b^2))
//! ```
//!
//! Values that are equal to rounding are a tie, whatever their errors: mirror images of one another, say. They share their
//! place, P is one half, and neither makes the other's place uncertain.

use std::f64::consts::SQRT_2;

use statrs::function::erf::erfc;

/// A place is certain at this probability against everybody of another place.
pub const CERTAIN: f64 = 0.95;
/// A claimed error in standard deviations.
const DEVIATIONS: f64 = 2.0;

/// A value with its claimed error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// value
    pub value: f64,
    /// claimed error; infinite if unknown
    pub error: f64,
}

impl Estimate {
    /// Whether two values are equal to rounding.
    pub fn ties(&self, other: &Self, rounding: f64) -> bool {
        (self.value - other.value).abs() <= rounding
    }

    /// P(this > other); one half for a tie, and where an error is unknown.
    pub fn outranks(&self, other: &Self, rounding: f64) -> f64 {
        if self.ties(other, rounding) {
            return 0.5;
        }
        let deviation = self.error.hypot(other.error) / DEVIATIONS;
        // Phi(z) = erfc(-z/sqrt 2)/2
        0.5 * erfc((other.value - self.value) / deviation / SQRT_2)
    }
}

/// Returns for each of some estimates whether its place among all is certain.
pub fn places_certain(estimates: &[Estimate], rounding: f64) -> Vec<bool> {
    let certain = |a: &Estimate| {
        estimates.iter().all(|b| {
            let p = a.outranks(b, rounding);
            a.ties(b, rounding) || p.max(1.0 - p) >= CERTAIN
        })
    };
    estimates
        .iter()
        .map(|a| a.error.is_finite() && certain(a))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn estimate(value: f64, error: f64) -> Estimate {
        Estimate { value, error }
    }

    #[test]
    fn probabilities_are_those_of_the_normal_law() {
        let (a, b) = (estimate(0.5, 0.3), estimate(0.25, 0.4));
        // 2 0.25/0.5 = 1: Phi(1)
        // statrs has ten digits of the error function
        assert!((a.outranks(&b, 0.0) - 0.841_344_746_068_543).abs() < 1e-10);
        assert!((a.outranks(&b, 0.0) + b.outranks(&a, 0.0) - 1.0).abs() < 1e-15);
        assert_eq!(a.outranks(&estimate(0.5, 0.1), 0.0), 0.5);
        assert_eq!(a.outranks(&estimate(0.2, f64::INFINITY), 0.0), 0.5);
        let exact = estimate(0.5, 0.0);
        assert_eq!(exact.outranks(&estimate(0.4, 0.0), 0.0), 1.0);
        assert_eq!(exact.outranks(&estimate(0.5 + 1e-12, 0.0), 1e-9), 0.5);
    }

    #[test]
    fn a_tie_leaves_its_places_certain_and_a_neighbour_within_the_errors_does_not() {
        let mirrored = [
            estimate(0.6, 0.01),
            estimate(0.2, 0.05),
            estimate(0.2, 0.05),
        ];
        assert_eq!(places_certain(&mirrored, 1e-9), [true; 3]);
        let close = [
            estimate(0.6, 0.01),
            estimate(0.2, 0.05),
            estimate(0.18, 0.05),
        ];
        assert_eq!(places_certain(&close, 1e-9), [true, false, false]);
        let unknown = [estimate(0.6, f64::INFINITY), estimate(0.2, 0.01)];
        assert_eq!(places_certain(&unknown, 1e-9), [false, false]);
    }
}
