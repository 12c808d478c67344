//! Reads a search for layouts: the table `layouts.search`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry, member};
use document::fields::{Fields, integer, number, shown};
use fem_client::scene::Scene;
use serde_json::Value;

use crate::layouts::film_place_reader::{direction, entries, film, section};
use crate::layouts::layout_bounds::{
    ANGLE, DISTANCE, MOST_ENTRIES, MOST_PLACES, MOST_SEARCHED, MOST_SLOTS,
};
use crate::layouts::layout_settings::SearchSettings;

/// The layouts to search for; `None` where the table asks for none, or has faults.
pub(super) fn search(
    fields: &Fields<'_>,
    scene: Option<&Scene>,
    faults: &mut Vec<Fault>,
) -> Option<SearchSettings> {
    let (value, pointer) = fields.get("search")?;
    let fields = Fields::open(
        value,
        &pointer,
        &[
            "films",
            "slots",
            "section_deg",
            "directions",
            "fixed",
            "forbidden_deg",
            "least_distance_mm",
        ],
        faults,
    )?;
    let mut search = SearchSettings {
        films: Vec::new(),
        slots: 24,
        section_deg: vec![0.0],
        directions: vec![0.0, 90.0],
        fixed: Vec::new(),
        forbidden_deg: Vec::new(),
        least_distance_mm: fields.number("least_distance_mm", DISTANCE, 0.0, faults)?,
    };
    fields.required("films", "a list of numbers of films", faults)?;
    entries(
        &fields,
        "films",
        &mut search.films,
        MOST_ENTRIES,
        faults,
        |value, at, faults| {
            integer(value, at, 1, MOST_SEARCHED, faults).map(|films| films as usize)
        },
    );
    search.slots = fields.integer("slots", (3, MOST_SLOTS), 24, faults)? as usize;
    let section =
        |value: &Value, at: &str, faults: &mut Vec<Fault>| section(value, at, scene, faults);
    entries(
        &fields,
        "section_deg",
        &mut search.section_deg,
        MOST_ENTRIES,
        faults,
        section,
    );
    entries(
        &fields,
        "directions",
        &mut search.directions,
        MOST_ENTRIES,
        faults,
        direction,
    );
    let fixed = |value: &Value, at: &str, faults: &mut Vec<Fault>| film(value, at, scene, faults);
    entries(
        &fields,
        "fixed",
        &mut search.fixed,
        MOST_ENTRIES,
        faults,
        fixed,
    );
    entries(
        &fields,
        "forbidden_deg",
        &mut search.forbidden_deg,
        MOST_ENTRIES,
        faults,
        sector,
    );
    for (name, is_empty) in [
        ("films", search.films.is_empty()),
        ("section_deg", search.section_deg.is_empty()),
        ("directions", search.directions.is_empty()),
    ] {
        if is_empty {
            Fault::add(
                faults,
                &member(&pointer, name),
                "must have an entry; it is empty",
            );
        }
    }
    let free = search.slots * search.section_deg.len() * search.directions.len();
    let places = free + search.fixed.len();
    if places > MOST_PLACES {
        let detail = format!(
            "slots times section angles times directions are {places} places; a search tries at most {MOST_PLACES}"
        );
        Fault::add(faults, &pointer, detail);
    }
    if let Some((i, films)) = search
        .films
        .iter()
        .enumerate()
        .find(|(_, films)| **films > places || **films < search.fixed.len())
    {
        let at = entry(&member(&pointer, "films"), i);
        let detail = match search.fixed.len() {
            0 => format!("must be at most the {places} places that there are; it is {films}"),
            fixed => format!(
                "counts the fixed films, too: it must be from {fixed} to the {places} places that there are; it is {films}"
            ),
        };
        Fault::add(faults, &at, detail);
    }
    Some(search)
}

/// A sector of the wheel, from one angle to another in the rolling direction, degrees.
fn sector(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<[f64; 2]> {
    let Some([from, to]) = value.as_array().map(Vec::as_slice) else {
        let detail = format!(
            "must be two angles in degrees, from and to, as [165, 195]; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
        return None;
    };
    let from = number(from, &entry(pointer, 0), ANGLE, faults);
    let to = number(to, &entry(pointer, 1), ANGLE, faults);
    Some([from?, to?])
}
