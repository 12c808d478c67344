//! Notes that the user must know before believing the numbers, in whole sentences made from the data.

use fem_client::solver::Response;
use fem_client::solver::direction::{Direction, PerDirection};
use gsa::method::analysis::Status;

use crate::score::indices::{NO_MESH_ERROR, Scores};
use crate::score::quantity::QUANTITY;
use crate::score::rank::{Key, ordered, own_inputs};
use documents::study::Study;
use documents::study::plan::Plan;
use results::location_scores::{GSI, SCORES};
use results::{FailedPoint, Grade, GradedNote, Output, RankedLocation, Topic};

/// Failed points that a sentence names.
const NAMED: usize = 3;
/// Difference of an index from M-DRM's that is worth a sentence.
const NOTABLE_DIFFERENCE: f64 = 0.1;

/// All notes of a study, in the order in which a reader needs them.
pub(crate) fn notes(
    study: &Study,
    plan: &Plan,
    cut: &Response,
    scores: &Scores,
    locations: &[RankedLocation],
    failed: &[FailedPoint],
) -> Vec<GradedNote> {
    let mut notes = Vec::new();
    notes.extend(unlikely_values(study, plan));
    notes.extend(one_direction(study));
    notes.extend(without_equilibrium(study, plan, failed));
    notes.extend(
        PerDirection::of(|direction| broken(scores, direction))
            .into_iter()
            .flatten(),
    );
    notes.extend(
        PerDirection::of(|direction| constant(scores, direction))
            .into_iter()
            .flatten(),
    );
    notes.extend(mdrm_at_centre(study, scores));
    notes.extend(other_orders(locations));
    notes.extend(uncertain(locations));
    notes.extend(without_location(study, cut));
    notes.extend(contact_edges(study, plan, cut));
    notes.extend(ties(locations));
    notes.extend(without_mesh_error(scores));
    notes.extend(volts_without_map(study));
    notes
}

/// Says which values the physics makes unlikely.
fn unlikely_values(study: &Study, plan: &Plan) -> Vec<GradedNote> {
    let slips = plan.slips(study).into_iter();
    let note = |slip| GradedNote::changing(Topic::Model, format!("Unlikely value: {slip}"));
    slips.map(note).collect()
}

/// Says what the answer goes by, where one strain alone is asked for.
fn one_direction(study: &Study) -> Option<GradedNote> {
    let [asked] = study.directions.asked() else {
        return None;
    };
    let other = Direction::ALL
        .iter()
        .find(|direction| *direction != asked)?;
    Some(GradedNote::bearing(
        Topic::Place,
        format!(
            "Only the {asked} {QUANTITY} is asked for: ranks, layouts and the accuracy go by it. The {other} {QUANTITY} is what the same points give."
        ),
    ))
}

/// Says what films' signals lack without a map.
fn volts_without_map(study: &Study) -> Option<GradedNote> {
    let asked = study.signals.is_some() && study.grid.is_none();
    asked.then(|| {
        GradedNote::bearing(
            Topic::Signals,
            "Which inputs matter for the volts isn't known without a map: add grid = { circumferential = 61, meridional = 21 } under [candidates].",
        )
    })
}

/// Says that the mesh's part of the errors is missing, where it is.
fn without_mesh_error(scores: &Scores) -> Option<GradedNote> {
    let indexed = |output: &&Output| output.first_order.is_some();
    let mut outputs = scores.outputs().filter(indexed);
    let without = outputs.find(|output| output.error.mesh.is_none())?;
    Some(match without.error.total {
        Some(_) => GradedNote::bearing(
            Topic::Indices,
            format!("The errors of the indices leave out the mesh: {NO_MESH_ERROR}."),
        ),
        None => GradedNote::changing(
            Topic::Place,
            format!(
                "How far the indices are off isn't known, and no rank is certain: {NO_MESH_ERROR}, as on the draft level. The next level knows."
            ),
        ),
    })
}

/// `P1`, `P1 and P2`, `P1, P2 and P3`.
pub(crate) fn listed(names: &[&str]) -> String {
    match names.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => names.concat(),
    }
}

