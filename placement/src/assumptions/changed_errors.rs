//! Errors of layouts as assumed, and with an assumption changed.

use super::changed::Changed;
use crate::answer::{Figure, Figures};
use documents::study::question::Question;
use layouts::arrangement::Arrangement;
use layouts::field::film_field::Noise;
use layouts::ranking::layout_scores::{LargestErrors, Scorer};
use layouts::simulate::drawn_contacts::TrueContact;
use layouts::simulate::draws::Draws;
use results::AssumptionChange;

use crate::layout::solving::layout_fields::MeshFields;

/// Standard errors of the simulation by which another layout must do better.
const DEVIATIONS: f64 = 2.0;

/// Layouts whose errors are compared, the one that answers first, with their ranks.
pub(super) struct Compared<'a> {
    pub fields: &'a MeshFields,
    pub noise: Noise,
    pub draws: &'a Draws,
    pub layouts: Vec<(usize, &'a Arrangement)>,
    /// Figures of the first as assumed.
    pub assumed: Figures,
    pub question: Question,
}

impl Compared<'_> {
    fn errors(&self, noise: Noise, contacts: Option<&[TrueContact]>) -> Vec<LargestErrors> {
        let arrangements = || self.layouts.iter().map(|(_, arrangement)| *arrangement);
        let fields = &self.fields.fields;
        let (depths, draws) = (self.fields.depths(), self.draws.clone());
        let scorer = Scorer::new(fields, noise, depths, arrangements(), draws, false);
        arrangements()
            .map(|arrangement| scorer.largest_errors(arrangement, contacts))
            .collect()
    }

    /// Errors with a change, or with contacts that are taken for others, beside those as assumed.
    pub fn changed(&self, change: &Changed, contacts: Option<&[TrueContact]>) -> AssumptionChange {
        let errors = self.errors(change.noise(self.noise, self.fields.crown), contacts);
        let own = errors[0];
        let both = [
            times(self.assumed.angle, own.angle_deg),
            times(self.assumed.force, own.force_n),
        ];
        let others = self.layouts.iter().zip(&errors).skip(1);
        let better = others.filter(|(_, errors)| self.is_better(errors, &own));
        let best = better.min_by(|(_, a), (_, b)| self.value(a).total_cmp(&self.value(b)));
        let assumed = self.assumed.compared(&self.question);
        let was_kept = self.question.has_limits() && assumed.is_some_and(|own| own.value <= 1.0);
        AssumptionChange {
            of: change.name().to_owned(),
            words: change.words(),
            angle_error_deg: own.angle_deg,
            force_error_n: own.force_n,
            times: both.into_iter().flatten().fold(1.0, f64::max),
            better_rank: best.map(|((rank, _), _)| *rank),
            meets: was_kept.then(|| self.value(&own) <= 1.0),
        }
    }

    /// Figure that layouts are compared by, with what chance leaves open.
    fn figure(&self, errors: &LargestErrors) -> Figure {
        let figure = |value: f64, se: f64| {
            Some(Figure {
                value,
                claim: Some(DEVIATIONS * se),
            })
        };
        let figures = Figures {
            angle: figure(errors.angle_deg, errors.angle_se_deg),
            force: figure(errors.force_n, errors.force_se_n),
        };
        figures.compared(&self.question).unwrap_or(Figure {
            value: f64::INFINITY,
            claim: None,
        })
    }

    fn value(&self, errors: &LargestErrors) -> f64 {
        self.figure(errors).value
    }

    fn is_better(&self, other: &LargestErrors, own: &LargestErrors) -> bool {
        let [other, own] = [other, own].map(|errors| self.figure(errors));
        let open = other.claim.unwrap_or(0.0).hypot(own.claim.unwrap_or(0.0));
        other.value + open < own.value
    }
}

/// Times by which a changed figure is larger than it was, or smaller; none of one that is 0.
fn times(assumed: Option<Figure>, changed: f64) -> Option<f64> {
    let ratio = changed / assumed?.value;
    let times = ratio.max(1.0 / ratio);
    times.is_finite().then_some(times)
}
