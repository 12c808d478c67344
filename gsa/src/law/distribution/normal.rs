//! Normal law of a mean and a standard deviation; rule: Gauss-Hermite.

use std::f64::consts::{PI, SQRT_2};

use statrs::function::erf::{erfc, erfc_inv};

use super::law_contract::Law;
use crate::law::basis::Basis;
use crate::law::density::{Density, Place, centred};
use crate::law::distribution::distribution_error::{DistributionError, finite, in_range, positive};
use crate::law::recurrence::Recurrence;

/// Density exp(-z^2/2) / (std sqrt(2 pi)) with z = (x - mean) / std.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Normal {
    mean: f64,
    std: f64,
}

impl Normal {
    pub(super) fn new(mean: f64, std: f64) -> Result<Self, DistributionError> {
        finite("mean", mean)?;
        positive("std", std)?;
        in_range("normal", mean, std)?;
        Ok(Self { mean, std })
    }
}

impl Law for Normal {
    fn kind(&self) -> &'static str {
        "normal"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![("mean", self.mean), ("std", self.std)]
    }

    fn mean(&self) -> f64 {
        self.mean
    }

    fn std(&self) -> f64 {
        self.std
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        let z = (x - self.mean) / self.std;
        (standard_cdf(z), standard_cdf(-z))
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        let z = if p < 0.5 {
            standard_inverse_cdf(p)
        } else {
            -standard_inverse_cdf(q)
        };
        self.mean + z * self.std
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        Some(Basis::plain(Recurrence::hermite(size), self.mean, self.std))
    }

    fn density(&self) -> &dyn Density {
        self
    }
}

impl Density for Normal {
    fn support(&self) -> (f64, f64) {
        (f64::NEG_INFINITY, f64::INFINITY)
    }

    fn width(&self) -> f64 {
        self.std
    }

    fn anchor(&self, low: f64, high: f64) -> f64 {
        self.mean.clamp(low, high)
    }

    /// -(z^2 - z_m^2)/2 = -e (z_m + e/2), e = (x - m)/std
    fn ln_ratio(&self, place: &Place) -> f64 {
        let change = place.from_anchor / self.std;
        -change * (place.anchor_at(self.mean) / self.std + 0.5 * change)
    }

    fn symmetry(&self, low: f64, high: f64) -> Option<f64> {
        centred(low, self.mean, high).then_some(self.mean)
    }
}

/// Phi(z). The library's erfc keeps ten digits, its inverse all of them, so one Newton step through the inverse
/// corrects the value.
fn standard_cdf(z: f64) -> f64 {
    let p = 0.5 * erfc(-z / SQRT_2);
    let correction = (z - standard_inverse_cdf(p)) * (-0.5 * z * z).exp() / (2.0 * PI).sqrt();
    // Far in the tails the inverse is infinite and there is nothing left to correct.
    if correction.is_finite() {
        (p + correction).clamp(0.0, 1.0)
    } else {
        p
    }
}

fn standard_inverse_cdf(p: f64) -> f64 {
    -SQRT_2 * erfc_inv(2.0 * p)
}
