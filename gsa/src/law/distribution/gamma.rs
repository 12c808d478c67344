//! Gamma law; rule: generalised Gauss-Laguerre.

use super::law_contract::Law;
use crate::law::basis::{Basis, crowds};
use crate::law::density::{Density, Place, power};
use crate::law::distribution::distribution_error::{
    DistributionError, in_range, positive, shape as check_shape,
};
use crate::law::probability::Integrated;
use crate::law::recurrence::Recurrence;

/// Density x^(shape - 1) exp(-x/scale), x >= 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gamma {
    shape: f64,
    scale: f64,
}

impl Gamma {
    pub(super) fn new(shape: f64, scale: f64) -> Result<Self, DistributionError> {
        check_shape("shape", shape)?;
        positive("scale", scale)?;
        let law = Self { shape, scale };
        in_range("gamma", law.mean(), law.std())?;
        Ok(law)
    }

    fn integrated(&self) -> Integrated<'_> {
        Integrated {
            density: self,
            low: 0.0,
            high: f64::INFINITY,
        }
    }
}

/// Polynomials of the gamma law: folded, b_{2j-1} = j - 1 + shape and b_2j = j; or about the mean in standard
/// deviations, a_j = 2j/sqrt(shape) and b_j = j (j - 1 + shape)/shape, where the law is nearly normal.
pub(super) fn laguerre(shape: f64, scale: f64, size: usize) -> Basis {
    let root = shape.sqrt();
    if crowds(shape, root) {
        let b = |k: f64| 0.5 * k + if k % 2.0 == 1.0 { shape - 0.5 } else { 0.0 };
        Basis::folded(Recurrence::symmetric(2 * size, b), 0.0, scale)
    } else {
        let recurrence =
            Recurrence::general(size, |j| 2.0 * j / root, |j| j * ((j - 1.0) / shape + 1.0));
        Basis::plain(recurrence, shape * scale, root * scale)
    }
}

impl Law for Gamma {
    fn kind(&self) -> &'static str {
        "gamma"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![("shape", self.shape), ("scale", self.scale)]
    }

    /// shape scale
    fn mean(&self) -> f64 {
        self.shape * self.scale
    }

    /// sqrt(shape) scale
    fn std(&self) -> f64 {
        self.shape.sqrt() * self.scale
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        self.integrated().probabilities(x)
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        self.integrated().quantile(p, q)
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        Some(laguerre(self.shape, self.scale, size))
    }

    fn density(&self) -> &dyn Density {
        self
    }

    fn has_closed_probabilities(&self) -> bool {
        false
    }
}

impl Density for Gamma {
    fn support(&self) -> (f64, f64) {
        (0.0, f64::INFINITY)
    }

    fn width(&self) -> f64 {
        self.std()
    }

    /// The mode, or the mean where the density is infinite at zero.
    fn anchor(&self, low: f64, high: f64) -> f64 {
        let peak = if self.shape > 1.0 {
            (self.shape - 1.0) * self.scale
        } else {
            self.mean()
        };
        peak.clamp(low, high)
    }

    fn ln_ratio(&self, place: &Place) -> f64 {
        power(self.shape - 1.0, place.ln_start_ratio()) - place.from_anchor / self.scale
    }
}
