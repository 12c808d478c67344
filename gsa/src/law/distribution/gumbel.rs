//! Gumbel law of largest values; its polynomials are computed from a discretisation.

use std::f64::consts::PI;

use super::law_contract::Law;
use crate::law::basis::Basis;
use crate::law::density::{Density, Place};
use crate::law::discretisation;
use crate::law::distribution::distribution_error::{DistributionError, finite, in_range, positive};

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

/// Distribution function exp(-exp(-z)) with z = (x - location) / scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gumbel {
    location: f64,
    scale: f64,
}

impl Gumbel {
    pub(super) fn new(location: f64, scale: f64) -> Result<Self, DistributionError> {
        finite("location", location)?;
        positive("scale", scale)?;
        let law = Self { location, scale };
        in_range("gumbel", law.mean(), law.std())?;
        Ok(law)
    }
}

impl Law for Gumbel {
    fn kind(&self) -> &'static str {
        "gumbel"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![("location", self.location), ("scale", self.scale)]
    }

    /// location + 0.5772.. scale
    fn mean(&self) -> f64 {
        self.location + EULER * self.scale
    }

    /// pi scale / sqrt(6)
    fn std(&self) -> f64 {
        PI * self.scale / 6f64.sqrt()
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        let e = (-(x - self.location) / self.scale).exp();
        ((-e).exp(), -(-e).exp_m1())
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        let e = if p < 0.5 { -p.ln() } else { -(-q).ln_1p() };
        self.location - self.scale * e.ln()
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        discretisation::basis(self, f64::NEG_INFINITY, f64::INFINITY, size)
    }

    fn density(&self) -> &dyn Density {
        self
    }
}

impl Density for Gumbel {
    fn support(&self) -> (f64, f64) {
        (f64::NEG_INFINITY, f64::INFINITY)
    }

    fn width(&self) -> f64 {
        self.scale
    }

    fn anchor(&self, low: f64, high: f64) -> f64 {
        self.location.clamp(low, high)
    }

    /// -e - exp(-z_m) (exp(-e) - 1), e = (x - m)/scale
    fn ln_ratio(&self, place: &Place) -> f64 {
        let change = place.from_anchor / self.scale;
        let z = place.anchor_at(self.location) / self.scale;
        -change - (-z).exp() * (-change).exp_m1()
    }
}
