//! Additive dimension reduction: what remains when a product is refuted.
//!
//! ```text
//! h(x) ~ h0 + sum_i (h_i(x_i) - h0)
//! ```
//!
//! S. Rahman, H. Xu, "A univariate dimension-reduction method for multi-dimensional integration in stochastic
//! mechanics", Probabilistic Engineering Mechanics 19 (2004) 393-408. It is the end t = 0 of the shifted products
//! h0 + (prod_i (1 + t d_i) - 1)/t, of which t = 1/h0 is M-DRM: the same runs, no h0 != 0 needed. It has no interactions,
//! so S_i = S_Ti = v_i / sum_k v_k, E\[Y\] = h0 + sum_i dbar_i, Var\[Y\] = sum_i v_i (symbols as in the sections).

use crate::design::CheckPoint;
use crate::form::section::Sections;

/// S_i = S_Ti; all zero where nothing varies.
pub(crate) fn first_order(variances: &[f64]) -> Vec<f64> {
    let whole: f64 = variances.iter().sum();
    let index = |v: &f64| {
        if whole > 0.0 {
            (v / whole).min(1.0)
        } else {
            0.0
        }
    };
    variances.iter().map(index).collect()
}

/// E\[Y\] and Var\[Y\] in the units of the sections.
pub(crate) fn moments(sections: &Sections) -> (f64, f64) {
    let mean = sections.centre + sections.shifts.iter().sum::<f64>();
    (mean, sections.variances.iter().sum())
}

/// The form at a check point, in the units of the sections.
pub(crate) fn predict(sections: &Sections, check: &CheckPoint) -> f64 {
    sections.centre + sections.differences_at(check).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_are_shares_of_the_variance() {
        assert_eq!(first_order(&[1.0, 3.0, 0.0]), [0.25, 0.75, 0.0]);
        assert_eq!(first_order(&[0.0, 0.0]), [0.0, 0.0]);
    }
}
