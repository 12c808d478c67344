//! Beta law on \[min, max\]; rule: Gauss-Jacobi.

use super::law_contract::Law;
use crate::law::basis::{Basis, crowds};
use crate::law::density::{Density, Place, centred, power};
use crate::law::distribution::distribution_error::{DistributionError, in_range, range, shape};
use crate::law::probability::Integrated;
use crate::law::recurrence::Recurrence;

/// Density (x - min)^(alpha - 1) (max - x)^(beta - 1) between the two bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Beta {
    alpha: f64,
    beta: f64,
    min: f64,
    max: f64,
}

impl Beta {
    pub(super) fn new(
        alpha: f64,
        beta: f64,
        min: f64,
        max: f64,
    ) -> Result<Self, DistributionError> {
        shape("alpha", alpha)?;
        shape("beta", beta)?;
        range("beta", min, max)?;
        let law = Self {
            alpha,
            beta,
            min,
            max,
        };
        in_range("beta", law.mean(), law.std())?;
        Ok(law)
    }

    fn width(&self) -> f64 {
        self.max - self.min
    }

    fn integrated(&self) -> Integrated<'_> {
        Integrated {
            density: self,
            low: self.min,
            high: self.max,
        }
    }

    /// Standard deviation on \[0, 1\].
    fn standard_deviation(&self) -> f64 {
        let sum = self.alpha + self.beta;
        (self.alpha / sum * (self.beta / sum) / (sum + 1.0)).sqrt()
    }
}

/// b_k of the folded law on \[0, 1\] that crowds at 0 if alpha < beta: q_{k-1} p_k with the canonical moments
/// p_{2j-1} = (alpha + j - 1)/(alpha + beta + 2j - 2), p_2j = j/(alpha + beta + 2j - 1), q = 1 - p (H. Dette,
/// W. J. Studden, *The Theory of Canonical Moments*, Wiley 1997, section 1.5).
fn folded_coefficient(alpha: f64, beta: f64, k: f64) -> f64 {
    let total = alpha + beta + k - 1.0;
    let half = 0.5 * k;
    let odd = k % 2.0 == 1.0;
    let p = if odd { alpha + half - 0.5 } else { half } / total;
    let q = if k == 1.0 {
        1.0
    } else if odd {
        (alpha + beta + half - 1.5) / (total - 1.0)
    } else {
        (beta + half - 1.0) / (total - 1.0)
    };
    p * q
}

/// b_k of the law with alpha = beta on \[-1, 1\] (Gegenbauer).
fn symmetric_coefficient(alpha: f64, k: f64) -> f64 {
    if k == 1.0 {
        1.0 / (2.0 * alpha + 1.0)
    } else {
        let twice = 2.0 * (alpha + k);
        k / (twice - 1.0) * ((2.0 * alpha + k - 2.0) / (twice - 3.0))
    }
}

/// a_k - mean of the law on \[0, 1\], in which the mean has been cancelled by hand.
fn centred_coefficient(alpha: f64, beta: f64, k: f64) -> f64 {
    if k == 0.0 {
        return 0.0;
    }
    let sum = alpha + beta;
    let (a, b) = (sum + 2.0 * k - 2.0, sum + 2.0 * k);
    2.0 * k * ((sum + k - 1.0) / a) * ((beta - alpha) / (sum * b))
}

impl Law for Beta {
    fn kind(&self) -> &'static str {
        "beta"
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        vec![
            ("alpha", self.alpha),
            ("beta", self.beta),
            ("min", self.min),
            ("max", self.max),
        ]
    }

    /// min + (max - min) alpha/(alpha + beta)
    fn mean(&self) -> f64 {
        if self.alpha == self.beta {
            return self.min.midpoint(self.max);
        }
        let sum = self.alpha + self.beta;
        if self.alpha < self.beta {
            self.min + self.width() * (self.alpha / sum)
        } else {
            self.max - self.width() * (self.beta / sum)
        }
    }

    /// (max - min) sqrt(alpha beta/(alpha + beta + 1))/(alpha + beta)
    fn std(&self) -> f64 {
        self.width() * self.standard_deviation()
    }

    fn probabilities(&self, x: f64) -> (f64, f64) {
        self.integrated().probabilities(x)
    }

    fn quantile(&self, p: f64, q: f64) -> f64 {
        self.integrated().quantile(p, q)
    }

    fn basis(&self, size: usize) -> Option<Basis> {
        let (alpha, beta) = (self.alpha, self.beta);
        if alpha == beta {
            let recurrence = Recurrence::symmetric(size, |k| symmetric_coefficient(alpha, k));
            return Some(Basis::plain(recurrence, self.mean(), 0.5 * self.width()));
        }
        let (small, large) = (alpha.min(beta), alpha.max(beta));
        let std = self.standard_deviation();
        let folded = |k: f64| folded_coefficient(small, large, k);
        if crowds(small / (small + large), std) {
            let recurrence = Recurrence::symmetric(2 * size, folded);
            return Some(if alpha < beta {
                Basis::folded(recurrence, self.min, self.width())
            } else {
                Basis::folded(recurrence, self.max, -self.width())
            });
        }
        let a = |k: f64| centred_coefficient(alpha, beta, k) / std;
        let b = |k: f64| folded(2.0 * k - 1.0) / std * (folded(2.0 * k) / std);
        let recurrence = Recurrence::general(size, a, b);
        Some(Basis::plain(recurrence, self.mean(), self.std()))
    }

    fn density(&self) -> &dyn Density {
        self
    }

    fn has_closed_probabilities(&self) -> bool {
        false
    }
}

impl Density for Beta {
    fn support(&self) -> (f64, f64) {
        (self.min, self.max)
    }

    fn width(&self) -> f64 {
        self.std()
    }

    /// The mode, or the mean where the density is infinite at an end.
    fn anchor(&self, low: f64, high: f64) -> f64 {
        let peak = if self.alpha > 1.0 && self.beta > 1.0 {
            self.min + self.width() * ((self.alpha - 1.0) / (self.alpha + self.beta - 2.0))
        } else {
            self.mean()
        };
        peak.clamp(low, high)
    }

    fn ln_ratio(&self, place: &Place) -> f64 {
        power(self.alpha - 1.0, place.ln_start_ratio())
            + power(self.beta - 1.0, place.ln_end_ratio())
    }

    fn symmetry(&self, low: f64, high: f64) -> Option<f64> {
        let centre = self.mean();
        (self.alpha == self.beta && centred(low, centre, high)).then_some(centre)
    }
}
