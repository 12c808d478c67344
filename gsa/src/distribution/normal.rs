//! Normal law of a mean and a standard deviation; rule: Gauss-Hermite.

use std::f64::consts::{PI, SQRT_2};

use statrs::function::erf::{erfc, erfc_inv};

use super::{DistributionError, Law, finite, positive};
use crate::recurrence::Recurrence;

/// Density exp(-z^2/2) / (std sqrt(2 pi)) with z = (x - mean) / std.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Normal {
    mean: f64,
    std: f64,
}

impl Normal {
    pub(super) fn new(mean: f64, std: f64) -> Result<Self, DistributionError> {
        finite("mean", mean)?;
        positive("std", std)?;
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

    fn cdf(&self, x: f64) -> f64 {
        standard_cdf((x - self.mean) / self.std)
    }

    fn inverse_cdf(&self, p: f64) -> f64 {
        self.place(standard_inverse_cdf(p))
    }

    fn recurrence(&self, size: usize) -> Recurrence {
        Recurrence::hermite(size)
    }

    fn place(&self, t: f64) -> f64 {
        self.mean + t * self.std
    }
}

/// Phi(z). The library's erfc keeps ten digits, its inverse all of them, so one Newton step through the inverse
/// corrects the value.
pub(super) fn standard_cdf(z: f64) -> f64 {
    let p = 0.5 * erfc(-z / SQRT_2);
    let correction = (z - standard_inverse_cdf(p)) * (-0.5 * z * z).exp() / (2.0 * PI).sqrt();
    // Far in the tails the inverse is infinite and there is nothing left to correct.
    if correction.is_finite() {
        (p + correction).clamp(0.0, 1.0)
    } else {
        p
    }
}

pub(super) fn standard_inverse_cdf(p: f64) -> f64 {
    -SQRT_2 * erfc_inv(2.0 * p)
}
