//! What a rule misses of a section's variance, judged by how fast the section's coefficients fall.
//!
//! A rule of N nodes resolves the modes k = 1 .. N-1, with amplitudes |c_k|, and is wrong about the variance where the
//! squared section has modes of degree 2N and more. Let s be the amplitude of the last two modes over the standard
//! deviation, around k_2 = N - 3/2, and r the ratio of theirs to that of the two before, around k_1 = N - 7/2 (the larger of
//! the last two such ratios, if there are two). Modes go in pairs because a section even or odd about its mean leaves every
//! second one empty. The amplitudes of a kink fall like k^-2, whose ratio is r_0 = (k_1/k_2)^2, and the error is of the order
//! of s itself; those of an analytic section fall geometrically, and the error is s r^p with p = (N + 3/2)/2, above 3. So
//!
//! ```text
//! missing share = C s min(1, (r/r_0)^4)
//! ```
//!
//! Five nodes can't tell a kink from a sine of half a period and more; then this errs on the kink's side.

/// C: at steps and kinks in random places the error of 5 to 17 nodes was at most 1.5 s for nine in ten.
const SAFETY: f64 = 1.5;
/// Steep, since kinks with r much below r_0 are rare and analytic sections with r near r_0 are too.
const POWER: i32 = 4;
/// A rule that has lost nodes is no Gauss rule: wrong from degree N - 1 on, which is one ratio beyond what it resolves.
const POWER_OF_LOST: i32 = 1;

/// How the modes of a section end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tail {
    /// s
    pub(crate) amplitude: f64,
    /// missing share of the variance
    pub(crate) missing: f64,
}

/// From the squared amplitudes of the modes k = 1, 2, .., `whole` if no node was lost; `None` for fewer than two modes, which
/// cannot tell.
pub(crate) fn tail(energies: &[f64], whole: bool) -> Option<Tail> {
    let modes = energies.len();
    if modes < 2 {
        return None;
    }
    let all: f64 = energies.iter().sum();
    if all <= 0.0 {
        return Some(Tail {
            amplitude: 0.0,
            missing: 0.0,
        });
    }
    let pair = if modes < 4 { 1 } else { 2 };
    let energy = |skipped: usize| -> f64 {
        let from_the_end = energies.iter().rev().skip(skipped * pair);
        from_the_end.take(pair).sum()
    };
    let mut ratio = (energy(0) / energy(1)).sqrt();
    if modes >= 3 * pair {
        ratio = ratio.max((energy(1) / energy(2)).sqrt());
    }
    let middle = 0.5 * (pair - 1) as f64;
    let (k_1, k_2) = ((modes - pair) as f64 - middle, modes as f64 - middle);
    let power = if whole { POWER } else { POWER_OF_LOST };
    let decay = (ratio / (k_1 / k_2).powi(2)).powi(power);
    // Not `min`: with nothing before them the ratio is infinite or not a number.
    let decay = if decay < 1.0 { decay } else { 1.0 };
    let amplitude = (energy(0) / all).sqrt();
    Some(Tail {
        amplitude,
        missing: (SAFETY * amplitude * decay).min(1.0),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn missing(energies: &[f64]) -> f64 {
        tail(energies, true).unwrap().missing
    }

    #[test]
    fn what_falls_fast_misses_little() {
        let geometric =
            |ratio: f64, n: i32| (1..=n).map(|k| ratio.powi(2 * k)).collect::<Vec<f64>>();
        for n in [4, 6, 8] {
            // the amplitude at degree 2N over the first
            for ratio in [0.6, 0.3, 0.1f64] {
                assert!(
                    missing(&geometric(ratio, n)) > ratio.powi(2 * n + 1),
                    "{ratio} {n}"
                );
            }
            assert!(missing(&geometric(0.1, n)) < 1e-3 * missing(&geometric(0.6, n)));
        }
        // a kink's error goes like the amplitude at 2N, a quarter of the one at N
        for n in [4, 8, 16] {
            let kink: Vec<f64> = (1..=n).map(|k| f64::from(k).powi(-4)).collect();
            assert!(missing(&kink) > f64::from(2 * n).powi(-2));
        }
    }

    #[test]
    fn two_modes_are_the_least() {
        assert_eq!(tail(&[1.0], true), None);
        assert_eq!(missing(&[0.0, 0.0]), 0.0);
        assert_eq!(missing(&[0.0, 1.0]), 1.0);
        assert_eq!(missing(&[1.0, 0.0]), 0.0);
    }

    #[test]
    fn lost_nodes_cost_accuracy() {
        let energies = [1.0, 0.01, 1e-4];
        assert!(tail(&energies, false).unwrap().missing > 5.0 * missing(&energies));
    }
}
