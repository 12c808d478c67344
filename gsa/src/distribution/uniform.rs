//! Uniform law on \[min, max\]; rule: Gauss-Legendre.

use super::{DistributionError, Law, finite};
use crate::recurrence::Recurrence;

/// Density 1 / (max - min) between the two bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uniform {
    min: f64,
    max: f64,
}

impl Uniform {
    pub(super) fn new(min: f64, max: f64) -> Result<Self, DistributionError> {
        finite("min", min)?;
        finite("max", max)?;
        if min >= max {
            return Err(DistributionError::EmptyRange { min, max });
        }
        if !(max - min).is_finite() {
            return Err(DistributionError::MomentOutOfRange { kind: "uniform" });
        }
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

    fn cdf(&self, x: f64) -> f64 {
        ((x - self.min) / (self.max - self.min)).clamp(0.0, 1.0)
    }

    fn inverse_cdf(&self, p: f64) -> f64 {
        // Measured from the nearer end, so that both ends come out exactly.
        let width = self.max - self.min;
        if p < 0.5 {
            self.min + p * width
        } else {
            self.max - (1.0 - p) * width
        }
    }

    fn recurrence(&self, size: usize) -> Recurrence {
        Recurrence::legendre(size)
    }

    fn place(&self, t: f64) -> f64 {
        self.mean() + t * self.half_width()
    }
}
