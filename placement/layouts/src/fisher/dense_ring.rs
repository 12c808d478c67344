//! Density that is dense enough: the worst bound of regular layouts against that of a dense ring.
//!
//! Of a dense ring the sum over films is an integral, and the worst bound times the root of the number of units doesn't depend on that number. The knee is the
//! least number of units from which on that product stays within twice the dense ring's.

use crate::arrangement::Arrangement;
use crate::field::film_field::{LoadField, Noise};
use crate::fisher::bounds::bounds;
use crate::fisher::information::Information;

/// Most units that are tried.
const MOST_UNITS: usize = 90;
/// Ratio to a dense ring's bound up to which a layout is dense enough.
const KNEE: f64 = 2.0;

/// Worst bound of the angle times the root of the number of units of a dense ring, degrees; `None` where even that tells nothing.
pub(crate) fn dense_bound_deg(field: &LoadField, kinds: &[usize], noise: &Noise) -> Option<f64> {
    let unknowns = 1 + field.kinds[kinds[0]].slopes.len();
    let mut information = Information::of(unknowns);
    for kind in kinds.iter().map(|&kind| &field.kinds[kind]) {
        for apart in (-180..180).map(f64::from) {
            let slopes: Vec<f64> = kind.derivatives(apart).collect();
            // One film for every unit, spread over the turn.
            let variance = noise.variance(kind.signal.at(apart), slopes[0]) + kind.scatter(apart);
            information.add(&slopes, 360.0 * variance);
        }
    }
    information
        .deviations()
        .ok()
        .map(|deviations| deviations[0])
}

/// The knee of one section angle and set of films.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingKnee {
    /// Worst bound times the root of the number of units of a dense ring, degrees.
    pub dense_deg: f64,
    /// The number of units; `None` where even the most that are tried aren't enough.
    pub units: Option<usize>,
    /// Units every 60 degrees over the dense ring; `None` where they are blind.
    pub of_60_deg: Option<f64>,
}

/// Compares regular layouts of these kinds of film with the dense ring.
pub fn knee(field: &LoadField, kinds: &[usize], noise: &Noise) -> Option<RingKnee> {
    let dense_deg = dense_bound_deg(field, kinds, noise)?;
    let over_dense = |units: usize| {
        let worst = bounds(field, &Arrangement::regular(units, kinds, false), noise)
            .ok()?
            .worst_angle_deg;
        Some(worst * (units as f64).sqrt() / dense_deg)
    };
    let is_dense = |units: &usize| over_dense(*units).is_some_and(|ratio| ratio <= KNEE);
    let enough = (1..=MOST_UNITS).rev().take_while(is_dense).last();
    Some(RingKnee {
        dense_deg,
        units: enough,
        of_60_deg: over_dense(6),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fisher::bounds::tests::{NOISE, gaussian};

    #[test]
    fn a_dense_ring_has_its_closed_form() {
        // Of a Gaussian of depth d and width s: sum h'^2 = N / 360 sqrt(pi) d^2 / 2 s, none of it mixed with the depth.
        let (width, field) = (15.0, gaussian(15.0).at(1.0));
        let expected = NOISE.floor * (2.0 * width * 360.0 / std::f64::consts::PI.sqrt()).sqrt();
        let dense = dense_bound_deg(&field, &[0], &NOISE).expect("dense");
        // Slopes are off by 1e-5 of fifth derivatives.
        assert!((dense / expected - 1.0).abs() < 3e-5, "{dense} {expected}");
        let many = bounds(&field, &Arrangement::regular(90, &[0], false), &NOISE)
            .expect("dense")
            .worst_angle_deg;
        assert!((many * 90f64.sqrt() / dense - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_knee_lies_at_about_two_widths() {
        // Published for single Gaussians: within twice the dense ring from spacings of about 2.1 widths on.
        for width in [12.0, 20.0] {
            let found = knee(&gaussian(width).at(1.0), &[0], &NOISE).expect("dense");
            let spacing = 360.0 / found.units.expect("a knee") as f64 / width;
            assert!((1.6..2.4).contains(&spacing), "{width}: {spacing}");
        }
    }
}
