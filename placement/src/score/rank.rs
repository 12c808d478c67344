//! Indices to ranked locations.
//!
//! A location's own input is the one that varies the depth of the station below it. The default order is by the sum of
//! the own input's first-order indices for the x and the y strain at the contact centre, or by the one that is asked for; equal sums
//! (shares within 1e-9) are ordered by x, then by name. A location without an index comes last.
//!
//! Locations that are equal, as mirror images are, share a rank: that of the first of them. It is certain when the errors leave no doubt
//! about its place among the others.

use fem_client::solver::direction::{Direction, PerDirection};
use gsa::judge::certainty::{Estimate, places_certain};

use crate::score::indices::{Scored, Scores};
use documents::parts::directions::Directions;
use documents::study::Study;
use results::RankedLocation;
use results::location_scores::{Figure, GSI, LocationScores, OwnIndex, OwnIndices};

/// Percentages closer than this are equal (1e-9 as shares): what symmetry makes equal still differs by rounding.
const EQUAL_PERCENT: f64 = 1e-7;

/// Returns for each location which input varies the depth of the station below it.
///
/// Locations and stations are both centred on the contact and one spacing apart, so they are matched from the middle.
pub(crate) fn own_inputs(study: &Study, locations: usize) -> Vec<Option<usize>> {
    let stations = study.scene.ground.stations;
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
    let own = own_inputs(study, scores.at_locations.len());
    let mut locations: Vec<RankedLocation> = own
        .iter()
        .enumerate()
        .map(|(i, input)| unranked(study, scores, i, *input))
        .collect();
    for direction in Direction::ALL {
        rank_by_one(&mut locations, direction);
    }
    let gsi_x = |location: &RankedLocation| location.value(GSI, Direction::X);
    let default = |location: &RankedLocation| default_key(location, study.directions);
    let order = ordered(&locations, &[&default, &gsi_x]);
    let mut ranked: Vec<RankedLocation> = order.iter().map(|i| locations[*i].clone()).collect();
    number(&mut ranked, study.directions);
    ranked
}

/// Ranks by one strain alone; equals share the rank of the first of them.
fn rank_by_one(locations: &mut [RankedLocation], direction: Direction) {
    let gsi = |location: &RankedLocation| location.value(GSI, direction);
    let order = ordered(locations, &[&gsi]);
    let mut before: Option<(f64, usize)> = None;
    for (row, i) in order.into_iter().enumerate() {
        let Some(value) = gsi(&locations[i]) else {
            continue;
        };
        let rank = match before {
            Some((last, rank)) if last - value <= EQUAL_PERCENT => rank,
            _ => row + 1,
        };
        locations[i].ranks[direction] = Some(rank);
        before = Some((value, rank));
    }
}

/// Whether both indices are equal, to rounding.
fn are_equal(a: &RankedLocation, b: &RankedLocation) -> bool {
    Direction::ALL.iter().all(|&direction| {
        let values = a.value(GSI, direction).zip(b.value(GSI, direction));
        values.is_some_and(|(a, b)| (a - b).abs() <= EQUAL_PERCENT)
    })
}

/// A location with its scores: what each output says of its own input.
fn unranked(
    study: &Study,
    scores: &Scores,
    location: usize,
    input: Option<usize>,
) -> RankedLocation {
    let percent = |indices: &Option<Vec<f64>>| Some(100.0 * indices.as_ref()?[input?]);
    let own_index = |scored: &Scored| OwnIndex {
        index: percent(&scored.output.first_order),
        error: percent(&scored.index_errors),
        mdrm_index: percent(&scored.mdrm_first_order),
    };
    let everywhere = PerDirection::of(|direction| {
        let scored = scores.at_locations.iter().map(|at| &at[direction]);
        scored.map(own_index).collect::<Vec<OwnIndex>>()
    });
    RankedLocation {
        name: scores.at_locations[location].x.output.location.clone(),
        input: input.map(|input| study.inputs[input].name.clone()),
        rank: 0,
        scores: LocationScores::of(|score, direction| {
            (score.compute)(&OwnIndices {
                everywhere: &everywhere[direction],
                location,
            })
        }),
        ranks: PerDirection::default(),
        rank_certain: false,
    }
}

/// A figure of a location, where it has one.
pub(crate) type Key<'k> = &'k dyn Fn(&RankedLocation) -> Option<f64>;

/// Returns what the default order goes by: the index that is asked for, or the sum of both, percent.
pub(crate) fn default_key(location: &RankedLocation, directions: Directions) -> Option<f64> {
    of_asked(
        location.scores.of_score(GSI),
        directions,
        |gsi| gsi.value,
        |x, y| x + y,
    )
}

/// Returns the error of that; the two of a sum come from different outputs.
pub(crate) fn key_error(location: &RankedLocation, directions: Directions) -> Option<f64> {
    of_asked(
        location.scores.of_score(GSI),
        directions,
        |gsi| gsi.error,
        f64::hypot,
    )
}

/// A part of the figures that are asked for, joined where there are two; `None` where one is missing.
fn of_asked(
    figures: &PerDirection<Figure>,
    directions: Directions,
    part: fn(&Figure) -> Option<f64>,
    join: fn(f64, f64) -> f64,
) -> Option<f64> {
    let asked = directions.asked().iter();
    let parts: Option<Vec<f64>> = asked.map(|&direction| part(&figures[direction])).collect();
    parts?.into_iter().reduce(join)
}

