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
//! Written so, small variances cancel, large outputs overflow and h0^(1-n) does both. The same numbers in a form that
//! holds, with v_i = theta_i - rho_i^2 taken from centred sums:
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
//! What it cannot do: with h0 = 0 or some rho_i = 0 equation (1) divides by zero, and a product says nothing about an
//! output that is not one. Both are told apart by [`Undefined`] and by the check points.

use crate::design::CheckPoint;
use crate::section::Sections;

/// Below sqrt(eps) of the largest value, more than half the digits of h0 are lost in the ratios h_i/h0.
const LEAST_REFERENCE: f64 = 1.0 / (1u32 << 26) as f64;
/// exp(L) - 1 overflows at 709.8.
const LARGEST_EXPONENT: f64 = 700.0;

/// Why the product form does not exist for an output.
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
    /// rho_i, in the units of the sections
    means: Vec<f64>,
    /// q_i
    squared_variations: Vec<f64>,
}

impl Mdrm {
    pub(crate) fn new(sections: &Sections) -> Result<Self, Undefined> {
        if sections.centre.abs() <= LEAST_REFERENCE * sections.largest {
            return Err(Undefined::Reference);
        }
        let means: Vec<f64> = (0..sections.inputs())
            .map(|i| sections.section_mean(i))
            .collect();
        if let Some(input) = means.iter().position(|rho| rho.abs() <= sections.noise()) {
            return Err(Undefined::SectionMean(input));
        }
        let squared_variations = squared_variations(&sections.variances, &means);
        Ok(Self {
            means,
            squared_variations,
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

    /// S_i if the sections had these variances and the same means.
    pub(crate) fn first_order_with(&self, variances: &[f64]) -> Vec<f64> {
        first_order(&squared_variations(variances, &self.means))
    }

    /// E\[Y\] and Var\[Y\], equation (6), in the units of the sections; infinite or zero where out of range.
    pub(crate) fn moments(&self, sections: &Sections) -> (f64, f64) {
        let h0 = sections.centre;
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
        let mean = sign * h0 * log_mean.exp();
        let log_variation = log_variation(&self.squared_variations);
        let log_variance = 2.0 * (h0.abs().ln() + log_mean) + ln_exp_m1(log_variation);
        (mean, log_variance.exp())
    }

    /// Equation (1) at a check point, in the units of the sections; NaN or infinite where the product overflows.
    pub(crate) fn predict(&self, sections: &Sections, check: &CheckPoint) -> f64 {
        let h0 = sections.centre;
        h0 * sections
            .differences_at(check)
            .map(|d| (h0 + d) / h0)
            .product::<f64>()
    }
}

/// q_i, equation (4); never theta/rho^2 - 1, which cancels.
fn squared_variations(variances: &[f64], means: &[f64]) -> Vec<f64> {
    variances
        .iter()
        .zip(means)
        .map(|(v, rho)| v / rho / rho)
        .collect()
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
