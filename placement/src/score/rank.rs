//! Indices to ranked locations.
//!
//! A location's own input is the one that varies the depth of the station below it. The default order is by the sum of
//! the own input's first-order indices for the x and the y strain at the contact centre, or by the one that is asked for; equal sums
//! (shares within 1e-9) are ordered by x, then by name. A location without an index comes last.

use gsa::judge::certainty::{Estimate, places_certain};

use crate::result::{Output, RankedLocation};
use crate::score::indices::Scores;
use crate::study::Study;
use crate::study::directions::Directions;

/// Percentages closer than this are equal (1e-9 as shares): what symmetry makes equal still differs by rounding.
const EQUAL_PERCENT: f64 = 1e-7;

/// For each location, which input varies the depth of the station below it.
///
/// Locations and stations are both centred on the contact and one spacing apart, so they are matched from the middle.
pub fn own_inputs(study: &Study, locations: usize) -> Vec<Option<usize>> {
    let stations = study.scene.ground.depths_mm.len();
    let station_below = |location: usize| (location + stations / 2).checked_sub(locations / 2);
    let input_of = |station: usize| {
        study
            .inputs
            .iter()
            .position(|input| input.station() == Some(station))
    };
    (0..locations)
        .map(|location| station_below(location).and_then(input_of))
        .collect()
}

/// Ranks the locations, best first.
pub fn rank(study: &Study, scores: &Scores) -> Vec<RankedLocation> {
    let matrix = Matrix::new(scores);
    let own = own_inputs(study, matrix.x.len());
    let mut locations: Vec<RankedLocation> = own
        .iter()
        .enumerate()
        .map(|(i, input)| RankedLocation {
            input: input.map(|input| study.inputs[input].name.clone()),
            ..matrix.unranked(i, *input)
        })
        .collect();
    for (column, place) in [
        (gsi_x as Key, set_rank_x as fn(&mut RankedLocation, usize)),
        (gsi_y, set_rank_y),
    ] {
        for (rank, i) in ordered(&locations, &[column]).into_iter().enumerate() {
            if column(&locations[i]).is_some() {
                place(&mut locations[i], rank + 1);
            }
        }
    }
    let order = ordered(&locations, &[default_key(study.directions), gsi_x]);
    let mut ranked: Vec<RankedLocation> = order.iter().map(|i| locations[*i].clone()).collect();
    for (i, location) in ranked.iter_mut().enumerate() {
        location.rank = i + 1;
    }
    mark_certain(&mut ranked, study.directions);
    ranked
}

/// A figure of a location, where it has one.
pub(crate) type Key = fn(&RankedLocation) -> Option<f64>;

/// What the default order goes by: the index that is asked for, or the sum of both, percent.
fn default_key(directions: Directions) -> Key {
    match directions {
        Directions::Both => |location| Some(location.gsi_x_percent? + location.gsi_y_percent?),
        Directions::X => gsi_x,
        Directions::Y => gsi_y,
    }
}

/// Its error; the two of a sum come from different outputs.
fn key_error(directions: Directions) -> Key {
    match directions {
        Directions::Both => |location| {
            let x = location.gsi_x_error_percent?;
            Some(x.hypot(location.gsi_y_error_percent?))
        },
        Directions::X => |location| location.gsi_x_error_percent,
        Directions::Y => |location| location.gsi_y_error_percent,
    }
}

fn gsi_x(location: &RankedLocation) -> Option<f64> {
    location.gsi_x_percent
}

fn gsi_y(location: &RankedLocation) -> Option<f64> {
    location.gsi_y_percent
}

fn set_rank_x(location: &mut RankedLocation, rank: usize) {
    location.rank_x = Some(rank);
}

fn set_rank_y(location: &mut RankedLocation, rank: usize) {
    location.rank_y = Some(rank);
}

/// Order of the locations by the keys, greatest first, missing ones last; what all keys call equal goes by name.
pub fn ordered(locations: &[RankedLocation], keys: &[Key]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..locations.len()).collect();
    order.sort_by(|a, b| locations[*a].name.cmp(&locations[*b].name));
    sort_by_keys(&mut order, locations, keys);
    order
}

