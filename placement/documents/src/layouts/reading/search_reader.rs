//! Reads a search for layouts: the table `layouts.search`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry, member};
use document::fields::{Fields, integer};
use fem_client::scene::Scene;
use serde_json::Value;

use crate::layouts::film_place_reader::{direction, entries, section};
use crate::layouts::layout_bounds::{MOST_ENTRIES, MOST_PLACES, MOST_SEARCHED, MOST_SLOTS};
use crate::layouts::layout_settings::{Layouts, SearchSettings};
use crate::layouts::reading::limits_reader::gluing_limits;

/// The layouts to search for, whose numbers of films are checked by [`check_places`]; `None` where the table asks for none, or has faults.
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
        limits: gluing_limits(&fields, "fixed", scene, faults),
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
    Some(search)
}

/// Faults where there are too many places to search, or more or fewer than a number of films.
pub(super) fn check_places(layouts: &Layouts, fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    let Some((search, pointer)) = layouts
        .search
        .as_ref()
        .zip(fields.get("search").map(|found| found.1))
    else {
        return;
    };
    let free = search.slots * search.section_deg.len() * search.directions.len();
    let fixed = layouts.search_limits().taken.len();
    let places = free + fixed;
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
        .find(|(_, films)| **films > places || **films < fixed)
    {
        let at = entry(&member(&pointer, "films"), i);
        let detail = match fixed {
            0 => format!("must be at most the {places} places that there are; it is {films}"),
            _ => format!(
                "counts the fixed films, too: it must be from {fixed} to the {places} places that there are; it is {films}"
            ),
        };
        Fault::add(faults, &at, detail);
    }
}
