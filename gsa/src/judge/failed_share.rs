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
//!
//! **Far out.** A law that bends away from where runs end is the farther off the farther they lack. In a uniform law's slab of p = 1/4 that is less than
//! a standard deviation of the input, in a normal law's tail two. With d the distance from the last run to the outermost failed one, in such
//! standard deviations, D = C d^2 where that is more. Such a D isn't small beside 1/p. With the gains w_i = p (2 G D sqrt(S_i) + D^2), and w of the
//! whole variance,
//!
//! ```text
//! dS_i = max((1 - S_i) w_i/(1 + w_i), S_i w/(1 + w))
//! ```
//!
//! which is less than one however large D may be. The larger of both claims counts.

use crate::judge::index_error::at_most_one;

/// D: two models that agree wherever they run differ elsewhere by about their spread.
const DEPARTURE: f64 = 1.0;
/// C: a parabola that has left by twice the output's spread at one standard deviation of the input.
const BEND: f64 = 2.0;
/// G
const OUTSIDE: f64 = 2.0;
/// Largest p that an error is claimed for.
const MOST: f64 = 0.25;

/// Whether runs of this probability are too many for an error that says anything.
pub(crate) fn is_too_much(probability: f64) -> bool {
    probability > MOST
}

/// Error of each first-order index where runs of this probability failed, so many standard deviations of an input beyond the others.
pub(crate) fn errors(first_order: &[f64], probability: f64, distance: f64) -> Vec<f64> {
    let far = BEND * distance * distance;
    let error = |&s: &f64| match is_too_much(probability) {
        true => 1.0,
        false => at_most_one(near(s, probability).max(far_out(s, probability, far))),
    };
    first_order.iter().map(error).collect()
}

/// 2 G D sqrt(S) + D^2
fn gain(s: f64, departure: f64) -> f64 {
    departure * (2.0 * OUTSIDE * s.sqrt() + departure)
}

fn near(s: f64, probability: f64) -> f64 {
    let gain = |s: f64| probability * gain(s, DEPARTURE);
    ((1.0 - s) * gain(s)).max(s * gain(1.0))
}

fn far_out(s: f64, probability: f64, departure: f64) -> f64 {
    let share = |s: f64| {
        let gain = probability * gain(s, departure);
        gain / (1.0 + gain)
    };
    ((1.0 - s) * share(s)).max(s * share(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_grow_with_what_was_lost_until_they_say_nothing() {
        // p D^2 for an input without an effect; p (1 - S)(4 sqrt(S) + 1) and p S (4 + 1) at a quarter: 9/4 and 5/4
        let found = errors(&[0.0, 0.25], 0.1, 0.0);
        assert!((found[0] - 0.1).abs() < 1e-15 && (found[1] - 0.225).abs() < 1e-15);
        assert_eq!(errors(&[0.5], 0.0, 0.0), [0.0]);
        assert_eq!(errors(&[0.5], 0.3, 0.0), [1.0]);
    }

    #[test]
    fn errors_grow_with_the_distance_of_what_was_lost() {
        let of = |distance: f64| errors(&[0.25], 0.1, distance)[0];
        assert_eq!(of(0.5), of(0.0));
        // D = 8: w_1 = 0.1 (16 + 64) = 8 and 0.75 (8/9)
        assert!((of(2.0) - 2.0 / 3.0).abs() < 1e-15);
        assert!(of(100.0) < 1.0);
    }
}
