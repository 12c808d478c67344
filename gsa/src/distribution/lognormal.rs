//! Lognormal law, given by mean and standard deviation of ln x; rule: Gauss-Hermite in ln x.

use super::normal::{standard_cdf, standard_inverse_cdf};
use super::{DistributionError, Law, finite, positive};
use crate::recurrence::Recurrence;

/// ln x is normal with mean mu and standard deviation sigma; x > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lognormal {
    mu: f64,
    sigma: f64,
}

impl Lognormal {
    pub(super) fn new(mu: f64, sigma: f64) -> Result<Self, DistributionError> {
        finite("mu", mu)?;
        positive("sigma", sigma)?;
        let law = Self { mu, sigma };
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

    fn cdf(&self, x: f64) -> f64 {
        if x > 0.0 {
            standard_cdf((x.ln() - self.mu) / self.sigma)
        } else {
            0.0
        }
    }

    fn inverse_cdf(&self, p: f64) -> f64 {
        self.place(standard_inverse_cdf(p))
    }

    fn recurrence(&self, size: usize) -> Recurrence {
        Recurrence::hermite(size)
    }

    fn place(&self, t: f64) -> f64 {
        (self.mu + t * self.sigma).exp()
    }
}
