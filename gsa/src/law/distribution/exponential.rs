//! Exponential law; rule: Gauss-Laguerre.

use super::gamma::laguerre;
use super::law_contract::Law;
use crate::law::basis::Basis;
use crate::law::density::{Density, Place};
use crate::law::distribution::distribution_error::{DistributionError, in_range, positive};

/// Density rate exp(-rate x), x >= 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Exponential {
    rate: f64,
}

impl Exponential {
    pub(super) fn new(rate: f64) -> Result<Self, DistributionError> {
        positive("rate", rate)?;
        in_range("exponential", 1.0 / rate, 1.0 / rate)?;
        Ok(Self { rate })
    }
}

impl Law for Exponential {
    fn kind(&self) -> &'static str {
        "exponential"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![("rate", self.rate)]
    }

    /// 1 / rate
    fn mean(&self) -> f64 {
        1.0 / self.rate
    }

    /// 1 / rate
    fn std(&self) -> f64 {
        1.0 / self.rate
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        let e = self.rate * x.max(0.0);
        (-(-e).exp_m1(), (-e).exp())
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        (if p < 0.5 { -(-p).ln_1p() } else { -q.ln() }) / self.rate
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        Some(laguerre(1.0, 1.0 / self.rate, size))
    }

    fn density(&self) -> &dyn Density {
        self
    }
}

impl Density for Exponential {
    fn support(&self) -> (f64, f64) {
        (0.0, f64::INFINITY)
    }

    fn width(&self) -> f64 {
        1.0 / self.rate
    }

    fn anchor(&self, low: f64, _high: f64) -> f64 {
        low
    }

    fn ln_ratio(&self, place: &Place) -> f64 {
        -self.rate * place.from_anchor
    }
}
