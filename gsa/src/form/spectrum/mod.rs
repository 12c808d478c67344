//! Spectrum of a section: what a rule misses of its variance, judged by how fast its coefficients fall.
//!
//! A rule of N nodes resolves the modes k = 1 .. N-1, with coefficients c_k, and is wrong about the variance where the squared
//! section has modes of degree 2N and more: by products c_j c_k with j + k >= 2N. Modes beyond N - 1 are guessed. Even and odd
//! ones are looked at apart, because a section even or odd about its mean leaves every second one empty. With s the last mode
//! of a parity over the standard deviation, of degree k, and r its ratio to the one before (or of that to its predecessor, if
//! larger), there are three suspicions, and the largest claim counts:
//!
//! - the section is analytic: its modes go on falling by r, which itself falls with the degree like k^-b if the ratios resolved do,
//!   b <= 1/2 (exp on a normal law has b = 1, on a uniform one 2), and the missing share is the sum of c_j c_{2N-j} over j, and c_N^2;
//! - it has a kink or a step. Then modes fall like k^-2, which is a ratio of r_0 = ((k-2)/k)^2, and the error is of the order of s
//!   itself. A ratio much below r_0 makes that unlikely:
//!
//! ```text
//! missing share = C (sum over both parities of s min(1, (r/r_0)^8))
//! ```
//! - it is singular at an end of its range, or nearly, like t^a from t = 0 on: its modes go on falling like k^-p, or as much faster as those
//!   resolved do ([`decay`]), and the missing share is the same sum as the analytic section's.
//!
//! Five nodes can't tell a kink from a sine of half a period and more; then this errs on the kink's side. A few points off the nodes
//! can: what is missed there, b in standard deviations, are the modes beyond. With s the last two modes now, the kink's claim is
//! multiplied by (3 b/s)^2 where that is less than one, and those of the analytic section go on falling by no less than 3 b/s.

mod decay;

/// C, where each parity has a ratio, and where there are fewer modes. At steps and kinks in random places the error of 5 to 17
/// nodes was at most 2 s in nine cases of ten; where each parity has a ratio, the analytic claim covers most of these already.
const OF_KINKS: f64 = 0.7;
const OF_KINKS_BY_FEW: f64 = 2.0;
/// Sums of products of modes that go on falling were at least a third of the true error for nine in ten of a mix of analytic
/// and rough sections.
const OF_ANALYTIC: f64 = 3.0;
/// Factor on the sum for a singular end, which was at least half of the true error of t^a with a from 0.3 to 0.8, and of log t.
const OF_END: f64 = 2.0;
/// Factor on a kink's ratio of modes where there is one ratio only; of two the larger counts. Where there is one only, analytic sections are taken
/// for kinks less often if it must be larger.
const LEAST_OF_ONE: f64 = 1.25;
/// Largest b: less than any entire function's, since one of the ratios may be small by chance.
const STEEPENING: f64 = 0.5;
/// Largest missing share. A section whose modes don't fall may have several times the variance that its nodes happen to show: of waves of
/// several periods at five nodes, one in eight has more than twice as much.
pub(crate) const MOST_MISSING: f64 = 3.0;
/// Modes seen at a few points off the nodes are seldom more than this times what they seem. Beyond the resolved modes of a kink or a
/// step lies about half of their end, which this makes no fall at all.
const OF_CHANCE: f64 = 3.0;
/// Kinks whose modes beyond seem to fall are rare.
const POWER_OF_FALL: i32 = 2;
/// Ratio of the last two modes to the two before from which modes don't fall: a step has 0.4 to 1.3, a sine of half a period 0.1.
const HARDLY_FALLING: f64 = 0.6;
/// A mode this small is rounding.
const NOTHING: f64 = 1e-10;
/// Steep: kinks with r much below r_0 are rare.
const POWER: i32 = 8;
/// Two or three modes leave one ratio, which says little.
const POWER_OF_FEW: i32 = 4;
/// A rule that has lost nodes is no Gauss rule: wrong from degree N - 1 on, which is one ratio beyond what it resolves.
const POWER_OF_LOST: i32 = 1;
/// Modes from which each parity has a ratio.
const ENOUGH: usize = 4;

/// End of a section's modes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tail {
    /// the last two modes (of two or three the last) over the standard deviation
    pub(crate) amplitude: f64,
    /// missing share of the variance that the nodes show
    pub(crate) missing: f64,
}

/// Judges the end of the modes k = 1, 2, .. by their squared coefficients, `whole` if no node was lost; `None` for fewer than two modes, which cannot tell.
pub(crate) fn tail(energies: &[f64], whole: bool) -> Option<Tail> {
    tail_with(energies, whole, None)
}

