//! Answers of the methods that use scattered points.

use crate::method::analysis::{Analysis, Status};
use crate::method::pce::Chaos;
use crate::method::saltelli;
use crate::method::verdict::Form;

/// What remains to be said where there are no indices.
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

/// To the rounding of a model of a few operations.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 8.0 * f64::EPSILON * a.abs().max(b.abs())
}

/// One output of a saltelli campaign.
pub(crate) fn saltelli(inputs: usize, values: &[f64]) -> Analysis {
    let Some(found) = saltelli::analyse(inputs, values) else {
        return without_indices(values, Form::Saltelli);
    };
    let indices = Analysis {
        first_order: Some(found.first_order),
        total: Some(found.total),
        method: Form::Saltelli,
        error: found.error,
        ..Analysis::empty(0.0)
    };
    with_moments(indices, (found.mean, found.variance), &found.lost)
}

/// One output of a polynomial chaos campaign.
pub(crate) fn pce(chaos: &Chaos, values: &[f64]) -> Analysis {
    let Some(found) = chaos.analyse(values) else {
        return without_indices(values, Form::Pce);
    };
    let indices = Analysis {
        first_order: Some(found.first_order),
        total: Some(found.total),
        second_order: Some(found.second_order),
        method: Form::Pce,
        error: found.error,
        ..Analysis::empty(0.0)
    };
    with_moments(indices, (found.mean, found.variance), &found.lost)
}

fn with_moments(indices: Analysis, (mean, variance): (f64, f64), lost: &[usize]) -> Analysis {
    let mut analysis = Analysis {
        mean: Some(mean).filter(|m| m.is_finite()),
        variance: Some(variance).filter(|v| v.is_finite() && *v > 0.0),
        status: Status::Ok,
        ..indices
    };
    if !lost.is_empty() {
        let names: Vec<String> = lost.iter().map(usize::to_string).collect();
        analysis.note(&format!(
            "left out points without a finite value: {}",
            names.join(", ")
        ));
    }
    if analysis.variance.is_none() || analysis.mean.is_none() {
        analysis.note("the mean or the variance is beyond the range of double precision");
    }
    analysis
}