/// Says what failed points are, and what they do to the indices.
fn without_equilibrium(study: &Study, plan: &Plan, failed: &[FailedPoint]) -> Option<GradedNote> {
    let named: Vec<String> = failed
        .iter()
        .take(NAMED)
        .map(|point| {
            format!(
                "point {} ({}): {}",
                point.ordinal,
                away_from_means(study, plan, point),
                point.cause
            )
        })
        .collect();
    let more = match failed.len().checked_sub(named.len())? {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    (!named.is_empty()).then(|| {
        let text = format!(
            "{} of {} points without an equilibrium: {}{more}. The indices are taken from the other points, as if the loads between \
             and beyond them could be borne, with the errors that this leaves.",
            failed.len(),
            plan.values().len(),
            named.join("; "),
        );
        GradedNote::changing(Topic::Indices, text)
    })
}

/// `P1 = 1.27`: the inputs that a point moves away from their means, to four digits.
fn away_from_means(study: &Study, plan: &Plan, point: &FailedPoint) -> String {
    let inputs = study
        .inputs
        .iter()
        .zip(&point.values)
        .zip(&plan.values()[0]);
    let moved: Vec<String> = inputs
        .filter(|((_, x), mean)| x != mean)
        .map(|((input, x), _)| {
            let rounded = format!("{x:.3e}").parse().unwrap_or(*x);
            format!("{} = {rounded}", input.name)
        })
        .collect();
    moved.join(", ")
}

fn with_status(scores: &Scores, direction: Direction, status: Status) -> Vec<&Output> {
    let matches = |output: &&Output| output.direction == direction && output.status == status;
    scores.outputs().filter(matches).collect()
}

fn names<'o>(outputs: &[&'o Output]) -> Vec<&'o str> {
    outputs
        .iter()
        .map(|output| output.location.as_str())
        .collect()
}

fn broken(scores: &Scores, direction: Direction) -> Option<GradedNote> {
    let outputs = with_status(scores, direction, Status::ProductFormBroken);
    let method = outputs.first()?.method.as_str();
    Some(GradedNote::bearing(
        Topic::Indices,
        format!(
            "M-DRM's product form doesn't hold for the {direction} {QUANTITY} at {}: the {method} reduction gives the indices there.",
            listed(&names(&outputs))
        ),
    ))
}

fn constant(scores: &Scores, direction: Direction) -> Option<GradedNote> {
    let outputs = with_status(scores, direction, Status::Constant);
    let reason = outputs.first()?.reason.as_deref().unwrap_or_default();
    Some(GradedNote::bearing(
        Topic::Indices,
        format!(
            "The {direction} {QUANTITY} at {} doesn't vary with the inputs, so it has no indices: {reason}.",
            listed(&names(&outputs))
        ),
    ))
}

/// Says in figures where M-DRM would say something else at the contact centre.
fn mdrm_at_centre(study: &Study, scores: &Scores) -> Vec<GradedNote> {
    let mut notes = Vec::new();
    let centre = &scores.at_locations[scores.at_locations.len() / 2];
    for scored in centre.iter() {
        let output = &scored.output;
        let (Some(chosen), Some(mdrm)) = (&output.first_order, &scored.mdrm_first_order) else {
            continue;
        };
        let differs =
            |(_, (chosen, mdrm)): &(_, (&f64, &f64))| (*chosen - *mdrm).abs() > NOTABLE_DIFFERENCE;
        for (input, (chosen, mdrm)) in study
            .inputs
            .iter()
            .zip(chosen.iter().zip(mdrm))
            .filter(differs)
        {
            let text = format!(
                "M-DRM would give {:.1} % to {} in the {} {QUANTITY} at {}, where the {} reduction gives {:.1} %.",
                100.0 * mdrm,
                input.name,
                output.direction,
                output.location,
                output.method.as_str(),
                100.0 * chosen
            );
            notes.push(GradedNote::bearing(Topic::Indices, text));
        }
    }
    notes
}

/// Returns the grade of a note: what touches the first place changes the answer.
fn grade_of(first_place: bool) -> Grade {
    match first_place {
        true => Grade::ChangesAnswer,
        false => Grade::BearsOnFigure,
    }
}

/// Other fair ways to rank, where they disagree with the default one.
fn other_orders(locations: &[RankedLocation]) -> Vec<GradedNote> {
    let in_order = |key: Key<'_>| -> Vec<&str> {
        let order = ordered(locations, &[key]).into_iter();
        order.map(|i| locations[i].name.as_str()).collect()
    };
    let others = SCORES
        .iter()
        .filter_map(|score| Some((score, score.other_order?)));
    let mut notes = Vec::new();
    for (score, what) in others {
        for direction in Direction::ALL {
            let at_centre = |location: &RankedLocation| location.value(GSI, direction);
            let other = |location: &RankedLocation| location.value(score, direction);
            let differ = |l: &RankedLocation| other(l).is_none() != at_centre(l).is_none();
            if locations.iter().any(differ) {
                continue;
            }
            let (default, found) = (in_order(&at_centre), in_order(&other));
            if default != found {
                let text = format!(
                    "By the {direction} {QUANTITY}{what} the order is {}; by the same {QUANTITY} at the contact centre it is {}.",
                    found.join(", "),
                    default.join(", ")
                );
                let grade = grade_of(found.first() != default.first());
                notes.push(GradedNote::of(grade, Topic::Place, text));
            }
        }
    }
    notes
}

