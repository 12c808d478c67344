//! The location that ranks first, how sure that is, and why.

use fem_client::solver::direction::Direction;

use super::figure_words::with_error;
use super::first_rank::{Judged, Standing, judge};
use crate::score::notes::listed;
use crate::score::quantity::QUANTITY;
use crate::score::rank::{default_key, key_error};
use documents::parts::directions::Directions;
use results::location_scores::GSI;
use results::{Certainty, PlaceAnswer, RankedLocation};

/// The best place; `None` where no location has an index.
pub(super) fn best_place(
    locations: &[RankedLocation],
    directions: Directions,
) -> Option<PlaceAnswer> {
    let standing = |location: &RankedLocation| {
        let error = key_error(location, directions);
        Some(Standing {
            value: default_key(location, directions)?,
            off: error.map(|error| [error; 2]),
        })
    };
    let ranked = || {
        let known = |location| Some((location, standing(location)?));
        locations.iter().filter_map(known)
    };
    let (best, first) = ranked().next()?;
    let (equals, others): (Vec<_>, Vec<_>) =
        ranked().partition(|(location, _)| location.rank == best.rank);
    let standings: Vec<Standing> = others.iter().map(|(_, standing)| *standing).collect();
    let judged = against_nothing(&first, judge(&first, &standings));
    let mirrored: Vec<&str> = equals.iter().map(|(l, _)| l.name.as_str()).collect();
    let tied = judged.tied.iter().map(|&k| others[k].0.name.as_str());
    let names: Vec<&str> = match judged.verdict {
        Certainty::Tied => mirrored.iter().copied().chain(tied).collect(),
        _ => mirrored.clone(),
    };
    let compared = judged.closest.map(|k| {
        let (closest, standing) = others[k];
        let of_rank = others.iter().filter(|(l, _)| l.rank == closest.rank);
        let names: Vec<&str> = of_rank.map(|(l, _)| l.name.as_str()).collect();
        (names, standing)
    });
    let is_alone = others.is_empty();
    let reason = reason(&judged, (&mirrored, first), compared, directions);
    let (direction, index, error) = larger_index(best, directions)?;
    Some(PlaceAnswer {
        sentence: sentence((&mirrored, is_alone), &names, direction, index, error),
        names: names.into_iter().map(str::to_owned).collect(),
        direction: direction.as_str().to_owned(),
        index: index / 100.0,
        error: error.map(|error| error / 100.0),
        verdict: judged.verdict,
        reason,
    })
}

/// Judges a first rank that others don't decide: an index within its error of zero tells nothing, and without a rival nothing is ranked.
fn against_nothing(first: &Standing, judged: Judged) -> Judged {
    let nothing = Standing {
        value: 0.0,
        off: Some([0.0; 2]),
    };
    let from_zero = judge(first, &[nothing]).verdict;
    let alone = match judged.closest {
        None => Certainty::Unknown,
        Some(_) => Certainty::Certain,
    };
    Judged {
        verdict: judged.verdict.max(from_zero).max(alone),
        ..judged
    }
}

/// The strain whose index is larger, with the index and its error, percent.
fn larger_index(
    location: &RankedLocation,
    directions: Directions,
) -> Option<(Direction, f64, Option<f64>)> {
    let asked = directions.asked().iter();
    let known = asked.filter_map(|&direction| {
        let error = location.error(GSI, direction);
        Some((direction, location.value(GSI, direction)?, error))
    });
    // The first of equals: x before y.
    known.reduce(|best, next| if next.1 > best.1 { next } else { best })
}

fn sentence(
    (mirrored, is_alone): (&[&str], bool),
    names: &[&str],
    direction: Direction,
    index: f64,
    error: Option<f64>,
) -> String {
    let matter = match (is_alone, names.len()) {
        (true, 1) => "is all that is ranked",
        (true, _) => "are all that is ranked",
        (false, 1) => "tells most",
        (false, _) => "tell most",
    };
    let tied = match names.len() > mirrored.len() {
        true => ", and the errors can't tell them apart",
        false => "",
    };
    let depth = match mirrored {
        [one] => format!("the depth below {one} makes"),
        _ => format!("the depth below each of {} makes", listed(mirrored)),
    };
    let share = with_error(index, error);
    let unsure = if error.is_none() {
        ", error unknown,"
    } else {
        ""
    };
    format!(
        "{} {matter}{tied}: {depth} {share} %{unsure} of the variance of the {direction} {QUANTITY} at the contact centre.",
        listed(names)
    )
}

