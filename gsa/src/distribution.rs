//! Laws of the uncertain inputs. Inputs are independent; units are the input's own.
//!
//! A law that exists is valid: the variants' fields are private, and the constructors refuse what has no mean, no
//! spread, or moments beyond double precision. A new law is a file here, a variant, and a line in the shared check
//! of the tests.

mod lognormal;
mod normal;
mod uniform;

use thiserror::Error;

use crate::recurrence::Recurrence;
use crate::rule::{GaussRule, RuleError};
pub use lognormal::Lognormal;
pub use normal::Normal;
pub use uniform::Uniform;

/// Why a law cannot be built.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DistributionError {
    /// A parameter is NaN or infinite.
    #[error("{parameter} must be a finite number, not {value}")]
    NotFinite {
        /// name as in [`Distribution::parameters`]
        parameter: &'static str,
        /// what was given
        value: f64,
    },
    /// A scale parameter is zero or negative.
    #[error("{parameter} must be greater than zero, not {value}")]
    NotPositive {
        /// name as in [`Distribution::parameters`]
        parameter: &'static str,
        /// what was given
        value: f64,
    },
    /// The bounds of a range are equal or swapped.
    #[error("min must be less than max, not {min} and {max}")]
    EmptyRange {
        /// lower bound given
        min: f64,
        /// upper bound given
        max: f64,
    },
    /// Mean or standard deviation over- or underflow.
    #[error(
        "the mean or the standard deviation of this {kind} law is beyond the range of double precision"
    )]
    MomentOutOfRange {
        /// as in [`Distribution::kind`]
        kind: &'static str,
    },
}

/// The law of one input.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Distribution {
    /// equally likely between two bounds
    Uniform(Uniform),
    /// mean and standard deviation
    Normal(Normal),
    /// its logarithm is normal
    Lognormal(Lognormal),
}

/// What every law provides; the enum forwards to it.
trait Law {
    fn kind(&self) -> &'static str;
    fn parameters(&self) -> Vec<(&'static str, f64)>;
    fn mean(&self) -> f64;
    fn std(&self) -> f64;
    fn cdf(&self, x: f64) -> f64;
    fn inverse_cdf(&self, p: f64) -> f64;
    /// Polynomials orthonormal for the standard law.
    fn recurrence(&self, size: usize) -> Recurrence;
    /// Carries a node of the standard law to the units of the input.
    fn place(&self, t: f64) -> f64;
}

impl Distribution {
    /// Uniform on \[min, max\], both finite and min < max.
    pub fn uniform(min: f64, max: f64) -> Result<Self, DistributionError> {
        Uniform::new(min, max).map(Self::Uniform)
    }

    /// Normal with a finite mean and std > 0, in the units of the input.
    pub fn normal(mean: f64, std: f64) -> Result<Self, DistributionError> {
        Normal::new(mean, std).map(Self::Normal)
    }

    /// Lognormal: ln x has mean mu and standard deviation sigma > 0.
    pub fn lognormal(mu: f64, sigma: f64) -> Result<Self, DistributionError> {
        Lognormal::new(mu, sigma).map(Self::Lognormal)
    }

    /// E\[X\]
    pub fn mean(&self) -> f64 {
        self.law().mean()
    }

    /// Standard deviation of X.
    pub fn std(&self) -> f64 {
        self.law().std()
    }

    /// P(X <= x)
    pub fn cdf(&self, x: f64) -> f64 {
        self.law().cdf(x)
    }

    /// The x with P(X <= x) = p. At p = 0 and 1 these are the ends of the support, infinite where the law's are.
    ///
    /// # Panics
    /// If p is not in \[0, 1\].
    pub fn inverse_cdf(&self, p: f64) -> f64 {
        assert!(
            (0.0..=1.0).contains(&p),
            "a probability lies in [0, 1], not at {p}"
        );
        self.law().inverse_cdf(p)
    }

