//! Decay of modes as it was seen, and what follows of those beyond: the suspicion that a section is singular at an end of its range.
//!
//! Of a section like t^a from t = 0 on, or log t, the modes fall like k^-p in all places alike (p = 2a + 3/2 on a uniform law), of an analytic one
//! geometrically, of one that is nearly singular somehow between. With the exponent p = -d ln c/d ln k at the degree K,
//!
//! ```text
//! p(k) = p (k/K)^g,   c_k = c_m exp(-integral p(k) d ln k)       g = 0: algebraic, g = 1: geometric
//! ```
//!
//! p is taken from the last octave of the modes, m/2 to m, and g from how p differs in the octave before. Of fewer than [`OCTAVES`] modes only
//! the last octave is there: its halves tell g, and even and odd modes are taken together, as singularities at one end have both alike. Where the
//! halves don't agree on an algebraic fall, a smooth part as large may hide one: the last half goes on algebraically if it falls as slowly as at an
//! infinite slope and the fall slowed down before. Where one kind is missing, as of |x| or sqrt(1 - x^2), the other
//! goes on algebraically if it falls as slowly as at an infinite slope.
//!
//! Modes beyond the rule's are seen in those that it resolves: at the nodes p_(2N-k) is about -p_k, so that a mode of degree k shows as c_k - c_(2N-k).
//! Near the end of the modes most is lost by that, and they seem to fall faster than they do.
//!
//! Kinks inside the range have modes that wave. Where modes stray from their law nothing is claimed here.

use std::ops::{Range, RangeInclusive};

/// Modes from which each parity has two octaves.
const OCTAVES: usize = 8;
/// Least exponent: of a section that still has a variance.
const LEAST_EXPONENT: f64 = 0.5;
/// Largest g: what falls faster than geometrically is another suspicion's.
const GEOMETRIC: f64 = 1.0;
/// Range of g in which three modes say something of an end's singularity: it scatters a little about 0, and of analytic sections is 1 on a
/// uniform law and 1/2 on a normal one.
const GROWTH_OF_THREE: Range<f64> = -0.25..0.5;
/// Largest g at which a smooth part may hide a singular end's fall: acos t has 1.1 at five nodes. Exponentials that fall
/// as slowly have 1.3 and more on a normal law, 1.9 on a uniform one.
const GROWTH_BESIDE_SMOOTH: f64 = 1.15;
/// Range of p there, where the fall slows down before, as behind a smooth part: from an infinite value to a square root's slope. acos t has 2.5 at five
/// nodes.
const SLOPE_BESIDE_SMOOTH: Range<f64> = 1.5..2.6;
/// Largest p of an infinite slope, of t^a with a = 0.8.
const OF_INFINITE_SLOPE: f64 = 3.1;
/// Largest factor by which a mode strays from the power law between the ends of an octave.
const STRAYING: f64 = 1.5;
/// A mode this small is rounding.
const NOTHING: f64 = 1e-10;
/// Steps to the exponent of modes that have lost a part of what they are.
const STEPS: usize = 16;

/// Resolved modes, over the standard deviation.
struct Modes<'a>(&'a [f64]);

/// Law by which modes fall.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Law {
    exponent: f64,
    /// K
    at: f64,
    growth: f64,
}

/// The modes c_k of degrees 1 to 2N, those from N on continued by the decay of the resolved ones and 0 where that follows no law.
pub(super) fn continued(c: &[f64]) -> Vec<f64> {
    let (modes, last) = (Modes(c), c.len());
    let mut all = c.to_vec();
    all.resize(2 * (last + 1), 0.0);
    for degree in [last - 1, last] {
        let law = match last < OCTAVES {
            true => modes.law_of_all().or_else(|| modes.law_of_two(degree)),
            false => modes.law_of_parity(degree),
        };
        if let Some(law) = law {
            modes.go_on(&mut all, degree, law);
        }
    }
    all
}

