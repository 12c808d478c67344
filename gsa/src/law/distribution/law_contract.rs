//! Contract of the laws. A law lives in its own coordinate y, which is x or, on a logarithmic scale, ln x.

use crate::law::basis::Basis;
use crate::law::density::Density;

/// A law before any truncation.
pub(super) trait Law {
    fn kind(&self) -> &'static str;
    fn parameters(&self) -> Vec<(&'static str, f64)>;
    /// mean of x
    fn mean(&self) -> f64;
    /// standard deviation of x
    fn std(&self) -> f64;
    /// P(Y <= y) and P(Y > y), each with its own digits
    fn probabilities(&self, y: f64) -> (f64, f64);
    /// The y with P(Y <= y) = p = 1 - q; at p = 0 and q = 0 the ends of the support.
    fn quantile(&self, p: f64, q: f64) -> f64;
    /// Orthogonal polynomials of y; `None` if they cannot be computed.
    fn basis(&self, size: usize) -> Option<Basis>;
    /// Density of y.
    fn density(&self) -> &dyn Density;
    fn scale(&self) -> Scale {
        Scale::Linear
    }
    /// Whether probabilities and quantiles cost no integration.
    fn has_closed_probabilities(&self) -> bool {
        true
    }
}

/// Scale of a law's coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Scale {
    Linear,
    Logarithmic,
}

impl Scale {
    /// y to x
    pub(super) fn place(self, y: f64) -> f64 {
        match self {
            Self::Linear => y,
            Self::Logarithmic => y.exp(),
        }
    }

    /// x to y
    pub(super) fn coordinate(self, x: f64) -> f64 {
        match self {
            Self::Linear => x,
            Self::Logarithmic => x.max(0.0).ln(),
        }
    }
}
