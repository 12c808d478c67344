//! Uniform law on \[min, max\]; rule: Gauss-Legendre.

use super::law_contract::Law;
use crate::law::basis::Basis;
use crate::law::density::{Density, Place};
use crate::law::distribution::distribution_error::{DistributionError, range};
use crate::law::recurrence::Recurrence;

/// Density 1 / (max - min) between the two bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Uniform {
    min: f64,
    max: f64,
}

impl Uniform {
    pub(super) fn new(min: f64, max: f64) -> Result<Self, DistributionError> {
        range("uniform", min, max)?;
        Ok(Self { min, max })
    }

    fn half_width(&self) -> f64 {
        0.5 * (self.max - self.min)
    }
}

impl Law for Uniform {
    fn kind(&self) -> &'static str {
        "uniform"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![("min", self.min), ("max", self.max)]
    }

    /// (min + max) / 2
    fn mean(&self) -> f64 {
        self.min.midpoint(self.max)
    }

    /// (max - min) / sqrt(12)
    fn std(&self) -> f64 {
        self.half_width() / 3f64.sqrt()
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        let width = self.max - self.min;
        let share = |distance: f64| (distance / width).clamp(0.0, 1.0);
        (share(x - self.min), share(self.max - x))
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        // Measured from the nearer end, so that both ends come out exactly.
        let width = self.max - self.min;
        if p < 0.5 {
            self.min + p * width
        } else {
            self.max - q * width
        }
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        Some(Basis::plain(
            Recurrence::legendre(size),
            self.mean(),
            self.half_width(),
        ))
    }

    fn density(&self) -> &dyn Density {
        self
    }
}

impl Density for Uniform {
    fn support(&self) -> (f64, f64) {
        (self.min, self.max)
    }

    fn width(&self) -> f64 {
        self.max - self.min
    }

    fn anchor(&self, low: f64, high: f64) -> f64 {
        low.midpoint(high)
    }

    fn ln_ratio(&self, _place: &Place) -> f64 {
        0.0
    }

    fn symmetry(&self, low: f64, high: f64) -> Option<f64> {
        Some(low.midpoint(high))
    }
}