impl Law {
    /// c_to/c_from
    fn fall(&self, from: usize, to: usize) -> f64 {
        let [from, to] = [from, to].map(|k| k as f64 / self.at);
        let integral = match self.growth {
            g if g < f64::EPSILON => (to / from).ln(),
            g => (to.powf(g) - from.powf(g)) / g,
        };
        (-self.exponent * integral).exp()
    }
}

impl Modes<'_> {
    /// Share of the mode of this degree that the nodes show, where modes fall like k^-p.
    fn shown(&self, degree: usize, exponent: f64) -> f64 {
        let nodes = self.0.len() + 1;
        let ratio = degree as f64 / (2 * nodes - degree) as f64;
        1.0 - ratio.powf(exponent.max(LEAST_EXPONENT))
    }

    /// c_k, where modes fall like k^-p.
    fn whole(&self, degree: usize, exponent: f64) -> f64 {
        self.0[degree - 1] / self.shown(degree, exponent)
    }

    /// p between two degrees, by fixed-point steps; `None` where a mode is rounding.
    fn exponent(&self, octave: &RangeInclusive<usize>) -> Option<f64> {
        let (low, high) = (*octave.start(), *octave.end());
        if low >= high || self.0[low - 1] < NOTHING || self.0[high - 1] < NOTHING {
            return None;
        }
        let width = (high as f64 / low as f64).ln();
        let by = |p: f64| (self.whole(low, p) / self.whole(high, p)).ln() / width;
        let start = (self.0[low - 1] / self.0[high - 1]).ln() / width;
        Some((0..STEPS).fold(start, |p, _| by(p)))
    }

    /// p of modes that fall.
    fn falling(&self, octave: &RangeInclusive<usize>) -> Option<f64> {
        self.exponent(octave).filter(|p| *p >= LEAST_EXPONENT)
    }

    /// Law of the last octave of all modes.
    fn law_of_all(&self) -> Option<Law> {
        let last = self.0.len();
        let (first, middle) = (last / 2, (last + last / 2) / 2);
        let [before, after] = [first..=middle, middle..=last];
        let (previous, exponent) = (self.falling(&before)?, self.falling(&after)?);
        let growth = growth((previous, centre(&before)), (exponent, centre(&after)));
        if GROWTH_OF_THREE.contains(&growth) {
            let octave = first..=last;
            return Some(Law {
                exponent: self.falling(&octave)?,
                at: centre(&octave),
                growth: growth.max(0.0),
            });
        }
        let earlier = self.exponent(&((first / 2).max(1)..=first));
        let slowed_down = earlier.is_some_and(|p| p > previous);
        let is_beside_smooth = (GROWTH_OF_THREE.end..GROWTH_BESIDE_SMOOTH).contains(&growth);
        (slowed_down && is_beside_smooth && SLOPE_BESIDE_SMOOTH.contains(&exponent)).then_some(
            Law {
                exponent,
                at: centre(&after),
                growth: 0.0,
            },
        )
    }

    /// Law of the last two modes of a section that is even or odd about its middle: two don't tell g, and only as slow a fall as at an infinite slope
    /// is taken for one.
    fn law_of_two(&self, degree: usize) -> Option<Law> {
        let others = self.0.iter().skip(degree % 2).step_by(2);
        let octave = degree.checked_sub(2).filter(|low| *low > 0)?..=degree;
        let exponent = self.falling(&octave).filter(|p| *p <= OF_INFINITE_SLOPE)?;
        (others.copied().fold(0.0, f64::max) < NOTHING).then_some(Law {
            exponent,
            at: centre(&octave),
            growth: 0.0,
        })
    }

    /// Law of the modes of one parity up to a degree.
    fn law_of_parity(&self, degree: usize) -> Option<Law> {
        let octave = half(degree)..=degree;
        let before = half(*octave.start())..=*octave.start();
        let exponent = self.falling(&octave)?;
        let at_start = self.whole(*octave.start(), exponent);
        let strays = |k: usize| {
            let by_law = at_start * (k as f64 / *octave.start() as f64).powf(-exponent);
            (self.whole(k, exponent) / by_law).ln().abs() > STRAYING.ln()
        };
        if octave.clone().step_by(2).any(strays) {
            return None;
        }
        let at = centre(&octave);
        let earlier = self.exponent(&before)?.max(LEAST_EXPONENT);
        let growth = growth((earlier, centre(&before)), (exponent, at));
        Some(Law {
            exponent,
            at,
            growth: growth.clamp(0.0, GEOMETRIC),
        })
    }

    /// Continues every second mode from a degree on.
    fn go_on(&self, all: &mut [f64], degree: usize, law: Law) {
        let last = self.whole(degree, law.exponent);
        for beyond in (degree + 2..=all.len()).step_by(2) {
            all[beyond - 1] = last * law.fall(degree, beyond);
        }
    }
}

