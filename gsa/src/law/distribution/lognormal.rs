//! Lognormal law, given by mean and standard deviation of ln x; rule: Gauss-Hermite in ln x.

use super::law_contract::{Law, Scale};
use super::normal::Normal;
use crate::law::basis::Basis;
use crate::law::density::Density;
use crate::law::distribution::distribution_error::{DistributionError, finite, positive};

/// ln x is normal with mean mu and standard deviation sigma; x > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lognormal {
    mu: f64,
    sigma: f64,
    logarithm: Normal,
}

impl Lognormal {
    pub(super) fn new(mu: f64, sigma: f64) -> Result<Self, DistributionError> {
        finite("mu", mu)?;
        positive("sigma", sigma)?;
        let law = Self {
            mu,
            sigma,
            logarithm: Normal::new(mu, sigma)?,
        };
        if law.mean().is_normal() && law.std().is_normal() {
            Ok(law)
        } else {
            Err(DistributionError::MomentOutOfRange { kind: "lognormal" })
        }
    }
}

impl Law for Lognormal {
    fn kind(&self) -> &'static str {
        "lognormal"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![("mu", self.mu), ("sigma", self.sigma)]
    }

    /// exp(mu + sigma^2 / 2)
    fn mean(&self) -> f64 {
        (self.mu + 0.5 * self.sigma * self.sigma).exp()
    }

    /// mean sqrt(exp(sigma^2) - 1)
    fn std(&self) -> f64 {
        self.mean() * (self.sigma * self.sigma).exp_m1().sqrt()
    }

    fn probabilities(&self, y: f64) -> (f64, f64) {
        self.logarithm.probabilities(y)
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        self.logarithm.quantile(p, q)
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        self.logarithm.basis(size)
    }

    fn density(&self) -> &dyn Density {
        &self.logarithm
    }

    fn scale(&self) -> Scale {
        Scale::Logarithmic
    }
}
