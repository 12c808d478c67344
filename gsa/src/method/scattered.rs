//! Basis of the methods on scattered points.

use crate::judge::index_error::ErrorParts;
use crate::method::analysis::{Analysis, Form, Status};

/// Indices of one output, and which points gave no number.
pub(crate) struct Scattered {
    pub(crate) mean: f64,
    pub(crate) variance: f64,
    pub(crate) first_order: Vec<f64>,
    pub(crate) total: Vec<f64>,
    pub(crate) second_order: Option<Vec<f64>>,
    pub(crate) error: ErrorParts,
    pub(crate) lost: Vec<usize>,
}

/// The answer for an output with these values; `found` is `None` if it doesn't vary or too few of them are numbers.
pub(crate) fn answer(found: Option<Scattered>, values: &[f64], method: Form) -> Analysis {
    let Some(found) = found else {
        return without_indices(values, method);
    };
    let mut analysis = Analysis {
        mean: Some(found.mean).filter(|m| m.is_finite()),
        variance: Some(found.variance).filter(|v| v.is_finite() && *v > 0.0),
        first_order: Some(found.first_order),
        total: Some(found.total),
        second_order: found.second_order,
        method,
        status: Status::Ok,
        error: found.error,
        ..Analysis::empty(0.0)
    };
    analysis.note_lost("left out points without a finite value", &found.lost);
    if analysis.variance.is_none() || analysis.mean.is_none() {
        analysis.note("the mean or the variance is beyond the range of double precision");
    }
    analysis
}

/// Returns what remains to be said where there are no indices.
fn without_indices(values: &[f64], method: Form) -> Analysis {
    let finite: Vec<f64> = values.iter().copied().filter(|y| y.is_finite()).collect();
    let constant = finite.len() > 1 && finite.iter().all(|y| close(*y, finite[0]));
    let (status, reason) = if constant {
        (
            Status::Constant,
            "the output does not vary beyond the rounding of its values",
        )
    } else {
        (
            Status::Unusable,
            "too few points gave a finite value, or no part of the variation could be resolved",
        )
    };
    Analysis {
        mean: finite.first().copied().filter(|_| constant),
        variance: constant.then_some(0.0),
        method,
        status,
        reason: Some(reason.to_owned()),
        ..Analysis::empty(1.0)
    }
}

/// Whether two values are equal to the rounding of a model of a few operations.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 8.0 * f64::EPSILON * a.abs().max(b.abs())
}
