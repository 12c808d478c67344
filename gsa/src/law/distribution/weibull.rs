//! Weibull law; its polynomials have no closed recurrence and are computed from a discretisation.

use super::law_contract::Law;
use crate::law::basis::Basis;
use crate::law::density::{Density, Place, power};
use crate::law::discretisation;
use crate::law::distribution::distribution_error::{
    DistributionError, in_range, positive, shape as check_shape,
};
use crate::law::panel::Restricted;

/// Density E^(1 - 1/shape) exp(-E) shape/scale with E = (x/scale)^shape, x >= 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Weibull {
    shape: f64,
    scale: f64,
    mean: f64,
    std: f64,
}

impl Weibull {
    pub(super) fn new(shape: f64, scale: f64) -> Result<Self, DistributionError> {
        check_shape("shape", shape)?;
        positive("scale", scale)?;
        let mut law = Self {
            shape,
            scale,
            mean: scale,
            std: scale,
        };
        let anchor = law.anchor(0.0, f64::INFINITY);
        let whole = Restricted {
            density: &law,
            low: 0.0,
            high: f64::INFINITY,
            anchor,
        };
        // Integrated, not mean = scale Gamma(1 + 1/shape): the variance by gamma functions cancels at large shapes.
        let moments = discretisation::moments(whole, 2.0, |d| (anchor + d) / scale);
        let (mean, std) = moments.unwrap_or((f64::NAN, f64::NAN));
        (law.mean, law.std) = (mean * scale, std * scale);
        in_range("weibull", law.mean, law.std)?;
        Ok(law)
    }
}

impl Law for Weibull {
    fn kind(&self) -> &'static str {
        "weibull"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![("shape", self.shape), ("scale", self.scale)]
    }

    /// scale Gamma(1 + 1/shape)
    fn mean(&self) -> f64 {
        self.mean
    }

    /// scale sqrt(Gamma(1 + 2/shape) - Gamma(1 + 1/shape)^2)
    fn std(&self) -> f64 {
        self.std
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        let e = (x.max(0.0) / self.scale).powf(self.shape);
        (-(-e).exp_m1(), (-e).exp())
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        let e = if p < 0.5 { -(-p).ln_1p() } else { -q.ln() };
        self.scale * e.powf(1.0 / self.shape)
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        discretisation::basis(self, 0.0, f64::INFINITY, size)
    }

    fn density(&self) -> &dyn Density {
        self
    }
}

impl Density for Weibull {
    fn support(&self) -> (f64, f64) {
        (0.0, f64::INFINITY)
    }

    fn width(&self) -> f64 {
        self.scale / self.shape.max(1.0)
    }

    /// The mode, or the scale where the density is infinite (or has its peak) at zero.
    fn anchor(&self, low: f64, high: f64) -> f64 {
        let peak = if self.shape > 1.0 {
            self.scale * (1.0 - 1.0 / self.shape).powf(1.0 / self.shape)
        } else {
            self.scale
        };
        peak.clamp(low, high)
    }

    /// (shape - 1) r - E_m (exp(shape r) - 1), r = ln(x/m)
    fn ln_ratio(&self, place: &Place) -> f64 {
        let r = place.ln_start_ratio();
        let e = (place.anchor_at(0.0) / self.scale).powf(self.shape);
        power(self.shape - 1.0, r) - e * (self.shape * r).exp_m1()
    }
}
