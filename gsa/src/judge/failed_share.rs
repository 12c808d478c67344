//! Error of an index by what the output may do where runs failed.
//!
//! Runs that failed leave a part of the inputs' range, of probability p, of which a form only guesses the output. Be it off there by r, D
//! standard deviations of the output; with main effect g_i and output f, which are G standard deviations of their own from their means
//! there, for models tend to fail at the ends of their ranges,
//!
//! ```text
//! V_i is off by E[2 g_i r + r^2] <= p (2 G D sqrt(S_i) + D^2) V      where r follows input i,
//! V   is off by E[2 f r + r^2]   <= p (2 G D + D^2) V
//! dS_i <= p max((1 - S_i) (2 G D sqrt(S_i) + D^2), S_i (2 G D + D^2))
//! ```
//!
//! to first order in p: what input i gains counts 1 - S_i times, what the others gain S_i times. D is an assumption, as no run tells it;
//! where much failed none is good enough, and the error is 1, which says nothing.

use crate::judge::index_error::at_most_one;

/// D: two models that agree wherever they run differ elsewhere by about their spread.
const DEPARTURE: f64 = 1.0;
/// G
const OUTSIDE: f64 = 2.0;
/// Largest p that an error is claimed for.
const MOST: f64 = 0.25;

/// Whether runs of this probability are too many for an error that says anything.
pub(crate) fn is_too_much(probability: f64) -> bool {
    probability > MOST
}

/// Error of each first-order index where runs of this probability failed.
pub(crate) fn errors(first_order: &[f64], probability: f64) -> Vec<f64> {
    let gain = |s: f64| 2.0 * OUTSIDE * DEPARTURE * s.sqrt() + DEPARTURE * DEPARTURE;
    let error = |&s: &f64| {
        if is_too_much(probability) {
            return 1.0;
        }
        at_most_one(probability * ((1.0 - s) * gain(s)).max(s * gain(1.0)))
    };
    first_order.iter().map(error).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_grow_with_what_was_lost_until_they_say_nothing() {
        // p D^2 for an input without an effect; p (1 - S)(4 sqrt(S) + 1) and p S (4 + 1) at a quarter: 9/4 and 5/4
        let found = errors(&[0.0, 0.25], 0.1);
        assert!((found[0] - 0.1).abs() < 1e-15 && (found[1] - 0.225).abs() < 1e-15);
        assert_eq!(errors(&[0.5], 0.0), [0.0]);
        assert_eq!(errors(&[0.5], 0.3), [1.0]);
    }
}
