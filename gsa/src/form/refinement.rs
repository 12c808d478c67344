//! Misses of a line that has been refined: the coarser lines' errors are then known, and how errors fall, too.
//!
//! A claim from the end of the modes alone (`spectrum`) must allow for whatever function ends so. Where an input's rule was refined
//! from N_0 over N_1, .. to N nodes, with variances v_0, v_1, .., v and amplitudes s_0, s_1, .., s at the end of the modes, the error
//! of rule k was |v_k - v|/v, and it is expected to have fallen to
//!
//! ```text
//! |v_k - v|/v min(N_k/N, (s/s_k) (N/N_k)^2)
//! ```
//!
//! At a step s falls like N^-1 and at a kink like N^-2, and the bound is N_k/N: a step's error does fall so, a kink's faster. Of an
//! analytic section s falls like its modes, and the bound with it.
//!
//! Where the law's range is unbounded the nodes in its middle come closer like N^-1/2 only, and N_k/N is the root of that. That is allowed for where
//! several coarser lines speak against the modes, s falls slower than N^-2 (at a kink there like N^-5/4), and the errors seen do fall slower than 1/N.

use crate::form::spectrum::{MOST_MISSING, Tail};

/// Errors at kinks and steps scatter by their place between the nodes: that of a rule is seldom more than this times the error
/// seen of a coarser one and its fall.
const OBSERVED: f64 = 4.0;
/// Lines are refined until their error looks small enough, which favours those whose error looks smaller than it is.
const STOPPING: f64 = 2.0;
/// Returns the factor on claims of single lines.
pub(crate) fn stopping(refined_on_demand: bool) -> f64 {
    if refined_on_demand { STOPPING } else { 1.0 }
}

/// Error that one of an input's lines shows.
pub(crate) struct Level {
    pub(crate) nodes: usize,
    /// whether the law's range has two ends
    pub(crate) is_bounded: bool,
    pub(crate) tail: Tail,
    /// difference of its variance from the finest line's, as a share of that
    pub(crate) error: f64,
}

impl Level {
    /// The missing share of the finest line, given the coarser ones it replaced: by the modes of the last two lines, and by the
    /// errors seen of all coarser ones. A single error seen may be small by chance, so it can only raise the modes' claim. The
    /// largest of several hardly is, since each saw a kink in another phase; then the smaller claim counts.
    pub(crate) fn missing(&self, coarser: &[Self], stopping: f64) -> f64 {
        let before = coarser.last().map_or(0.0, |level| {
            level.tail.missing * self.fall_of_amplitude(level).min(1.0)
        });
        let by_modes = stopping * self.tail.missing.max(before);
        let is_slow = !self.is_bounded && coarser.len() > 1 && self.follows_slowly(coarser);
        let seen = coarser
            .iter()
            .map(|level| level.error * self.fall(level, is_slow));
        let observed = OBSERVED * seen.fold(0.0, f64::max);
        let missing = match coarser.len() {
            0 => by_modes,
            1 => by_modes.max(observed),
            _ => by_modes.min(observed),
        };
        missing.min(MOST_MISSING)
    }

    /// Returns the ratio of the error to what is seen of a coarser line's: as the distance of nodes, as at a step, and as much more as the amplitudes
    /// at the end of the modes fall faster than the N^-2 of a kink.
    fn fall(&self, coarser: &Self, is_slow: bool) -> f64 {
        let ratio = coarser.nodes as f64 / self.nodes as f64;
        let of_modes = self.fall_of_amplitude(coarser) / (ratio * ratio);
        if !is_slow || of_modes < 1.0 {
            return of_modes.min(ratio);
        }
        ratio.sqrt()
    }

