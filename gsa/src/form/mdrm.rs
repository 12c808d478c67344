//! Multiplicative dimension reduction (M-DRM): Sobol indices from one line of runs per input.
//!
//! The output is taken as a product of its sections through the cut point,
//!
//! ```text
//! h(x) ~ h0^(1-n) prod_i h_i(x_i) = h0 prod_i h_i(x_i)/h0                                                        (1)
//! ```
//!
//! X. Zhang, M. D. Pandey, "An effective approximation for variance-based global sensitivity analysis", Reliability
//! Engineering and System Safety 121 (2014) 164-174. With rho_i = E\[h_i\] and theta_i = E\[h_i^2\] their indices are
//!
//! ```text
//! S_i  = (theta_i/rho_i^2 - 1) / (prod_k theta_k/rho_k^2 - 1)                                                      (2)
//! S_Ti = (1 - rho_i^2/theta_i) / (1 - prod_k rho_k^2/theta_k)                                                      (3)
//! ```
//!
//! Written so, small variances cancel, large outputs overflow and h0^(1-n) does both. Equal to them, but safe in
//! double precision, with v_i = theta_i - rho_i^2 taken from centred sums:
//!
//! ```text
//! q_i = (v_i/rho_i)/rho_i,   L = sum_i ln(1 + q_i)                                                                 (4)
//! S_i = q_i / (exp(L) - 1),  S_Ti = q_i/(1 + q_i) / (1 - exp(-L))                                                  (5)
//! E[Y] = h0 prod_i rho_i/h0, Var[Y] = E[Y]^2 (exp(L) - 1)                                                          (6)
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | h0, h_i, v_i, rho_i | value at the cut point, section along input i, its variance and mean |
//! | q_i | squared coefficient of variation of section i |
//! | L | log of 1 + the squared coefficient of variation of the output |
//!
//! With h + s in place of h, for any constant s, this is the shifted product
//!
//! ```text
//! h(x) ~ (h0 + s) prod_i (1 + t d_i(x_i)) - s,   t = 1/(h0 + s),  d_i = h_i - h0                                    (7)
//! ```
//!
//! whose indices are (4) and (5) with rho_i + s in place of rho_i. It tends to the additive form as t -> 0 and needs no
//! h0 != 0. One set of runs serves every s; the check points say which one is best (`shift`).
//!
//! What it cannot do: with h0 = 0 or some rho_i = 0 equation (1) divides by zero, and a product says nothing about an
//! output that is not one. Both are told apart by [`Undefined`] and by the check points.

use crate::design::CheckPoint;
use crate::form::section::Sections;

/// Least share of the largest value: below sqrt(eps) more than half the digits of h0 are lost in the ratios h_i/h0.
const LEAST_REFERENCE: f64 = 1.0 / (1u32 << 26) as f64;
/// exp(L) - 1 overflows at 709.8.
const LARGEST_EXPONENT: f64 = 700.0;

/// Reason why the product form does not exist for an output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Undefined {
    /// h0 is zero, to half the digits of a double.
    Reference,
    /// rho_i is zero to rounding, for this input.
    SectionMean(usize),
}

/// The product form of one output, where it exists.
#[derive(Debug, Clone)]
pub(crate) struct Mdrm {
    /// s, in the units of the sections; 0 for M-DRM proper
    shift: f64,
    /// rho_i + s, in the units of the sections
    means: Vec<f64>,
    /// q_i
    squared_variations: Vec<f64>,
}

impl Mdrm {
    pub(crate) fn new(sections: &Sections) -> Result<Self, Undefined> {
        Self::shifted(sections, 0.0)
    }

    /// The product form of h + s, equation (7).
    pub(crate) fn shifted(sections: &Sections, shift: f64) -> Result<Self, Undefined> {
        let reference = sections.centre + shift;
        if reference.abs() <= LEAST_REFERENCE * sections.largest {
            return Err(Undefined::Reference);
        }
        let means: Vec<f64> = sections.shifts.iter().map(|d| reference + d).collect();
        if let Some(input) = means.iter().position(|rho| rho.abs() <= sections.noise()) {
            return Err(Undefined::SectionMean(input));
        }
        let variations = sections.variances.iter().zip(&means);
        Ok(Self {
            shift,
            squared_variations: variations.map(|(v, rho)| v / rho / rho).collect(),
            means,
        })
    }

    /// S_i, equation (5).
    pub(crate) fn first_order(&self) -> Vec<f64> {
        first_order(&self.squared_variations)
    }

    /// S_Ti, equation (5).
    pub(crate) fn total(&self) -> Vec<f64> {
        let whole = -(-log_variation(&self.squared_variations)).exp_m1();
        let total = |q: &f64| (q / (1.0 + q) / whole).min(1.0);
        self.squared_variations.iter().map(total).collect()
    }

