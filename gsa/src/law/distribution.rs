//! Laws of the uncertain inputs. Inputs are independent; units are the input's own.
//!
//! | kind | density, up to a factor | parameters | polynomials, exact in |
//! |---|---|---|---|
//! | `uniform` | 1 | bounds min < max | Legendre, x |
//! | `normal` | exp(-z^2/2), z = (x - mean)/std | mean, std > 0 in the input's unit | Hermite, x |
//! | `lognormal` | exp(-z^2/2)/x, z = (ln x - mu)/sigma | mu, sigma > 0 of ln x, no unit | Hermite, ln x |
//! | `exponential` | exp(-rate x), x >= 0 | rate > 0, one over the unit | Laguerre, x |
//! | `gamma` | x^(shape-1) exp(-x/scale), x >= 0 | shape > 0, no unit; scale > 0 | generalised Laguerre, x |
//! | `weibull` | x^(shape-1) exp(-(x/scale)^shape), x >= 0 | shape > 0, no unit; scale > 0 | Stieltjes, x |
//! | `beta` | (x-min)^(alpha-1) (max-x)^(beta-1) | alpha, beta > 0, no unit; bounds min < max | Jacobi, x |
//! | `gumbel` | exp(-z - exp(-z)), z = (x - location)/scale | location; scale > 0 | Stieltjes, x |
//! | `triangular` | straight up from min to mode, straight down to max | min <= mode <= max | Stieltjes, x |
//! | any, truncated | the law's own between low and high, 0 elsewhere | low < high in the unit of x | Stieltjes, as before |
//!
//! A law that exists is valid: fields are private, and the constructors refuse what has no mean, no
//! spread, or moments beyond double precision. A new law is a file here, a variant, an entry in
//! [`KINDS`](crate::law::catalogue::KINDS), and lines in the shared checks of `gsa/tests`.

mod beta;
mod exponential;
mod gamma;
mod gumbel;
mod lognormal;
mod normal;
mod triangular;
mod uniform;
mod weibull;

pub(super) mod distribution_error;
mod law_contract;
mod truncation;

use crate::law::rule::{GaussRule, RuleError};
pub use distribution_error::DistributionError;
use law_contract::Law;
use truncation::Truncation;

/// The law of one input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution {
    family: Family,
    truncation: Option<Truncation>,
}

/// A law before any truncation.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Family {
    Uniform(uniform::Uniform),
    Normal(normal::Normal),
    Lognormal(lognormal::Lognormal),
    Exponential(exponential::Exponential),
    Gamma(gamma::Gamma),
    Weibull(weibull::Weibull),
    Beta(beta::Beta),
    Gumbel(gumbel::Gumbel),
    Triangular(triangular::Triangular),
}

impl Distribution {
    /// Uniform on \[min, max\], both finite and min < max.
    pub fn uniform(min: f64, max: f64) -> Result<Self, DistributionError> {
        uniform::Uniform::new(min, max).map(|law| Family::Uniform(law).into())
    }

    /// Normal with a finite mean and std > 0, in the units of the input.
    pub fn normal(mean: f64, std: f64) -> Result<Self, DistributionError> {
        normal::Normal::new(mean, std).map(|law| Family::Normal(law).into())
    }

    /// Lognormal: ln x has mean mu and standard deviation sigma > 0.
    pub fn lognormal(mu: f64, sigma: f64) -> Result<Self, DistributionError> {
        lognormal::Lognormal::new(mu, sigma).map(|law| Family::Lognormal(law).into())
    }

    /// Exponential with mean 1/rate, rate > 0.
    pub fn exponential(rate: f64) -> Result<Self, DistributionError> {
        exponential::Exponential::new(rate).map(|law| Family::Exponential(law).into())
    }

    /// Gamma with mean shape times scale, both > 0.
    pub fn gamma(shape: f64, scale: f64) -> Result<Self, DistributionError> {
        gamma::Gamma::new(shape, scale).map(|law| Family::Gamma(law).into())
    }

    /// Weibull: P(X > x) = exp(-(x/scale)^shape), both > 0.
    pub fn weibull(shape: f64, scale: f64) -> Result<Self, DistributionError> {
        weibull::Weibull::new(shape, scale).map(|law| Family::Weibull(law).into())
    }

    /// Beta with alpha, beta > 0, stretched to \[min, max\].
    pub fn beta(alpha: f64, beta: f64, min: f64, max: f64) -> Result<Self, DistributionError> {
        beta::Beta::new(alpha, beta, min, max).map(|law| Family::Beta(law).into())
    }

    /// Gumbel, the law of largest values: P(X <= x) = exp(-exp(-(x - location)/scale)), scale > 0.
    pub fn gumbel(location: f64, scale: f64) -> Result<Self, DistributionError> {
        gumbel::Gumbel::new(location, scale).map(|law| Family::Gumbel(law).into())
    }