/// Ranks that known errors leave open; where none is known another note says so.
fn uncertain(locations: &[RankedLocation]) -> Option<GradedNote> {
    let is_unsure = |location: &&RankedLocation| !location.rank_certain && location.knows_error();
    let known = locations.iter().filter(|location| location.knows_error());
    if known.count() < 2 {
        return None;
    }
    let unsure: Vec<&RankedLocation> = locations.iter().filter(is_unsure).collect();
    let first = unsure.iter().any(|location| location.rank == 1);
    let unsure: Vec<&str> = unsure.iter().map(|l| l.name.as_str()).collect();
    (!unsure.is_empty()).then(|| {
        let verb = if unsure.len() == 1 {
            "rank of"
        } else {
            "ranks of"
        };
        let is = if unsure.len() == 1 { "is" } else { "are" };
        let text = format!(
            "The {verb} {} {is} not certain: the errors bridge the distance to a neighbour.",
            listed(&unsure)
        );
        GradedNote::of(grade_of(first), Topic::Place, text)
    })
}

fn without_location(study: &Study, cut: &Response) -> Option<GradedNote> {
    let own = own_inputs(study, cut.locations.len());
    let homeless = |i: &usize| !own.contains(&Some(*i));
    let names: Vec<&str> = (0..study.inputs.len())
        .filter(homeless)
        .map(|i| study.inputs[i].name.as_str())
        .collect();
    (!names.is_empty()).then(|| {
        let has = match names.len() {
            1 => "varies: it has",
            _ => "vary: they have",
        };
        let text = format!(
            "No location lies above what {} {has} indices, but no part in the ranking.",
            listed(&names)
        );
        GradedNote::bearing(Topic::Place, text)
    })
}

/// Stations that touch at one end of their range and not at the other, judged by the undeformed profile: the ground
/// at a distance x from the centre meets a circle of radius R at a depth of R - sqrt(R^2 - x^2).
fn contact_edges(study: &Study, plan: &Plan, cut: &Response) -> Option<GradedNote> {
    let radius = cut.inflated.outer_radius_mm;
    let ground = &study.scene.ground;
    let middle = (ground.stations - 1) as f64 / 2.0;
    let mut edges = Vec::new();
    for (input, line) in study.inputs.iter().zip(plan.campaign().design()?.lines()) {
        let Some(station) = input.station() else {
            continue;
        };
        let x = ((station as f64 - middle) * ground.station_spacing_mm).min(radius);
        let touching = radius - (radius * radius - x * x).max(0.0).sqrt();
        let nodes = &line.rule().nodes;
        if nodes.iter().any(|depth| *depth <= touching)
            && nodes.iter().any(|depth| *depth > touching)
        {
            edges.push(format!("{} (at {touching:.2} mm)", input.name));
        }
    }
    let edges: Vec<&str> = edges.iter().map(String::as_str).collect();
    (!edges.is_empty()).then(|| {
        let text = format!(
            "Within the range of its depth the station of {} gains or loses contact, judged by the undeformed profile: \
             the strain bends there, and Gauss rules converge slowly.",
            listed(&edges)
        );
        GradedNote::bearing(Topic::Indices, text)
    })
}

/// Says which locations share their rank, as mirror images do.
fn ties(locations: &[RankedLocation]) -> Option<GradedNote> {
    let of_rank = |equals: &[RankedLocation]| {
        let names: Vec<&str> = equals.iter().map(|l| l.name.as_str()).collect();
        let (rank, is_certain) = (equals[0].rank, equals[0].rank_certain);
        let certain = if is_certain { ", which is certain" } else { "" };
        format!("{} share rank {rank}{certain}", listed(&names))
    };
    let runs = locations.chunk_by(|a, b| a.rank == b.rank);
    let ranks: Vec<String> = runs.filter(|run| run.len() > 1).map(of_rank).collect();
    (!ranks.is_empty()).then(|| {
        let text = format!(
            "Equal locations, as mirror images are, share a rank, and their order in it says nothing: {}.",
            ranks.join("; ")
        );
        GradedNote::record(Topic::Place, text)
    })
}