    /// Gauss rule of this law, 1 to [`crate::rule::MAX_NODES`] nodes.
    ///
    /// # Errors
    /// A size out of range, or a law too wide or too narrow for its nodes to be told apart in double precision.
    pub fn gauss_rule(&self, nodes: usize) -> Result<GaussRule, RuleError> {
        let law = self.law();
        GaussRule::new(nodes, |size| law.recurrence(size), |t| law.place(t))
    }

    /// Name of the law as documents spell it: `uniform`, `normal`, `lognormal`.
    pub fn kind(&self) -> &'static str {
        self.law().kind()
    }

    /// Parameters by name, in the order of the constructor.
    pub fn parameters(&self) -> Vec<(&'static str, f64)> {
        self.law().parameters()
    }

    fn law(&self) -> &dyn Law {
        match self {
            Self::Uniform(law) => law,
            Self::Normal(law) => law,
            Self::Lognormal(law) => law,
        }
    }
}

fn finite(parameter: &'static str, value: f64) -> Result<(), DistributionError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(DistributionError::NotFinite { parameter, value })
    }
}

fn positive(parameter: &'static str, value: f64) -> Result<(), DistributionError> {
    finite(parameter, value)?;
    if value > 0.0 {
        Ok(())
    } else {
        Err(DistributionError::NotPositive { parameter, value })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What holds for every law.
    fn check_distribution(law: Distribution) {
        for k in 1..1000 {
            let p = f64::from(k) / 1000.0;
            let x = law.inverse_cdf(p);
            // The cdf has a few eps; narrow laws far from zero lose eps mean/std in x.
            assert!(
                (law.cdf(x) - p).abs() < 1e-13,
                "{law:?} p = {p} {:e}",
                law.cdf(x) - p
            );
        }
        assert!(law.cdf(law.mean()) > 0.0 && law.cdf(law.mean()) < 1.0);
        let rule = law.gauss_rule(20).unwrap();
        let moment = |f: &dyn Fn(f64) -> f64| -> f64 {
            rule.nodes
                .iter()
                .zip(&rule.weights)
                .map(|(&x, w)| w * f(x))
                .sum()
        };
        let mean = moment(&|x| x);
        let variance = moment(&|x| (x - law.mean()) * (x - law.mean()));
        // 20 Hermite nodes integrate exp(2 sigma t), sigma <= 1, to 1e-12 (remainder (2 sigma)^40 / 40! * 20!)
        assert!(
            (mean - law.mean()).abs() <= 1e-12 * (law.mean().abs() + law.std()),
            "{law:?}"
        );
        assert!(
            (variance.sqrt() - law.std()).abs() <= 1e-10 * law.std(),
            "{law:?}"
        );
        assert!(
            rule.nodes
                .iter()
                .all(|&x| x >= law.inverse_cdf(0.0) && x <= law.inverse_cdf(1.0))
        );
    }

    #[test]
    fn every_law_keeps_the_contract() {
        check_distribution(Distribution::uniform(0.7, 1.3).unwrap());
        check_distribution(Distribution::uniform(-5e150, 2e151).unwrap());
        check_distribution(Distribution::normal(0.0, 1.0).unwrap());
        check_distribution(Distribution::normal(-3.0, 0.02).unwrap());
        check_distribution(Distribution::lognormal(7.71, 1.0056).unwrap());
        check_distribution(Distribution::lognormal(-2.0, 0.1).unwrap());
    }

    #[test]
    fn middle_node_is_the_mean_to_the_bit() {
        for law in [
            Distribution::uniform(0.7, 1.3).unwrap(),
            Distribution::uniform(0.1, 0.30000000000000004).unwrap(),
            Distribution::normal(0.1, 0.3).unwrap(),
        ] {
            for nodes in (1..=63).step_by(2) {
                assert_eq!(
                    law.gauss_rule(nodes).unwrap().nodes[nodes / 2].to_bits(),
                    law.mean().to_bits()
                );
            }
        }
    }

    #[test]
    fn quantiles_match_tables() {
        let normal = Distribution::normal(0.0, 1.0).unwrap();
        // 30-digit values of sqrt(2) erfinv(2p - 1)
        let table = [
            (1e-09, -5.9978070150076865),
            (0.003, -2.7477813854449926),
            (0.023, -1.9953933101678247),
            (0.1, -1.2815515655446004),
            (0.4, -0.2533471031357997),
            (0.975, 1.9599639845400538),
        ];
        for (p, z) in table {
            assert!(
                (normal.inverse_cdf(p) - z).abs() < 1e-14 * z.abs(),
                "{p} {z} {}",
                normal.inverse_cdf(p)
            );
        }
        // 30-digit values of Phi(z)
        let table = [
            (-6.0, 9.86587645037698e-10),
            (-2.0, 0.02275013194817921),
            (-0.5, 0.3085375387259869),
            (0.25, 0.5987063256829237),
            (3.0, 0.9986501019683699),
        ];
        for (z, p) in table {
            // The density turns an eps of z into z^2 eps of a small p.
            assert!(
                (normal.cdf(z) - p).abs() < 1e-14 * p,
                "{z} {p} {}",
                normal.cdf(z)
            );
        }
        assert_eq!((normal.cdf(-400.0), normal.cdf(400.0)), (0.0, 1.0));
        let uniform = Distribution::uniform(-1.0, 3.0).unwrap();
        assert_eq!(
            (uniform.inverse_cdf(0.0), uniform.inverse_cdf(1.0)),
            (-1.0, 3.0)
        );
        assert_eq!((uniform.cdf(-9.0), uniform.cdf(9.0)), (0.0, 1.0));
    }

    #[test]
    fn invalid_laws_cannot_be_built() {
        use DistributionError::*;
        assert_eq!(
            Distribution::uniform(1.0, 1.0),
            Err(EmptyRange { min: 1.0, max: 1.0 })
        );
        assert_eq!(
            Distribution::uniform(2.0, 1.0),
            Err(EmptyRange { min: 2.0, max: 1.0 })
        );
        assert!(matches!(
            Distribution::uniform(f64::NAN, 1.0),
            Err(NotFinite {
                parameter: "min",
                ..
            })
        ));
        assert!(matches!(
            Distribution::uniform(0.0, f64::INFINITY),
            Err(NotFinite {
                parameter: "max",
                ..
            })
        ));
        assert!(matches!(
            Distribution::uniform(-1.7e308, 1.7e308),
            Err(MomentOutOfRange { .. })
        ));
        assert_eq!(
            Distribution::normal(0.0, 0.0),
            Err(NotPositive {
                parameter: "std",
                value: 0.0
            })
        );
        assert!(matches!(
            Distribution::normal(f64::NEG_INFINITY, 1.0),
            Err(NotFinite { .. })
        ));
        assert_eq!(
            Distribution::lognormal(0.0, -1.0),
            Err(NotPositive {
                parameter: "sigma",
                value: -1.0
            })
        );
        for (mu, sigma) in [(800.0, 1.0), (0.0, 40.0), (-800.0, 1.0), (0.0, 1e200)] {
            assert_eq!(
                Distribution::lognormal(mu, sigma),
                Err(MomentOutOfRange { kind: "lognormal" })
            );
        }
    }

    #[test]
    fn a_law_too_narrow_for_its_mean_has_no_rule() {
        let law = Distribution::normal(1.0, 1e-17).unwrap();
        assert_eq!(
            law.gauss_rule(5),
            Err(RuleError::Coincident { index: 0, nodes: 5 })
        );
        let law = Distribution::lognormal(650.0, 7.0).unwrap();
        assert!(matches!(
            law.gauss_rule(64),
            Err(RuleError::OutOfRange { .. })
        ));
    }

    #[test]
    fn documents_read_names_and_parameters() {
        let law = Distribution::lognormal(0.0, 0.8).unwrap();
        assert_eq!(law.kind(), "lognormal");
        assert_eq!(law.parameters(), [("mu", 0.0), ("sigma", 0.8)]);
    }
}