/// Sorts by the first key, then each run of nearly equal ones by the next keys. Comparing with a tolerance inside one
/// sort would not be an order: a ~ b and b ~ c without a ~ c.
fn sort_by_keys(order: &mut [usize], locations: &[RankedLocation], keys: &[Key]) {
    let Some((key, rest)) = keys.split_first() else {
        order.sort_by(|a, b| locations[*a].name.cmp(&locations[*b].name));
        return;
    };
    let value = |i: usize| key(&locations[i]).unwrap_or(f64::NEG_INFINITY);
    order.sort_by(|a, b| value(*b).total_cmp(&value(*a)));
    let equal =
        |a: &usize, b: &usize| value(*a) == value(*b) || value(*a) - value(*b) <= EQUAL_PERCENT;
    for run in order.chunk_by_mut(equal) {
        sort_by_keys(run, locations, rest);
    }
}

/// A rank is certain if its location truly outranks all others, or is outranked, with the probability of
/// [`gsa::judge::certainty`]; locations that tie share their place.
fn mark_certain(ranked: &mut [RankedLocation], directions: Directions) {
    let (key, key_error) = (default_key(directions), key_error(directions));
    let known = |location: &RankedLocation| {
        Some(Estimate {
            value: key(location)?,
            error: key_error(location).unwrap_or(f64::INFINITY),
        })
    };
    let estimates: Vec<Option<Estimate>> = ranked.iter().map(known).collect();
    let ranks: Vec<Estimate> = estimates.iter().flatten().copied().collect();
    let mut certain = places_certain(&ranks, EQUAL_PERCENT).into_iter();
    for (location, estimate) in ranked.iter_mut().zip(&estimates) {
        // A location without an index could belong anywhere: the last place is the only one left for it.
        location.rank_certain = estimate.is_some() && certain.next().unwrap_or(false);
    }
}

/// Outputs by direction and location.
struct Matrix<'s> {
    x: Vec<Cell<'s>>,
    y: Vec<Cell<'s>>,
}

/// An output with M-DRM's indices of it, and the errors of its own.
type Cell<'s> = (&'s Output, &'s Option<Vec<f64>>, &'s Option<Vec<f64>>);

impl<'s> Matrix<'s> {
    fn new(scores: &'s Scores) -> Self {
        let parts = scores.mdrm_first_order.iter().zip(&scores.index_errors);
        let all = scores.outputs.iter().zip(parts);
        let (x, y) = all
            .map(|(output, (mdrm, errors))| (output, mdrm, errors))
            .partition(|(output, ..)| output.direction == "x");
        Self { x, y }
    }