    /// S_ij = S_i q_j, the share of the pair alone.
    pub(crate) fn second_order(&self, first_order: &[f64]) -> Vec<f64> {
        let n = first_order.len();
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        pairs
            .map(|(i, j)| (first_order[i] * self.squared_variations[j]).min(1.0))
            .collect()
    }

    /// The sign of the main effect of each input beside its section: that of the product of the other means.
    pub(crate) fn main_effect_signs(&self, sections: &Sections) -> Vec<f64> {
        let relative = |rho: &f64| (rho / (sections.centre + self.shift)).signum();
        let all: f64 = self.means.iter().map(relative).product();
        self.means.iter().map(|rho| all * relative(rho)).collect()
    }

    /// E\[Y\] and Var\[Y\], equation (6), in the units of the sections; infinite or zero where out of range.
    pub(crate) fn moments(&self, sections: &Sections) -> (f64, f64) {
        let h0 = sections.centre + self.shift;
        let ratios = || {
            self.means
                .iter()
                .zip(&sections.shifts)
                .map(|(rho, shift)| (rho / h0, shift / h0))
        };
        // Magnitudes as logarithms, signs apart: a product of many ratios may leave the range on its way.
        let log_ratio = |(ratio, excess): (f64, f64)| {
            if ratio > 0.5 {
                excess.ln_1p()
            } else {
                ratio.abs().ln()
            }
        };
        let log_mean: f64 = ratios().map(log_ratio).sum();
        let sign: f64 = ratios().map(|(ratio, _)| ratio.signum()).product();
        let mean = if self.shift == 0.0 {
            sign * h0 * log_mean.exp()
        } else {
            sections.centre + departure(1.0 / h0, sections.shifts.iter().copied())
        };
        let log_variation = log_variation(&self.squared_variations);
        let log_variance = 2.0 * (h0.abs().ln() + log_mean) + ln_exp_m1(log_variation);
        (mean, log_variance.exp())
    }

    /// Equation (1) or (7) at a check point, in the units of the sections; NaN or infinite where the product overflows.
    pub(crate) fn predict(&self, sections: &Sections, check: &CheckPoint) -> f64 {
        let h0 = sections.centre;
        let differences = sections.differences_at(check);
        if self.shift == 0.0 {
            h0 * differences.map(|d| (h0 + d) / h0).product::<f64>()
        } else {
            h0 + departure(1.0 / (h0 + self.shift), differences)
        }
    }
}

/// (prod_i (1 + t d_i) - 1)/t without the division: f + d + t f d appends a factor to the product behind f.
pub(crate) fn departure(t: f64, differences: impl Iterator<Item = f64>) -> f64 {
    differences.fold(0.0, |f, d| f + d + t * f * d)
}

/// L, equation (4).
fn log_variation(q: &[f64]) -> f64 {
    q.iter().map(|q| q.ln_1p()).sum()
}

fn first_order(q: &[f64]) -> Vec<f64> {
    let log_variation = log_variation(q);
    let log_whole = ln_exp_m1(log_variation);
    let index = |q: &f64| {
        if *q == 0.0 {
            0.0
        } else if log_variation > LARGEST_EXPONENT {
            // May honestly underflow: fifty wide factors leave nothing to any one alone.
            (q.ln() - log_whole).exp()
        } else {
            (q / log_variation.exp_m1()).min(1.0)
        }
    };
    q.iter().map(index).collect()
}

/// ln(exp(L) - 1) for L > 0, without overflow.
fn ln_exp_m1(log_variation: f64) -> f64 {
    if log_variation > LARGEST_EXPONENT {
        log_variation
    } else {
        log_variation.exp_m1().ln()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_variations_share_the_variance_additively() {
        // q = 1e-20 is lost in 1 + q; the indices must not be
        let s = first_order(&[1e-20, 3e-20]);
        assert!((s[0] - 0.25).abs() < 1e-15 && (s[1] - 0.75).abs() < 1e-15);
    }

    #[test]
    fn large_variations_match_the_direct_formula() {
        let (a, b) = (3.0, 8.0);
        let s = first_order(&[a, b]);
        // (1 + a)(1 + b) - 1 = 35
        assert!((s[0] - a / 35.0).abs() < 1e-15 && (s[1] - b / 35.0).abs() < 1e-15);
    }

    #[test]
    fn both_branches_meet_where_the_exponential_overflows() {
        // factors exp(14): fifty make L = 700, one more goes over
        let q = 14f64.exp_m1();
        let below = first_order(&vec![q; 50])[0];
        let above = first_order(&vec![q; 51])[0];
        // S falls by exp(14) per factor; L = 700 carries 700 eps
        assert!((below / above / 14f64.exp() - 1.0).abs() < 1e-12);
        assert_eq!(first_order(&vec![q; 80])[0], 0.0);
        assert!(first_order(&[0.0, 1e300, 1e300, 1e300])[0] == 0.0);
    }
}