/// Half of a degree, or somewhat less, of the same parity and at least 1.
fn half(degree: usize) -> usize {
    let half = (degree / 2).max(1);
    match (degree - half) % 2 {
        0 => half,
        _ if half > 1 => half - 1,
        _ => half + 1,
    }
}

/// Degree in the middle of an octave, in logarithms.
fn centre(octave: &RangeInclusive<usize>) -> f64 {
    ((octave.start() * octave.end()) as f64).sqrt()
}

/// g by two exponents, each at its degree.
fn growth((before, at): (f64, f64), (exponent, later): (f64, f64)) -> f64 {
    (exponent / before).ln() / (later / at).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Modes of degrees 1 to N-1 that a rule shows of these.
    fn shown(nodes: usize, whole: impl Fn(f64) -> f64) -> Vec<f64> {
        let of_degree = |k: usize| whole(k as f64) - whole((2 * nodes - k) as f64);
        (1..nodes).map(of_degree).collect()
    }

    #[test]
    fn what_falls_by_a_law_goes_on_by_it() {
        for nodes in [5, 6, 9, 17, 33] {
            for exponent in [1.5, 2.5, 4.0] {
                let law = |k: f64| k.powf(-exponent);
                for (k, c) in continued(&shown(nodes, law)).iter().enumerate() {
                    let expected = law((k + 1) as f64);
                    let resolved = k + 1 < nodes;
                    // the modes are what the law takes them for, but for the steps to the exponent
                    assert!(
                        resolved || (c / expected - 1.0).abs() < 1e-2,
                        "{nodes} {exponent} {k}: {c} {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn what_falls_geometrically_goes_on_so_where_two_octaves_show_it() {
        let law = |k: f64| 0.6f64.powf(k);
        let c = shown(17, law);
        // of the last mode the nodes hide 0.6^2, of a power law's as steep a half: modes beyond are overrated by that and by its part in the exponent
        for degree in [18, 20, 24] {
            let ratio = continued(&c)[degree - 1] / law(degree as f64);
            assert!((1.0..3.0).contains(&ratio), "{degree} {ratio}");
        }
        assert_eq!(continued(&c[..4])[4..], [0.0; 6]);
    }

    #[test]
    fn waves_and_rounding_follow_no_law() {
        let nodes = 17;
        let wave = |k: f64| (0.7 * k).cos().abs() * k.powi(-2);
        let rest = |c: &[f64]| continued(c)[c.len()..].iter().sum::<f64>();
        assert_eq!(rest(&shown(nodes, wave)), 0.0);
        let rounding: Vec<f64> = (1..nodes)
            .map(|k| 0.01f64.powi(k as i32).max(1e-16))
            .collect();
        assert_eq!(rest(&rounding), 0.0);
    }

    #[test]
    fn of_two_modes_only_a_slow_fall_goes_on() {
        // of t^0.5 about, and of a cosine
        let beyond = |last: f64| continued(&[1.0, 0.0, last, 0.0])[6];
        assert!(beyond(0.06) > 0.06 / 8.0 && beyond(0.06) < 0.06);
        assert_eq!(beyond(0.01), 0.0);
        // one exponent for each parity is none for a section that has both
        assert_eq!(continued(&[1.0, 0.5, 0.06, 0.4])[4..], [0.0; 6]);
    }
}