/// Order of the locations by the keys, greatest first, missing ones last; what all keys call equal goes by name.
pub(crate) fn ordered(locations: &[RankedLocation], keys: &[Key<'_>]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..locations.len()).collect();
    order.sort_by(|a, b| locations[*a].name.cmp(&locations[*b].name));
    sort_by_keys(&mut order, locations, keys);
    order
}

/// Sorts by the first key, then each run of nearly equal ones by the next keys. Comparing with a tolerance inside one
/// sort would not be an order: a ~ b and b ~ c without a ~ c.
fn sort_by_keys(order: &mut [usize], locations: &[RankedLocation], keys: &[Key<'_>]) {
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

/// Numbers what is in order; equals share the rank of the first of them. It is certain if they truly outrank all others, or are outranked,
/// with the probability of [`gsa::judge::certainty`].
fn number(ranked: &mut [RankedLocation], directions: Directions) {
    let certain = places_are_certain(ranked, directions);
    let mut rank = 1;
    for equals in ranked.chunk_by_mut(are_equal) {
        let of_equals = &certain[rank - 1..][..equals.len()];
        let is_certain = of_equals.iter().all(|certain| *certain);
        for location in equals.iter_mut() {
            (location.rank, location.rank_certain) = (rank, is_certain);
        }
        rank += equals.len();
    }
}

/// Whether the place of each is certain, which equals share.
fn places_are_certain(ranked: &[RankedLocation], directions: Directions) -> Vec<bool> {
    let known = |location: &RankedLocation| {
        Some(Estimate {
            value: default_key(location, directions)?,
            error: key_error(location, directions).unwrap_or(f64::INFINITY),
        })
    };
    let estimates: Vec<Option<Estimate>> = ranked.iter().map(known).collect();
    let ranks: Vec<Estimate> = estimates.iter().flatten().copied().collect();
    let mut certain = places_certain(&ranks, EQUAL_PERCENT).into_iter();
    // A location without an index could belong anywhere: the last place is the only one left for it. One place is no ranking.
    let is_ranking = ranks.len() > 1;
    let known = |estimate: &Option<Estimate>| {
        estimate.is_some() && certain.next() == Some(true) && is_ranking
    };
    estimates.iter().map(known).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use results::location_scores::Score;

    fn location(name: &str, x: Option<f64>, y: Option<f64>) -> RankedLocation {
        let gsi = PerDirection { x, y };
        let figure = |score: &Score, direction| Figure {
            value: gsi[direction].filter(|_| score.name == GSI.name),
            error: None,
        };
        RankedLocation {
            name: name.to_owned(),
            input: None,
            rank: 0,
            scores: LocationScores::of(figure),
            ranks: PerDirection::default(),
            rank_certain: false,
        }
    }

    fn names(locations: &[RankedLocation], order: Vec<usize>) -> Vec<&str> {
        let ordered = order.into_iter().map(|i| &locations[i]);
        ordered.map(|location| location.name.as_str()).collect()
    }

    fn sum(location: &RankedLocation) -> Option<f64> {
        default_key(location, Directions::Both)
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
        let gsi_x = |location: &RankedLocation| location.value(GSI, Direction::X);
        let order = ordered(&locations, &[&sum, &gsi_x]);
        assert_eq!(names(&locations, order), ["P4", "P3", "P1", "P2", "P0"]);
    }

    #[test]
    fn the_order_does_not_depend_on_the_order_given() {
        // Neighbours are equal within the tolerance, the ends are not: no comparison of pairs would be an order.
        let chain: Vec<RankedLocation> = (0..40)
            .map(|i| location(&format!("P{i:02}"), Some(0.6e-7 * f64::from(i)), Some(0.0)))
            .collect();
        let mut reversed = chain.clone();
        reversed.reverse();
        let in_order = |locations| names(locations, ordered(locations, &[&sum]));
        assert_eq!(in_order(&chain), in_order(&reversed));
        assert!(in_order(&chain).is_sorted());
    }

    /// Gives every sum the same error, all of it from x.
    fn number_with(ranked: &mut [RankedLocation], error: Option<f64>) {
        for location in ranked.iter_mut() {
            let gsi = location.scores.clone();
            let errors = PerDirection {
                x: error,
                y: Some(0.0),
            };
            location.scores = LocationScores::of(|score, direction| Figure {
                value: gsi.of_score(score)[direction].value,
                error: errors[direction],
            });
        }
        number(ranked, Directions::Both);
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
        number_with(&mut ranked, Some(4.0));
        assert_eq!(
            ranked.each_ref().map(|l| l.rank_certain),
            [true, false, false, false]
        );
        number_with(&mut ranked[..3], Some(2.0));
        assert!(ranked[..3].iter().all(|l| l.rank_certain));
        number_with(&mut ranked, None);
        assert!(ranked.iter().all(|l| !l.rank_certain));
    }

    #[test]
    fn mirror_locations_share_a_rank_which_may_be_certain() {
        let mut ranked = [
            location("a", Some(60.0), Some(0.0)),
            location("b", Some(20.0), Some(0.0)),
            location("c", Some(20.0 - 1e-9), Some(0.0)),
            location("d", Some(10.0), Some(0.0)),
        ];
        number_with(&mut ranked, Some(10.0));
        let ranks = ranked.each_ref().map(|l| (l.rank, l.rank_certain));
        assert_eq!(ranks, [(1, true), (2, false), (2, false), (4, false)]);
        number_with(&mut ranked[..3], Some(10.0));
        let ranks = ranked.each_ref().map(|l| (l.rank, l.rank_certain));
        assert_eq!(ranks[..3], [(1, true), (2, true), (2, true)]);
        number_with(&mut ranked[..1], Some(10.0));
        assert!(!ranked[0].rank_certain, "one place is no ranking");
        rank_by_one(&mut ranked, Direction::X);
        assert_eq!(
            ranked.each_ref().map(|l| l.ranks.x),
            [Some(1), Some(2), Some(2), Some(4)]
        );
    }
}