    /// Triangular on \[min, max\] with its peak at mode.
    pub fn triangular(min: f64, mode: f64, max: f64) -> Result<Self, DistributionError> {
        triangular::Triangular::new(min, mode, max).map(|law| Family::Triangular(law).into())
    }

    /// The law under the condition that low <= X <= high, both finite, in the units of the input. Bounds beyond the
    /// law's own ends cut nothing.
    ///
    /// # Errors
    /// Bounds not finite or not in order, nothing of the law between them, or a law truncated before.
    pub fn truncated(self, low: f64, high: f64) -> Result<Self, DistributionError> {
        if self.truncation.is_some() {
            return Err(DistributionError::TruncatedTwice);
        }
        let truncation = Truncation::new(self.law(), low, high)?;
        Ok(Self {
            truncation: Some(truncation),
            ..self
        })
    }

    /// The bounds given to [`Distribution::truncated`].
    pub fn truncation(&self) -> Option<(f64, f64)> {
        self.truncation.map(|truncation| truncation.given())
    }

    /// E\[X\]
    pub fn mean(&self) -> f64 {
        self.truncation
            .map_or_else(|| self.law().mean(), |cut| cut.mean())
    }

    /// Standard deviation of X.
    pub fn std(&self) -> f64 {
        self.truncation
            .map_or_else(|| self.law().std(), |cut| cut.std())
    }

    /// P(X <= x), with full relative accuracy where it is small.
    pub fn cdf(&self, x: f64) -> f64 {
        self.probabilities(x).0
    }

    /// P(X > x), with full relative accuracy where it is small.
    pub fn survival(&self, x: f64) -> f64 {
        self.probabilities(x).1
    }

    /// The x with P(X <= x) = p. At p = 0 and 1 these are the ends of the support, infinite where the law's are.
    ///
    /// # Panics
    /// If p is not in \[0, 1\].
    pub fn inverse_cdf(&self, p: f64) -> f64 {
        self.quantile(probability(p), 1.0 - p)
    }

    /// The x with P(X > x) = q: an upper quantile as accurate as a lower one.
    ///
    /// # Panics
    /// If q is not in \[0, 1\].
    pub fn inverse_survival(&self, q: f64) -> f64 {
        self.quantile(1.0 - q, probability(q))
    }

    /// Gauss rule of this law, 1 to [`crate::law::rule::MAX_NODES`] nodes.
    ///
    /// # Errors
    /// A size out of range, or a law too wide or too narrow for its nodes or weights to be told apart in double
    /// precision.
    pub fn gauss_rule(&self, nodes: usize) -> Result<GaussRule, RuleError> {
        let law = self.law();
        let (low, high) = self.support();
        GaussRule::new(
            nodes,
            |size| match &self.truncation {
                Some(cut) => cut.basis(law, size),
                None => law.basis(size),
            },
            // The outermost nodes of a law on an interval may round to just outside of it.
            |y| law.scale().place(y).clamp(low, high),
        )
    }

    /// The ends of the law, possibly infinite.
    pub fn support(&self) -> (f64, f64) {
        (self.quantile(0.0, 1.0), self.quantile(1.0, 0.0))
    }

    /// Name of the law as documents spell it, one of [`KINDS`](crate::law::catalogue::KINDS).
    pub fn kind(&self) -> &'static str {
        self.law().kind()
    }

    /// Parameters by name, in the order of the constructor; bounds of a truncation are not among them.
    pub fn parameters(&self) -> Vec<(&'static str, f64)> {
        self.law().parameters()
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        let law = self.law();
        let y = law.scale().coordinate(x);
        match &self.truncation {
            Some(cut) => cut.probabilities(law, y),
            None => law.probabilities(y),
        }
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        let law = self.law();
        match &self.truncation {
            Some(cut) => cut.quantile(law, p, q),
            None => law.scale().place(law.quantile(p, q)),
        }
    }

    fn law(&self) -> &dyn Law {
        match &self.family {
            Family::Uniform(law) => law,
            Family::Normal(law) => law,
            Family::Lognormal(law) => law,
            Family::Exponential(law) => law,
            Family::Gamma(law) => law,
            Family::Weibull(law) => law,
            Family::Beta(law) => law,
            Family::Gumbel(law) => law,
            Family::Triangular(law) => law,
        }
    }
}

impl From<Family> for Distribution {
    fn from(family: Family) -> Self {
        Self {
            family,
            truncation: None,
        }
    }
}

fn probability(p: f64) -> f64 {
    assert!(
        (0.0..=1.0).contains(&p),
        "a probability lies in [0, 1], not at {p}"
    );
    p
}
