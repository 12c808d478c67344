//! Figures of layouts that answers go by: errors of angle and force with their claims.

use documents::study::question::Question;
use results::{RankedLayout, TradeRow};

use super::figure_words::with_error;

/// Figure of a layout that is known only to within a claim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Figure {
    pub value: f64,
    /// Claimed error; none where there is no coarser mesh.
    pub claim: Option<f64>,
}

impl Figure {
    fn over(self, limit: f64) -> Self {
        Self {
            value: self.value / limit,
            claim: self.claim.map(|claim| claim / limit),
        }
    }
}

/// Errors of a layout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Figures {
    /// Error of the angle, degrees; none of a layout without a score.
    pub angle: Option<Figure>,
    /// Error of the vertical force at the load where it is largest, N.
    pub force: Option<Figure>,
}

impl Figures {
    pub(crate) fn of(layout: &RankedLayout) -> Self {
        let error = layout.score.error.as_ref();
        let angle = layout.score.simulated_p95_angle_error_deg;
        Self {
            angle: angle.map(|value| Figure {
                value,
                claim: error.and_then(|error| error.simulated_p95_angle_error_deg),
            }),
            force: layout.largest_force_error().map(|force| Figure {
                value: force.error_n,
                claim: force.claim_n,
            }),
        }
    }

    pub(crate) fn of_row(row: &TradeRow) -> Self {
        Self {
            angle: Some(Figure {
                value: row.angle_error_deg,
                claim: row.angle_claim_deg,
            }),
            force: row.force_error_n.map(|value| Figure {
                value,
                claim: row.force_claim_n,
            }),
        }
    }

    /// Returns what layouts are compared by: the angle's error; where limits are asked, the largest error over its limit.
    pub(crate) fn compared(&self, question: &Question) -> Option<Figure> {
        if !question.has_limits() {
            return self.angle;
        }
        let over = |figure: Option<Figure>, limit: Option<f64>| Some(figure?.over(limit?));
        let shares = [
            over(self.angle, question.angle_deg),
            over(self.force, question.force_n),
        ];
        let shares = shares.into_iter().flatten();
        shares.max_by(|a, b| a.value.total_cmp(&b.value))
    }

    /// The figures that are asked for with their claims: `10.7 +- 1.8 degrees`, `0.81 +- 0.05 N`, or both.
    pub(crate) fn words(&self, question: &Question) -> String {
        let with_claim = |figure: Figure| with_error(figure.value, figure.claim);
        self.asked(question, with_claim).join(" and ")
    }

    /// The figures that are asked for in few characters: `10.7 degrees, 0.81 N`.
    pub(super) fn brief(&self, question: &Question) -> String {
        self.asked(question, |figure| three_digits(figure.value))
            .join(", ")
    }

    fn asked(&self, question: &Question, told: impl Fn(Figure) -> String) -> Vec<String> {
        let is_forced = question.force_n.is_some() && self.force.is_some();
        let angle = self
            .angle
            .filter(|_| question.angle_deg.is_some() || !is_forced);
        let force = self.force.filter(|_| is_forced);
        let both = [(angle, "degrees"), (force, "N")];
        let both = both
            .into_iter()
            .filter_map(|(figure, unit)| Some((figure?, unit)));
        both.map(|(figure, unit)| format!("{} {unit}", told(figure)))
            .collect()
    }
}

/// `10.7`, `0.869`, `154.7`: three digits, and whatever stands before the point.
pub(super) fn three_digits(value: f64) -> String {
    let size = value.abs().max(1e-3).log10().floor();
    let decimals = (2.0 - size).clamp(0.0, 4.0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figures() -> Figures {
        let figure = |value: f64, claim: f64| {
            Some(Figure {
                value,
                claim: Some(claim),
            })
        };
        Figures {
            angle: figure(10.65, 1.8),
            force: figure(0.812, 0.05),
        }
    }

    fn asking(angle_deg: Option<f64>, force_n: Option<f64>) -> Question {
        Question {
            angle_deg,
            force_n,
            ..Question::default()
        }
    }

    #[test]
    fn what_is_asked_is_told_and_compared() {
        let cases = [
            (
                asking(None, None),
                "10.7 +- 1.8 degrees",
                "10.7 degrees",
                10.65,
            ),
            (
                asking(Some(5.0), None),
                "10.7 +- 1.8 degrees",
                "10.7 degrees",
                2.13,
            ),
            (asking(None, Some(0.4)), "0.812 +- 0.050 N", "0.812 N", 2.03),
            (
                asking(Some(5.0), Some(0.2)),
                "10.7 +- 1.8 degrees and 0.812 +- 0.050 N",
                "10.7 degrees, 0.812 N",
                4.06,
            ),
        ];
        for (question, words, brief, value) in cases {
            assert_eq!(figures().words(&question), words);
            assert_eq!(figures().brief(&question), brief);
            let compared = figures().compared(&question).expect("known").value;
            assert!((compared - value).abs() < 1e-12, "{compared}");
        }
    }

    #[test]
    fn three_digits_are_told() {
        let told = [154.7196, 10.65484, 0.868757, 0.000012, 0.0].map(three_digits);
        assert_eq!(told, ["155", "10.7", "0.869", "0.0000", "0.0000"]);
    }
}