/// [`tail`] where points off the nodes show the modes `beyond`: their root sum of squares over the standard deviation.
pub(crate) fn tail_with(energies: &[f64], whole: bool, beyond: Option<f64>) -> Option<Tail> {
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
    let c: Vec<f64> = energies.iter().map(|e| (e / all).sqrt()).collect();
    let missing = if modes < ENOUGH {
        of_few(&c, if whole { POWER_OF_FEW } else { POWER_OF_LOST })
    } else {
        let power = if whole { POWER } else { POWER_OF_LOST };
        let claim = of_both_parities(c.clone(), power, fall(&c, beyond));
        match whole {
            true => claim.max(of_end(&c)),
            // Modes by other weights than a Gauss rule's don't show how they fall.
            false => claim,
        }
    };
    Some(Tail {
        amplitude: last_amplitude(&c),
        missing: missing.min(MOST_MISSING),
    })
}

/// The last two modes, of two or three the last.
fn last_amplitude(c: &[f64]) -> f64 {
    let last = if c.len() < ENOUGH { 1 } else { 2 };
    c[c.len() - last..]
        .iter()
        .map(|c| c * c)
        .sum::<f64>()
        .sqrt()
}

/// Ratio of the modes beyond to the last resolved ones, on the safe side; infinite where nothing is known. Where the resolved ones
/// hardly fall, a few points prove nothing, since none of them may meet a rare corner.
fn fall(c: &[f64], beyond: Option<f64>) -> f64 {
    let last = last_amplitude(c);
    let before: f64 = c[c.len() - 4..c.len() - 2].iter().map(|c| c * c).sum();
    let resolved = last / before.sqrt() / HARDLY_FALLING;
    let fall = beyond.map(|beyond| OF_CHANCE * beyond / last);
    match fall {
        Some(fall) if fall.is_finite() && resolved.is_finite() => fall.max(resolved * resolved),
        _ => f64::INFINITY,
    }
}

/// The kink's claim over C for an amplitude of degree k, `ratio` times the one before by `step` degrees.
fn of_kink(s: f64, ratio: f64, (k, step): (usize, usize), power: i32) -> f64 {
    let least = if step == 2 && k <= 4 {
        LEAST_OF_ONE
    } else {
        1.0
    };
    let r_0 = least * ((k - step) as f64 / k as f64).powi(2);
    let decay = (ratio / r_0).powi(power);
    // Not `min`: with nothing before them the ratio is infinite or not a number.
    s * if decay < 1.0 { decay } else { 1.0 }
}

fn of_few(c: &[f64], power: i32) -> f64 {
    let k = c.len();
    let mut ratio = c[k - 1] / c[k - 2];
    if k == 3 {
        ratio = ratio.max(c[1] / c[0]);
    }
    OF_KINKS_BY_FEW * of_kink(c[k - 1], ratio, (k, 1), power)
}

/// b, by how each parity's last ratio compares with its ratio two degrees before, or with the other parity's where it has no such
/// ratio. The smaller of both.
fn steepening(c: &[f64]) -> f64 {
    let ratio = |k: usize| (c[k + 1] / c[k - 1]).max(NOTHING);
    let exponent = |last: usize| {
        let before = last.saturating_sub(2).max(1);
        let resolved = before < last && c[before - 1] > NOTHING && c[last - 1] > NOTHING;
        resolved.then(|| (ratio(before) / ratio(last)).ln() / (last as f64 / before as f64).ln())
    };
    let of_both = [c.len() - 3, c.len() - 2].into_iter().filter_map(exponent);
    let smaller = of_both.reduce(f64::min).unwrap_or(0.0);
    smaller.clamp(0.0, STEEPENING)
}

fn of_both_parities(mut c: Vec<f64>, power: i32, fall: f64) -> f64 {
    let modes = c.len();
    let nodes = modes + 1;
    let mut kinks = 0.0;
    let steepening = steepening(&c);
    c.resize(2 * nodes, 0.0);
    for k in [modes - 1, modes] {
        let (s, before) = (c[k - 1], c[k - 3]);
        let mut ratio = s / before;
        if k > 4 {
            ratio = ratio.max(before / c[k - 5]);
        }
        if s > 0.0 {
            kinks += OF_KINKS * of_kink(s, ratio, (k, 2), power);
        }
        let falls = if ratio < 1.0 { ratio } else { 1.0 }.min(fall);
        for beyond in (k + 2..2 * nodes).step_by(2) {
            let steeper = (k - 2) as f64 / (beyond - 2) as f64;
            c[beyond - 1] = c[beyond - 3] * falls * steeper.powf(steepening);
        }
    }
    (kinks * fall.min(1.0).powi(POWER_OF_FALL)).max(OF_ANALYTIC * missing_sum(&c))
}