    /// Whether the differences of some coarser lines from this one fall from each to the next, and slower than those of errors like 1/N.
    fn follows_slowly(&self, coarser: &[Self]) -> bool {
        let like_inverse = |level: &Self| 1.0 / level.nodes as f64 - 1.0 / self.nodes as f64;
        coarser.windows(2).all(|pair| {
            let least = like_inverse(&pair[1]) / like_inverse(&pair[0]);
            (least..1.0).contains(&(pair[1].error / pair[0].error))
        })
    }

    /// Returns the ratio of the amplitudes, 1 where the coarser line ends in nothing.
    fn fall_of_amplitude(&self, coarser: &Self) -> f64 {
        if coarser.tail.amplitude > 0.0 {
            self.tail.amplitude / coarser.tail.amplitude
        } else {
            1.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::form::spectrum::tail;
    use crate::law::distribution::Distribution;

    fn uniform() -> Distribution {
        Distribution::uniform(-1.0, 1.0).unwrap()
    }

    /// Variance and tail by a rule of x.
    fn seen(law: &Distribution, nodes: usize, f: &dyn Fn(f64) -> f64) -> (f64, Tail) {
        let rule = law.gauss_rule(nodes).unwrap();
        let y: Vec<f64> = rule.nodes.iter().map(|&x| f(x)).collect();
        let energies: Vec<f64> = (1..nodes)
            .map(|k| rule.coefficient(k, &y).powi(2))
            .collect();
        (energies.iter().sum(), tail(&energies, true).unwrap())
    }

    /// Claimed and true missing share at the last of the sizes.
    fn claim(
        law: &Distribution,
        sizes: &[usize],
        f: &dyn Fn(f64) -> f64,
        variance: f64,
    ) -> (f64, f64) {
        let (finest, _) = seen(law, *sizes.last().unwrap(), f);
        let level = |&nodes: &usize| {
            let (v, tail) = seen(law, nodes, f);
            let error = (v - finest).abs() / finest;
            Level {
                nodes,
                is_bounded: law.support().1.is_finite(),
                tail,
                error,
            }
        };
        let levels: Vec<Level> = sizes.iter().map(level).collect();
        let (last, coarser) = levels.split_last().unwrap();
        let truth = (finest - variance).abs() / finest;
        (last.missing(coarser, STOPPING), truth.clamp(1e-13, 1.0))
    }

    /// Share covered, median claim and median of claimed over true error, over 200 phases between -0.9 and 0.9.
    fn table(
        sizes: &[usize],
        case: impl Fn(f64) -> (Box<dyn Fn(f64) -> f64>, f64),
    ) -> (f64, f64, f64) {
        let phase = |k: u32| 1.8 * (f64::from(k) * 0.618_033_988_749_895).fract() - 0.9;
        let outcomes: Vec<(f64, f64)> = (1..=200)
            .map(|k| {
                let (f, variance) = case(phase(k));
                claim(&uniform(), sizes, &f, variance)
            })
            .collect();
        let median = |value: fn(&(f64, f64)) -> f64| {
            let mut values: Vec<f64> = outcomes.iter().map(value).collect();
            values.sort_by(f64::total_cmp);
            values[100]
        };
        let covered = outcomes.iter().filter(|(c, t)| *t <= c.max(1e-13)).count();
        (
            covered as f64 / 200.0,
            median(|o| o.0),
            median(|o| o.0 / o.1),
        )
    }

    fn kink(a: f64) -> (Box<dyn Fn(f64) -> f64>, f64) {
        let mean = 0.5 * (1.0 + a * a);
        (
            Box::new(move |x| (x - a).abs()),
            1.0 / 3.0 + a * a - mean * mean,
        )
    }

    fn step(a: f64) -> (Box<dyn Fn(f64) -> f64>, f64) {
        let above = 0.5 * (1.0 - a);
        (
            Box::new(move |x| f64::from(u8::from(x > a))),
            above * (1.0 - above),
        )
    }

    /// sin(6 x + phase): analytic, but beyond what five nodes resolve.
    fn sine(phase: f64) -> (Box<dyn Fn(f64) -> f64>, f64) {
        let mean = phase.sin() * 6f64.sin() / 6.0;
        let square = 0.5 - (2.0 * phase).cos() * 12f64.sin() / 24.0;
        (
            Box::new(move |x| (6.0 * x + phase).sin()),
            square - mean * mean,
        )
    }

    /// Shares and ratios seen, rounded to the safe side: at kinks 96 % and 9 to 13, at steps 98 % and 6 to 7. An analytic section's
    /// claim falls to rounding once its modes are resolved.
    #[test]
    fn claims_cover_and_fall_as_the_errors_do() {
        let sizes = [5, 9, 17, 33];
        let order = |case: fn(f64) -> _| {
            let [(covered, coarse, ratio), (still, fine, last)] =
                [3, 4].map(|lines| table(&sizes[..lines], case));
            println!("{covered} {coarse:e} {ratio}, {still} {fine:e} {last}");
            assert!(covered >= 0.95 && still >= 0.95);
            (
                (coarse / fine).ln() / (33.0f64 / 17.0).ln(),
                ratio.max(last),
            )
        };
        // between the step's order, which is allowed for, and the kink's own
        let (of_kink, ratio) = order(kink);
        assert!(
            (1.0..2.2).contains(&of_kink) && ratio < 15.0,
            "{of_kink} {ratio}"
        );
        let (of_step, ratio) = order(step);
        assert!(
            (0.6..1.4).contains(&of_step) && ratio < 15.0,
            "{of_step} {ratio}"
        );
        assert!(order(sine).0 > 10.0);
    }

    fn level(nodes: usize, missing: f64, error: f64) -> Level {
        Level {
            nodes,
            is_bounded: true,
            tail: Tail {
                amplitude: 0.1,
                missing,
            },
            error,
        }
    }

    #[test]
    fn a_cusp_on_a_normal_law_is_covered() {
        let law = Distribution::normal(0.0, 1.0).unwrap();
        let root = |z: f64| z.abs().sqrt();
        // E[|z|] - E[sqrt |z|]^2
        let variance = 0.797_884_560_802_865_4 - 0.822_178_958_662_458_8f64.powi(2);
        for sizes in [&[5, 9, 17][..], &[5, 9, 17, 33]] {
            let (claimed, truth) = claim(&law, sizes, &root, variance);
            let ratio = claimed / truth;
            assert!((1.0..4.0).contains(&ratio), "{sizes:?} {ratio}");
        }
    }

    #[test]
    fn errors_fall_slowly_where_the_range_is_unbounded() {
        let unbounded = |level: Level| Level {
            is_bounded: false,
            ..level
        };
        let fine = unbounded(level(36, 1.0, 0.0));
        // nodes twice as close where they are four times as many
        let coarser = |first| [level(4, 1.0, first), level(9, 1.0, 0.02)].map(unbounded);
        assert!((fine.missing(&coarser(0.03), 1.0) - OBSERVED * 0.01).abs() < 1e-15);
        // errors that fall like 1/N or faster, or don't fall, are a step's
        for (first, seen) in [(0.06, 0.06 / 9.0), (0.01, 0.02 / 4.0)] {
            assert!((fine.missing(&coarser(first), 1.0) - OBSERVED * seen).abs() < 1e-15);
        }
    }

    #[test]
    fn one_coarser_line_only_raises_a_claim() {
        let fine = level(9, 1e-3, 0.0);
        let alone = fine.missing(&[], 1.0);
        assert_eq!(alone, 1e-3);
        assert_eq!(fine.missing(&[level(5, 0.0, 0.0)], 1.0), alone);
        // amplitudes that don't fall: like 1/N
        let raised = fine.missing(&[level(5, 0.0, 0.09)], 1.0);
        assert!((raised - OBSERVED * 0.05).abs() < 1e-15);
        let two = [level(5, 0.0, 0.0), level(7, 0.0, 1e-9)];
        assert!(fine.missing(&two, 1.0) < 1e-8);
    }
}
