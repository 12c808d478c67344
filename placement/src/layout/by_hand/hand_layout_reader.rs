//! Reads layouts that somebody moves by hand: films of the kinds that a finished study has stored.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry};
use document::fields::{Fields, shown};
use serde_json::Value;

use crate::layout::by_hand::film_fields::FilmKindPlace;
use crate::layout::by_hand::scored_by_hand::{HandAsked, MOST_FILMS, kinds_of};
use document::typed::field_value::read_name;
use document::typed::lists::distinct_list as list;
use documents::layouts::film_place_reader::film;
use documents::layouts::layout_bounds::LONGEST_LAYOUT;
use documents::layouts::layout_settings::{FreeLayout, direction_name};
use documents::layouts::reading::overlap_check::check_films;
use documents::parts::film_place::FilmPlace;
use documents::study::Study;

/// Most layouts at once.
const MOST_LAYOUTS: usize = 50;
/// Most layouts whose errors are simulated: each takes about a second of a core.
const MOST_SIMULATED: usize = 4;

/// Reads `{"layouts": [{"name": "mine", "films": [{"theta_deg": 0, "phi_deg": 0, "angle_deg": 90}]}], "simulated": true}`. A layout without a name is called by its number.
///
/// # Errors
/// Every fault at once.
pub fn hand_layouts(value: &Value, study: &Study) -> Result<HandAsked, Vec<Fault>> {
    let mut faults = Vec::new();
    let asked = read(value, study, &mut faults);
    match asked.filter(|_| faults.is_empty()) {
        Some(asked) => Ok(asked),
        None => Err(faults),
    }
}

fn read(value: &Value, study: &Study, faults: &mut Vec<Fault>) -> Option<HandAsked> {
    let fields = Fields::open(value, "", &["layouts", "simulated"], faults)?;
    let simulated = fields
        .get("simulated")
        .map(|(value, at)| (value.as_bool(), at));
    let (value, at) = fields.required("layouts", "a list of layouts", faults)?;
    let count = 1..=MOST_LAYOUTS;
    let Some(items) = value
        .as_array()
        .filter(|items| count.contains(&items.len()))
    else {
        let detail = format!(
            "must be a list of 1 to {MOST_LAYOUTS} layouts; it is {}",
            shown(value)
        );
        Fault::add(faults, &at, detail);
        return None;
    };
    match &simulated {
        Some((None, at)) => Fault::add(faults, at, "must be true or false"),
        Some((Some(true), at)) if items.len() > MOST_SIMULATED => {
            let detail = format!(
                "is for at most {MOST_SIMULATED} layouts at once; there are {}",
                items.len()
            );
            Fault::add(faults, at, detail);
        }
        _ => {}
    }
    let kinds = kinds_of(study);
    let layouts: Vec<Option<FreeLayout>> = items
        .iter()
        .enumerate()
        .map(|(i, item)| layout(item, &entry(&at, i), i, (study, &kinds), faults))
        .collect();
    Some(HandAsked {
        layouts: layouts.into_iter().collect::<Option<_>>()?,
        simulated: simulated.and_then(|(value, _)| value).unwrap_or(false),
    })
}

fn layout(
    value: &Value,
    pointer: &str,
    index: usize,
    (study, kinds): (&Study, &[FilmKindPlace]),
    faults: &mut Vec<Fault>,
) -> Option<FreeLayout> {
    let fields = Fields::open(value, pointer, &["name", "films"], faults)?;
    let name = match fields.get("name") {
        None => Some(format!("layout {}", index + 1)),
        Some(_) => read_name(&fields, "name", LONGEST_LAYOUT, faults),
    };
    let (value, at) = fields.required("films", "a list of films", faults)?;
    let films = list(value, &at, MOST_FILMS, faults, |value, at, faults| {
        let place = film(value, at, Some(&study.scene), faults)?;
        known(&place, kinds, at, faults).then_some(place)
    })?;
    if films.is_empty() {
        Fault::add(faults, &at, "must list a film; it is empty");
        return None;
    }
    let room = study.layouts.room(&study.scene.geometry);
    check_films(&films, &room, &study.layouts.limits, &at, faults);
    Some(FreeLayout { name: name?, films })
}

/// Whether what such a film reads is stored.
fn known(
    place: &FilmPlace,
    kinds: &[FilmKindPlace],
    pointer: &str,
    faults: &mut Vec<Fault>,
) -> bool {
    let is_it =
        |kind: &FilmKindPlace| kind.phi_deg == place.phi_deg && kind.angle_deg == place.angle_deg;
    let is_known = kinds.iter().any(is_it);
    if !is_known {
        let names: Vec<String> = kinds.iter().map(name).collect();
        let detail = format!(
            "is a kind of film that the study has nothing of; it has (phi_deg, direction): {}",
            names.join(", ")
        );
        Fault::add(faults, pointer, detail);
    }
    is_known
}

/// `45 y`
fn name(kind: &FilmKindPlace) -> String {
    format!("{} {}", kind.phi_deg, direction_name(kind.angle_deg))
}
