//! Outcomes to numbers: a row per point, a column per output, which are the strains at P1, P2, ... and those of the dense map.

use fem_client::solver::Response;
use fem_client::solver::direction::Direction;
use ndarray::{Array2, ArrayView1, Axis};

use crate::points::archive::Outcome;
use crate::score::quantity::{at_locations, over_map, tolerance};
use documents::parts::directions::Directions;

/// Returns those of them that an adaptive method serves: the locations', in the directions asked for, as far as they vary by more than a solver leaves open.
pub(crate) fn ranked_values(outcomes: &[Outcome], directions: Directions) -> Array2<f64> {
    let [mut ranked, _] = location_columns(outcomes, directions);
    let values = values(outcomes);
    let open = outcomes.iter().flatten().next().map_or(0.0, tolerance);
    ranked.retain(|&column| open == 0.0 || range(values.column(column)) > open);
    values.select(Axis(1), &ranked)
}

/// The locations' columns among all: those that the ranking rests on, and the others.
pub(crate) fn location_columns(outcomes: &[Outcome], directions: Directions) -> [Vec<usize>; 2] {
    let first = outcomes.iter().flatten().next();
    let locations = first.into_iter().flat_map(at_locations);
    let columns = locations.flat_map(|_| Direction::ALL).enumerate();
    let (ranked, others): (Vec<_>, Vec<_>) =
        columns.partition(|(_, direction)| directions.include(*direction));
    [ranked, others].map(|columns| columns.into_iter().map(|(column, _)| column).collect())
}

/// The outputs of all points, a row each: locations first, then the map. A point without an equilibrium has a row of NaN.
///
/// # Panics
/// If the responses differ in their readout.
pub(crate) fn values(outcomes: &[Outcome]) -> Array2<f64> {
    let columns = outcomes
        .iter()
        .flatten()
        .next()
        .map_or(0, |first| readings(first).len());
    let row = |outcome: &Outcome| match outcome {
        Ok(response) => readings(response),
        Err(_) => vec![f64::NAN; columns],
    };
    let rows: Vec<Vec<f64>> = outcomes.iter().map(row).collect();
    let values = Array2::from_shape_vec((rows.len(), columns), rows.concat());
    values.expect("every response has the same readout")
}

/// Returns what is read of one point: locations first, then the map's x layer and y layer.
fn readings(response: &Response) -> Vec<f64> {
    let map = response.map.iter().flat_map(|map| over_map(map).iter());
    at_locations(response)
        .flatten()
        .chain(map.flatten().copied())
        .collect()
}

/// Returns the distance from the least to the greatest of the points with a number.
pub(crate) fn range(values: ArrayView1<'_, f64>) -> f64 {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    finite().fold(f64::NEG_INFINITY, f64::max) - finite().fold(f64::INFINITY, f64::min)
}
