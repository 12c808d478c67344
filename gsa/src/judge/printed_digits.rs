//! Error of an index by the digits that the values were printed with.
//!
//! Values that are each off by at most u, half a unit of their last digit, belong to a function that is off by no more. A standard deviation
//! is a norm, which changes by at most that of the change: with sigma the output's, and a and b the growth of u in a form's main effects
//! and in the whole of it,
//!
//! ```text
//! sqrt(V_i) +- a u,   sqrt(V) +- b u,   ((sqrt(S_i) - a q)/(1 + b q))^2 <= S_i <= ((sqrt(S_i) + a q)/(1 - b q))^2,   q = u/sigma
//! ```
//!
//! This covers the function before it was printed, and the stepped one that was: rounding errors are spread evenly over +-u, at the points and
//! between them, so that both together have a root mean square of sqrt(2/3) u.

use crate::judge::index_error::at_most_one;

/// Growth of the rounding errors: in the main effects, and in the whole of a form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Growth {
    pub(crate) main: f64,
    pub(crate) whole: f64,
}

/// Error of each first-order index for rounding errors of at most `share` of the output's standard deviation.
pub(crate) fn errors(first_order: &[f64], share: f64, growth: Growth) -> Vec<f64> {
    let (main, whole) = (growth.main * share, growth.whole * share);
    let error = |s: &f64| {
        if whole.is_nan() || whole >= 1.0 {
            return 1.0;
        }
        let most = ((s.sqrt() + main) / (1.0 - whole)).powi(2);
        let least = ((s.sqrt() - main).max(0.0) / (1.0 + whole)).powi(2);
        at_most_one((most - s).max(s - least))
    };
    first_order.iter().map(error).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bound_is_that_of_the_triangle_inequality() {
        let growth = Growth {
            main: 1.0,
            whole: 2.0,
        };
        let found = errors(&[0.0, 0.25], 0.1, growth);
        // (0.1/0.8)^2 and (0.6/0.8)^2 - 0.25
        assert!((found[0] - 0.015625).abs() < 1e-15 && (found[1] - 0.3125).abs() < 1e-15);
        assert_eq!(errors(&[0.5], 0.5, growth), [1.0]);
        assert_eq!(errors(&[0.5], f64::INFINITY, growth), [1.0]);
        assert_eq!(errors(&[0.25], 0.0, growth), [0.0]);
    }
}
