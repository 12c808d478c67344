//! Failed runs: how much of the inputs' range they stand for, and what that adds to an analysis.

use crate::design::Line;
use crate::judge::failed_share;
use crate::law::distribution::Distribution;
use crate::method::amended::outermost::{beyond_others, deviations};
use crate::method::analysis::Analysis;
use crate::method::procedure::Runs;

/// Runs of an output that gave no number.
struct Failed {
    count: usize,
    of: usize,
    /// Share of the runs, or on a line the probability of its nodes, whichever is more.
    probability: f64,
    /// Distance by which they lie beyond the others, in standard deviations of an input.
    distance: f64,
}

impl Failed {
    fn new(runs: &Runs<'_>, values: &[f64]) -> Self {
        let (points, of, on_lines) = match runs {
            Runs::Lines(design) => {
                let lines = design.lines().iter();
                let lost = lines.map(|line| lost_on(line, values));
                (design.points(), design.to_run(), lost.fold(0.0, f64::max))
            }
            Runs::Scattered(points) => (*points, points.len(), 0.0),
        };
        let failed = values[..of].iter().filter(|y| !y.is_finite());
        let count = failed.count();
        let deviations = match runs {
            Runs::Lines(design) => design.inputs().iter().map(Distribution::std).collect(),
            Runs::Scattered(points) => deviations(points),
        };
        Self {
            count,
            of,
            probability: on_lines.max(count as f64 / of as f64),
            distance: beyond_others(&points[..of], &values[..of], &deviations),
        }
    }
}

/// Probability of a line's nodes without a value.
fn lost_on(line: &Line, values: &[f64]) -> f64 {
    let nodes = line.ordinals().iter().zip(&line.rule().weights);
    let lost = nodes.filter(|(ordinal, _)| !values[**ordinal].is_finite());
    lost.map(|(_, weight)| weight).sum()
}

impl Analysis {
    /// Adds to the errors what the output may do where runs failed; where too many did they say nothing.
    pub(crate) fn with_failed(mut self, runs: &Runs<'_>, values: &[f64]) -> Self {
        let failed = Failed::new(runs, values);
        let several = |indices: &&Vec<f64>| indices.len() > 1;
        let Some(first_order) = self.first_order.as_ref().filter(several) else {
            return self;
        };
        if failed.count == 0 {
            return self;
        }
        let errors = failed_share::errors(first_order, failed.probability, failed.distance);
        self.error.lost = Some(self.error.add(&errors));
        if failed_share::is_too_much(failed.probability) {
            self.note(&format!(
                "{} of {} runs failed, too many to say how far the indices are off: what the output does there isn't known. \
                 Mend these runs, or truncate the laws to where the model runs; more runs, as of the method auto, fail there too",
                failed.count, failed.of
            ));
        }
        self
    }
}
