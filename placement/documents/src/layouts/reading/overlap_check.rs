//! Layouts whose films would lie on each other, or where none may.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry, member};
use document::fields::Fields;
use fem_client::scene::Geometry;

use crate::layouts::film_rings::Ring;
use crate::layouts::film_room::FilmRoom;
use crate::layouts::gluing_limits::GluingLimits;
use crate::layouts::layout_settings::{Layouts, section_name, units_of};
use crate::parts::directions::Directions;
use crate::parts::film_place::FilmPlace;

/// A fault for each number of units whose films overlap, and for each film of a layout by hand that lies on an earlier one. What the menu offers is nobody's fault.
pub(crate) fn check_overlaps(
    layouts: &Layouts,
    fields: &Fields<'_>,
    geometry: &Geometry,
    directions: Directions,
    faults: &mut Vec<Fault>,
) {
    let room = layouts.room(geometry);
    let rings = layouts.rings(directions);
    let of_spacings = layouts
        .spacings_deg
        .iter()
        .map(|spacing| units_of(*spacing));
    let named = of_spacings.enumerate().map(|named| ("spacings_deg", named));
    let of_units = layouts.units.iter().copied().enumerate();
    for (list, (i, units)) in named.chain(of_units.map(|named| ("units", named))) {
        if let Some((section_deg, apart_mm)) = crowded_at(&rings, &room, units) {
            let detail = format!(
                "{units} units overlap at the {}: neighbours are {apart_mm:.1} mm apart there, and {} have no room; fewer units, another direction or smaller films have",
                section_name(section_deg),
                room.needs()
            );
            Fault::add(faults, &entry(&fields.at(list), i), detail);
        }
    }
    for (i, layout) in layouts.free.iter().enumerate() {
        let films = member(&entry(&fields.at("free"), i), "films");
        check_films(&layout.films, &room, &layouts.limits, &films, faults);
    }
}

/// A fault for each film of a layout by hand that overlaps an earlier one or one that is glued on already, or lies where none may.
pub fn check_films(
    films: &[FilmPlace],
    room: &FilmRoom,
    limits: &GluingLimits,
    pointer: &str,
    faults: &mut Vec<Fault>,
) {
    let apart = |film: &FilmPlace, other: &FilmPlace| {
        let [around, along] = room.between_mm(other, film);
        let distance = around.hypot(along);
        format!(
            "their middles are {distance:.1} mm apart, too near for {}",
            room.needs()
        )
    };
    for (j, film) in films.iter().enumerate() {
        let at = entry(pointer, j);
        let mut before = films.iter().take(j).enumerate();
        if let Some((other, place)) = before.find(|(_, other)| !room.has_both(film, other)) {
            let detail = format!(
                "overlaps film {other} of the layout: {}",
                apart(film, place)
            );
            Fault::add(faults, &at, detail);
        }
        let mut taken = limits.taken.iter().enumerate();
        let bars = |taken: &FilmPlace| !taken.is_same(film) && !room.has_both(film, taken);
        if let Some((other, place)) = taken.find(|(_, taken)| bars(taken)) {
            let detail = format!("overlaps taken film {other}: {}", apart(film, place));
            Fault::add(faults, &at, detail);
        }
        if !room.keeps_out(film, &limits.forbidden_deg) {
            let detail = "lies in a sector of forbidden_deg, or reaches into one";
            Fault::add(faults, &at, detail);
        }
    }
}

/// Returns the section angle where neighbours of so many units overlap, degrees, and how far these are apart, mm.
fn crowded_at(rings: &[Ring], room: &FilmRoom, units: usize) -> Option<(f64, f64)> {
    let mut named = rings
        .iter()
        .filter(|ring| !ring.of_menu && ring.units == units);
    named.find_map(|ring| {
        let (one, other) = room.crowded(&ring.places(2))?;
        let [around, _] = room.between_mm(&one, &other);
        Some((ring.section_deg, around.abs()))
    })
}
