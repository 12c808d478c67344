//! Settings that every method can afford, and what no analysis may show.

use gsa::method::analysis::{Analysis, Status};
use gsa::method::{Kind, Method};

/// A method's settings for some inputs: few enough runs for many cases, the whole grid included.
pub fn settings(kind: Kind, inputs: usize, nodes: usize, check_points: usize, seed: u64) -> Method {
    let nodes = match (kind, inputs) {
        (Kind::Tensor, 4..) => nodes.min(3),
        (Kind::Tensor, _) => nodes.min(5),
        _ => nodes,
    };
    Method {
        nodes,
        check_points,
        seed,
        samples: 64,
        most_runs: 150,
        ..Method::of(kind)
    }
}

/// The first thing about an analysis that can't be true of any model.
pub fn fault(found: &Analysis) -> Option<String> {
    let lists = [
        &found.first_order,
        &found.total,
        &found.second_order,
        &found.mdrm_first_order,
        &found.mdrm_total,
        &found.error.by_input,
    ];
    let mut shares = lists.into_iter().flatten().flatten();
    if let Some(share) = shares.find(|s| !(0.0..=1.0).contains(*s)) {
        return Some(format!("an index or its error is {share}"));
    }
    let error = &found.error;
    let parts = [
        error.quadrature,
        error.decomposition,
        error.sampling,
        error.total,
        Some(error.floor),
    ];
    if let Some(part) = parts
        .into_iter()
        .flatten()
        .find(|e| !(0.0..=1.0).contains(e))
    {
        return Some(format!("a part of the error is {part}"));
    }
    if !found.mean.is_none_or(f64::is_finite) {
        return Some("the mean isn't finite".to_owned());
    }
    if !found.variance.is_none_or(|v| v.is_finite() && v >= 0.0) {
        return Some("the variance isn't finite".to_owned());
    }
    let indexed = found.first_order.is_some();
    if indexed != found.total.is_some() || (error.total.is_some() && !indexed) {
        return Some("indices and errors don't come together".to_owned());
    }
    if !indexed && found.status == Status::Ok {
        return Some("nothing was found, and that is ok".to_owned());
    }
    if (found.status != Status::Ok || !indexed) && found.reason.is_none() {
        return Some("there is no reason".to_owned());
    }
    None
}