/// Says why the first rank is as sure as it is.
fn reason(
    judged: &Judged,
    (first_names, first): (&[&str], Standing),
    closest: Option<(Vec<&str>, Standing)>,
    directions: Directions,
) -> String {
    let figure = |standing: &Standing| with_error(standing.value, standing.off.map(|[off, _]| off));
    let what = match directions.asked() {
        [one] => format!("index of its own depth for the {one} {QUANTITY}"),
        _ => format!("indices of its own depth for both {QUANTITY}s, added up"),
    };
    let first_name = listed(first_names);
    let is_zero = first.off.is_some_and(|[less, _]| first.value <= less);
    let zero = if is_zero {
        " and isn't told from zero"
    } else {
        ""
    };
    let Some((other_names, other)) = closest else {
        return format!(
            "Nothing else is ranked: by the {what}, {first_name} has {} %{zero}. One place is no ranking.",
            figure(&first)
        );
    };
    if is_zero {
        return format!(
            "Ranked by the {what}, {first_name} has {} %, which isn't told from zero.",
            figure(&first)
        );
    }
    let other_name = listed(&other_names);
    let so = match judged.verdict {
        Certainty::Certain => "which is more than the errors can explain",
        Certainty::Likely => "which is more than either error, and less than both together",
        Certainty::Tied => "which is within the error",
        Certainty::Unknown => "and how far these are off isn't known",
    };
    format!(
        "Ranked by the {what}, {first_name} has {} % and {other_name} {} %, {so}.",
        figure(&first),
        figure(&other)
    )
}

#[cfg(test)]
mod tests {
    use fem_client::solver::direction::PerDirection;

    use super::*;
    use results::location_scores::{Figure, LocationScores, Score};

    /// A location whose x and y index are these, percent, each with this error.
    fn location(name: &str, rank: usize, gsi: [f64; 2], error: Option<f64>) -> RankedLocation {
        let [x, y] = gsi;
        let of = |score: &Score, direction: Direction| Figure {
            value: (score.name == GSI.name).then_some(PerDirection { x, y }[direction]),
            error: error.filter(|_| score.has_error),
        };
        RankedLocation {
            name: name.to_owned(),
            input: None,
            rank,
            scores: LocationScores::of(of),
            ranks: PerDirection::default(),
            rank_certain: false,
        }
    }

    #[test]
    fn mirror_places_share_the_first_rank_without_being_uncertain() {
        let locations = [
            location("P2", 1, [20.0, 30.0], Some(2.0)),
            location("P4", 1, [20.0, 30.0], Some(2.0)),
            location("P3", 3, [10.0, 12.0], Some(2.0)),
        ];
        let place = best_place(&locations, Directions::Both).expect("a place");
        assert_eq!(place.names, ["P2", "P4"]);
        assert_eq!(place.verdict, Certainty::Certain);
        assert_eq!((place.direction.as_str(), place.index), ("y", 0.3));
        assert_eq!(
            place.sentence,
            "P2 and P4 tell most: the depth below each of P2 and P4 makes 30.0 +- 2.0 % of the variance of the y strain at the contact centre."
        );
    }

    /// A single depth that varies makes all of the variance, whatever the tire: that is no answer to where a film is best.
    #[test]
    fn a_place_without_a_rival_does_not_tell_most() {
        let place = best_place(
            &[location("P3", 1, [100.0; 2], Some(0.0))],
            Directions::Both,
        );
        let place = place.expect("a place");
        assert_eq!(place.verdict, Certainty::Unknown);
        assert_eq!(
            place.sentence,
            "P3 is all that is ranked: the depth below P3 makes 100 % of the variance of the x strain at the contact centre."
        );
    }

    #[test]
    fn one_strain_alone_is_judged_by_its_own_error_and_ties_are_named() {
        let locations = [
            location("P3", 1, [30.0, 80.0], Some(4.0)),
            location("P2", 2, [27.0, 10.0], Some(4.0)),
            location("P1", 3, [2.0, 1.0], Some(4.0)),
        ];
        let place = best_place(&locations, Directions::X).expect("a place");
        assert_eq!(
            (place.verdict, place.direction.as_str()),
            (Certainty::Tied, "x")
        );
        assert_eq!(place.names, ["P3", "P2"]);
        assert_eq!(
            place.reason,
            "Ranked by the index of its own depth for the x strain, P3 has 30.0 +- 4.0 % and P2 27.0 +- 4.0 %, which is within the error."
        );
        let both = best_place(&locations, Directions::Both).expect("a place");
        assert_eq!(
            (both.verdict, both.names),
            (Certainty::Certain, vec!["P3".to_owned()])
        );
    }

    #[test]
    fn without_errors_nothing_is_claimed_and_without_indices_nothing_is_said() {
        let locations = [
            location("P3", 1, [70.0, 50.0], None),
            location("P2", 2, [10.0, 20.0], None),
        ];
        let place = best_place(&locations, Directions::Both).expect("a place");
        assert_eq!((place.verdict, place.error), (Certainty::Unknown, None));
        assert!(
            place.reason.ends_with("how far these are off isn't known."),
            "{}",
            place.reason
        );
        assert!(
            place.sentence.contains("error unknown"),
            "{}",
            place.sentence
        );
        let unknown = LocationScores::of(|_, _| Figure::default());
        let without = RankedLocation {
            scores: unknown,
            ..location("P3", 1, [0.0; 2], None)
        };
        assert_eq!(best_place(&[without], Directions::Both), None);
    }
}