    fn unranked(&self, location: usize, input: Option<usize>) -> RankedLocation {
        let percent = |indices: Option<&Vec<f64>>| Some(100.0 * indices?[input?]);
        let at = |output: &Output| percent(output.first_order.as_ref());
        let centre = self.x.len() / 2;
        let mean = |column: &[Cell<'_>]| {
            let known: Vec<f64> = column
                .iter()
                .filter_map(|(output, ..)| at(output))
                .collect();
            (!known.is_empty()).then(|| known.iter().sum::<f64>() / known.len() as f64)
        };
        RankedLocation {
            name: self.x[location].0.location.clone(),
            input: None,
            rank: 0,
            gsi_x_percent: at(self.x[centre].0),
            gsi_y_percent: at(self.y[centre].0),
            gsi_x_error_percent: percent(self.x[centre].2.as_ref()),
            gsi_y_error_percent: percent(self.y[centre].2.as_ref()),
            mean_gsi_x_percent: mean(&self.x),
            mean_gsi_y_percent: mean(&self.y),
            own_gsi_x_percent: at(self.x[location].0),
            own_gsi_y_percent: at(self.y[location].0),
            mdrm_gsi_x_percent: percent(self.x[centre].1.as_ref()),
            mdrm_gsi_y_percent: percent(self.y[centre].1.as_ref()),
            rank_x: None,
            rank_y: None,
            rank_certain: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn location(
        name: &str,
        gsi_x_percent: Option<f64>,
        gsi_y_percent: Option<f64>,
    ) -> RankedLocation {
        RankedLocation {
            name: name.to_owned(),
            input: None,
            rank: 0,
            gsi_x_percent,
            gsi_y_percent,
            gsi_x_error_percent: None,
            gsi_y_error_percent: None,
            mean_gsi_x_percent: None,
            mean_gsi_y_percent: None,
            own_gsi_x_percent: None,
            own_gsi_y_percent: None,
            mdrm_gsi_x_percent: None,
            mdrm_gsi_y_percent: None,
            rank_x: None,
            rank_y: None,
            rank_certain: false,
        }
    }

    #[test]
    fn equal_sums_go_by_x_then_by_name_and_missing_ones_last() {
        let locations = [
            location("P0", None, Some(90.0)),
            location("P2", Some(10.0), Some(20.0)),
            location("P3", Some(11.0), Some(19.0)),
            location("P1", Some(10.0 + 1e-9), Some(20.0)),
            location("P4", Some(30.0), Some(30.0)),
        ];
        let order = ordered(&locations, &[default_key(Directions::Both), gsi_x]);
        let names: Vec<&str> = order
            .into_iter()
            .map(|i| locations[i].name.as_str())
            .collect();
        assert_eq!(names, ["P4", "P3", "P1", "P2", "P0"]);
    }

    #[test]
    fn the_order_does_not_depend_on_the_order_given() {
        // Neighbours are equal within the tolerance, the ends are not: no comparison of pairs would be an order.
        let chain: Vec<RankedLocation> = (0..40)
            .map(|i| location(&format!("P{i:02}"), Some(0.6e-7 * f64::from(i)), Some(0.0)))
            .collect();
        let names = |locations: &[RankedLocation]| -> Vec<String> {
            let order = ordered(locations, &[default_key(Directions::Both)]);
            order
                .into_iter()
                .map(|i| locations[i].name.clone())
                .collect()
        };
        let mut reversed = chain.clone();
        reversed.reverse();
        assert_eq!(names(&chain), names(&reversed));
        assert!(names(&chain).is_sorted());
    }

    /// With the same error of every sum, all of it from x.
    fn mark_certain_with(ranked: &mut [RankedLocation], error: Option<f64>) {
        for location in ranked.iter_mut() {
            location.gsi_x_error_percent = error;
            location.gsi_y_error_percent = Some(0.0);
        }
        mark_certain(ranked, Directions::Both);
    }

    #[test]
    fn ranks_are_certain_beyond_the_errors_of_the_others() {
        let mut ranked = [
            location("a", Some(60.0), Some(0.0)),
            location("b", Some(50.0), Some(0.0)),
            location("c", Some(46.0), Some(0.0)),
            location("d", None, None),
        ];
        // b from c: 2 4/sqrt(2 16) = 1.4 deviations; a from b: 3.5
        mark_certain_with(&mut ranked, Some(4.0));
        assert_eq!(
            ranked.each_ref().map(|l| l.rank_certain),
            [true, false, false, false]
        );
        mark_certain_with(&mut ranked[..3], Some(2.0));
        assert!(ranked[..3].iter().all(|l| l.rank_certain));
        mark_certain_with(&mut ranked, None);
        assert!(ranked.iter().all(|l| !l.rank_certain));
    }

    #[test]
    fn mirror_locations_share_a_certain_place() {
        let mut ranked = [
            location("a", Some(60.0), Some(0.0)),
            location("b", Some(20.0), Some(0.0)),
            location("c", Some(20.0 - 1e-9), Some(0.0)),
        ];
        mark_certain_with(&mut ranked, Some(10.0));
        assert!(ranked.iter().all(|l| l.rank_certain));
    }
}