/// The claim for a section that is singular at an end of its range, given its resolved modes. Points off the nodes don't lower it: what lies beyond
/// is most of all near the end, where few of them are.
fn of_end(c: &[f64]) -> f64 {
    OF_END * missing_sum(&decay::continued(c))
}

/// Returns the sum of c_j c_(2N-j) over modes of degrees 1 to 2N.
fn missing_sum(c: &[f64]) -> f64 {
    let nodes = c.len() / 2;
    let pairs = (1..nodes).map(|j| 2.0 * c[j - 1] * c[2 * nodes - j - 1]);
    pairs.sum::<f64>() + c[nodes - 1] * c[nodes - 1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::distribution::Distribution;

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
    fn points_off_the_nodes_tell_a_sine_from_a_kink() {
        // odd and even modes that end at a fifth: a kink by its nodes, unless what follows is a hundredth
        let energies = [1.0, 1.0, 0.04, 0.04];
        let claim = |beyond| tail_with(&energies, true, beyond).unwrap().missing;
        let alone = claim(None);
        assert!(alone > 0.05 && claim(Some(0.1)) == alone);
        // modes go on falling by 3 (0.01)/0.196 = 0.153 then: 3 (c_5^2 + 2 c_4 c_6 + ..), with c_4 = 0.139 and c_1 = 0.69, is 0.037
        let told = claim(Some(0.01));
        assert!((told - 0.037).abs() < 1e-3, "{told}");
        // modes that don't fall aren't believed to end
        let rough = [1.0, 1.0, 0.5, 0.5];
        assert_eq!(tail_with(&rough, true, Some(1e-6)), tail(&rough, true));
    }

    /// Ratio of the claimed to the true missing share of a section of this variance on [0, 1].
    fn claimed_over_true(nodes: usize, f: impl Fn(f64) -> f64, variance: f64) -> f64 {
        let rule = Distribution::uniform(0.0, 1.0)
            .unwrap()
            .gauss_rule(nodes)
            .unwrap();
        let y: Vec<f64> = rule.nodes.iter().map(|t| f(*t)).collect();
        let energies: Vec<f64> = (1..nodes)
            .map(|k| rule.coefficient(k, &y).powi(2))
            .collect();
        let seen: f64 = energies.iter().sum();
        missing(&energies) * seen / (seen - variance).abs()
    }

    /// Sums are 0.8 to 1.7 of the true error, and twice that is claimed; one exponent is taken for many degrees, so that 4 is allowed for. By the two
    /// other suspicions it was a tenth of the error of t^0.5 at 9 nodes, a fifteenth at 5.
    #[test]
    fn singular_ends_are_covered_at_every_size() {
        for nodes in [5, 7, 9, 17, 33] {
            for a in [0.3f64, 0.4, 0.5, 0.6, 0.7, 0.8] {
                let variance = 1.0 / (2.0 * a + 1.0) - (a + 1.0).powi(-2);
                let ratio = claimed_over_true(nodes, |t: f64| t.powf(a), variance);
                assert!((1.0..4.0).contains(&ratio), "{nodes} {a}: {ratio}");
            }
        }
    }

    /// acos t is half sqrt(1 - t), half smooth: a fifteenth of its error was claimed.
    #[test]
    fn a_smooth_part_as_large_hides_no_infinite_slope() {
        let variance = std::f64::consts::PI - 3.0;
        let ratio = claimed_over_true(5, f64::acos, variance);
        assert!((1.0..4.0).contains(&ratio), "{ratio}");
        // t/(t + b) falls nearly as slowly and has a variance that five nodes see: 1 - 2 b L + b/(1 + b) - (1 - b L)^2 with L = ln(1 + 1/b)
        let b = 0.3f64;
        let l = (1.0 + 1.0 / b).ln();
        let variance = b / (1.0 + b) - (b * l).powi(2);
        assert!(claimed_over_true(5, |t| t / (t + b), variance) < 25.0);
    }

    #[test]
    fn two_modes_are_the_least() {
        assert_eq!(tail(&[1.0], true), None);
        assert_eq!(missing(&[0.0, 0.0]), 0.0);
        assert_eq!(missing(&[0.0, 1.0]), OF_KINKS_BY_FEW);
        assert_eq!(missing(&[1.0, 0.0]), 0.0);
    }

    #[test]
    fn lost_nodes_cost_accuracy() {
        let energies = [1.0, 0.01, 1e-4];
        assert!(tail(&energies, false).unwrap().missing > 5.0 * missing(&energies));
    }
}
