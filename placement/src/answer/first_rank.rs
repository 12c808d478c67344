//! Certainty of a first rank, by the difference from every other and the errors of both.
//!
//! | verdict | the difference from the first |
//! | --- | --- |
//! | certain | makes the first first with a probability of 0.95, as for certain ranks ([`gsa::judge::certainty`]); always so where it is larger than both errors together |
//! | likely | is larger than the larger error |
//! | tied | is not |
//! | unknown | can't be told: an error is missing |
//!
//! Those that share the first rank, as mirror images do, are equal, and not compared.

use gsa::judge::certainty::{CERTAIN, Estimate};

use results::Certainty;

/// Figure that an order goes by; the greatest is first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Standing {
    pub value: f64,
    /// Distances down and up by which it may be off; `None` where they aren't known.
    pub off: Option<[f64; 2]>,
}

/// Judgement of a first rank against the others.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Judged {
    /// The weakest of all comparisons.
    pub verdict: Certainty,
    /// Numbers of the others that can't be told from the first.
    pub tied: Vec<usize>,
    /// Number of the other that comes closest: the first one of those with the weakest verdict.
    pub closest: Option<usize>,
}

impl Judged {
    /// Reason for the verdict in a sentence: how the first is told from the next, with the figures of both.
    pub(super) fn reason(&self, next: &str, figures: &str) -> String {
        match self.verdict {
            Certainty::Certain => format!("No other does as much: {figures}."),
            Certainty::Likely => {
                format!("The next is farther off than either error, and not than both: {figures}.")
            }
            Certainty::Tied => format!("The errors can't tell {next} from it: {figures}."),
            Certainty::Unknown => format!("How far off the figures are isn't known: {figures}."),
        }
    }
}

/// Judges the first by the others, which are in their order, best first.
pub(crate) fn judge(first: &Standing, others: &[Standing]) -> Judged {
    let verdicts: Vec<Certainty> = others.iter().map(|other| told(first, other)).collect();
    let known = match first.off {
        Some(_) => Certainty::Certain,
        None => Certainty::Unknown,
    };
    let weakest = verdicts.iter().copied().fold(known, Certainty::max);
    let of = |verdict: Certainty| (0..others.len()).filter(move |&k| verdicts[k] == verdict);
    Judged {
        verdict: weakest,
        tied: of.clone()(Certainty::Tied).collect(),
        closest: of(weakest).next(),
    }
}

/// Judges how far one other is told from the first.
fn told(first: &Standing, other: &Standing) -> Certainty {
    let (Some([less, _]), Some([_, more])) = (first.off, other.off) else {
        return Certainty::Unknown;
    };
    let estimate = |value, error| Estimate { value, error };
    let (first, other) = (estimate(first.value, less), estimate(other.value, more));
    if first.outranks(&other, 0.0) >= CERTAIN {
        Certainty::Certain
    } else if first.value - other.value > less.max(more) {
        Certainty::Likely
    } else {
        Certainty::Tied
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn standing(value: f64, error: f64) -> Standing {
        let off = error.is_finite().then_some([error; 2]);
        Standing { value, off }
    }

    #[test]
    fn every_verdict_is_reached() {
        let first = standing(10.0, 2.0);
        let judged = |other: Standing| judge(&first, &[other, standing(1.0, 0.1)]);
        // Of two errors of 2 the probability is 0.95 at a difference of 2.33.
        let cases = [
            (5.9, 2.0, Certainty::Certain, vec![]),
            (7.6, 2.0, Certainty::Certain, vec![]),
            (7.8, 2.0, Certainty::Likely, vec![]),
            (8.1, 2.0, Certainty::Tied, vec![0]),
            (7.8, 4.0, Certainty::Tied, vec![0]),
            (6.1, f64::INFINITY, Certainty::Unknown, vec![]),
        ];
        for (value, error, verdict, tied) in cases {
            let found = judged(standing(value, error));
            assert_eq!((found.verdict, found.tied), (verdict, tied), "{value}");
            assert_eq!(found.closest, Some(0));
        }
        let exact = |value| standing(value, 0.0);
        assert_eq!(
            judge(&exact(2.0), &[exact(1.0)]).verdict,
            Certainty::Certain
        );
    }

    #[test]
    fn who_has_no_rival_is_certain_with_an_error_alone() {
        let alone = |error| judge(&standing(10.0, error), &[]);
        assert_eq!(alone(3.0).verdict, Certainty::Certain);
        assert_eq!(alone(3.0).closest, None);
        assert_eq!(alone(f64::INFINITY).verdict, Certainty::Unknown);
    }

    #[test]
    fn the_closest_is_the_best_of_those_that_are_told_least() {
        let others = [
            standing(8.5, 0.1),
            standing(8.0, 2.9),
            standing(7.9, 3.2),
            standing(1.0, 3.3),
        ];
        let found = judge(&standing(10.0, 1.0), &others);
        assert_eq!(
            (found.verdict, found.tied, found.closest),
            (Certainty::Tied, vec![1, 2], Some(1))
        );
    }
}
