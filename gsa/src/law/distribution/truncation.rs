//! A law under the condition that it lies between two bounds.
//!
//! Probabilities are differences of the whole law's, taken on the side where they are small, as long as that keeps
//! their digits; on narrow intervals and in far tails they are integrals of the density instead.

use super::law_contract::{Law, Scale};
use crate::law::basis::Basis;
use crate::law::discretisation;
use crate::law::distribution::distribution_error::{DistributionError, finite};
use crate::law::panel::Restricted;
use crate::law::probability::Integrated;

/// A difference this large beside its terms has lost two digits at most.
const KEEPS_DIGITS: f64 = 0.01;
/// Smaller probabilities have lost digits to underflow.
const SMALLEST: f64 = 1e-280;
/// Degree of the largest polynomial for which moments are right: two for x^2; on a logarithmic scale the tails are
/// followed 20 standard deviations and more, enough for exp(2y) up to a standard deviation of [`WIDEST_LOGARITHM`].
const DEGREES: [f64; 2] = [2.0, 256.0];
/// exp(2y) peaks twice as many deviations out, where 8 more make it negligible.
const WIDEST_LOGARITHM: f64 = 6.0;

/// Bounds and moments of a truncated law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Truncation {
    given: (f64, f64),
    /// both ends in the law's coordinate
    low: f64,
    high: f64,
    /// the ends in the input's unit
    ends: (f64, f64),
    mean: f64,
    std: f64,
    /// P(Y <= low), P(Y > low); P(Y <= high), P(Y > high); P(low < Y <= high), if they keep their digits
    masses: Option<[(f64, f64); 2]>,
}

impl Truncation {
    pub(super) fn new(law: &dyn Law, low: f64, high: f64) -> Result<Self, DistributionError> {
        finite("truncate", low)?;
        finite("truncate", high)?;
        if low >= high {
            return Err(DistributionError::EmptyTruncation { low, high });
        }
        let scale = law.scale();
        let support = law.density().support();
        let start = scale.place(support.0).max(low);
        let end = scale.place(support.1).min(high);
        let nothing = DistributionError::NothingLeft { low, high };
        if start >= end {
            return Err(nothing);
        }
        let mut cut = Self {
            given: (low, high),
            low: lower_end(scale, start).max(support.0),
            high: scale.coordinate(end).min(support.1),
            ends: (start, end),
            mean: f64::NAN,
            std: f64::NAN,
            masses: None,
        };
        (cut.mean, cut.std) = cut.moments(law).ok_or(nothing)?;
        if law.has_closed_probabilities() {
            let masses = [law.probabilities(cut.low), law.probabilities(cut.high)];
            cut.masses = keeps_digits(masses[0], masses[1]).then_some(masses);
        }
        Ok(cut)
    }

    /// Returns mean and standard deviation; `None` where the density vanishes in double precision.
    fn moments(&self, law: &dyn Law) -> Option<(f64, f64)> {
        let (density, scale) = (law.density(), law.scale());
        let anchor = density.anchor(self.low, self.high);
        let restricted = Restricted {
            density,
            low: self.low,
            high: self.high,
            anchor,
        };
        let (mean, std) = match scale {
            Scale::Linear => {
                let (shift, std) = discretisation::moments(restricted, DEGREES[0], |d| d)?;
                let centre = density.symmetry(self.low, self.high);
                (centre.unwrap_or(anchor + shift), std)
            }
            Scale::Logarithmic if density.width() > WIDEST_LOGARITHM => return None,
            Scale::Logarithmic => {
                let unit = anchor.exp();
                let (mean, std) = discretisation::moments(restricted, DEGREES[1], f64::exp)?;
                (unit * mean, unit * std)
            }
        };
        (mean.is_finite() && std.is_finite()).then_some((mean.clamp(self.ends.0, self.ends.1), std))
    }

    pub(super) fn given(&self) -> (f64, f64) {
        self.given
    }

    pub(super) fn mean(&self) -> f64 {
        self.mean
    }

    pub(super) fn std(&self) -> f64 {
        self.std
    }

    pub(super) fn probabilities(&self, law: &dyn Law, y: f64) -> (f64, f64) {
        if y <= self.low {
            return (0.0, 1.0);
        }
        if y >= self.high {
            return (1.0, 0.0);
        }
        if let Some([low, high]) = self.masses {
            let here = law.probabilities(y);
            if keeps_digits(low, here) && keeps_digits(here, high) {
                let (p, q) = (between(low, here), between(here, high));
                return (p / (p + q), q / (p + q));
            }
        }
        self.integrated(law).probabilities(y)
    }

    /// The x, not y, with P(X <= x) = p = 1 - q.
    pub(super) fn quantile(&self, law: &dyn Law, p: f64, q: f64) -> f64 {
        if p <= 0.0 {
            return self.ends.0;
        }
        if q <= 0.0 {
            return self.ends.1;
        }
        let y = match self.masses {
            Some([low, high]) => {
                let mass = between(low, high);
                law.quantile(low.0 + p * mass, high.1 + q * mass)
            }
            None => self.integrated(law).quantile(p, q),
        };
        law.scale().place(y).clamp(self.ends.0, self.ends.1)
    }

    pub(super) fn basis(&self, law: &dyn Law, size: usize) -> Option<Basis> {
        discretisation::basis(law.density(), self.low, self.high, size)
    }

    fn integrated<'a>(&self, law: &'a dyn Law) -> Integrated<'a> {
        Integrated {
            density: law.density(),
            low: self.low,
            high: self.high,
        }
    }
}

/// The coordinate of the lower end: finite, as zero and the first normal double above it are one to a lognormal law.
fn lower_end(scale: Scale, start: f64) -> f64 {
    match scale {
        Scale::Linear => start,
        Scale::Logarithmic => scale.coordinate(start.max(f64::MIN_POSITIVE)),
    }
}

/// P(a < Y <= b) from both probabilities at a and b.
fn between(a: (f64, f64), b: (f64, f64)) -> f64 {
    if a.0 > 0.5 { a.1 - b.1 } else { b.0 - a.0 }
}

fn keeps_digits(low: (f64, f64), high: (f64, f64)) -> bool {
    let mass = between(low, high);
    let largest = if low.0 > 0.5 { low.1 } else { high.0 };
    mass > SMALLEST && mass >= KEEPS_DIGITS * largest
}
