//! Layouts whose films would lie on each other.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry, member};
use document::fields::Fields;
use fem_client::scene::Geometry;

use crate::layouts::film_rings::Ring;
use crate::layouts::film_room::FilmRoom;
use crate::layouts::layout_settings::{Layouts, section_name, units_of};
use crate::parts::directions::Directions;

/// A fault for each number of units whose films overlap, and for each film of a layout by hand that lies on an earlier one. What the menu offers is nobody's fault.
pub(crate) fn check_overlaps(
    layouts: &Layouts,
    fields: &Fields<'_>,
    geometry: &Geometry,
    directions: Directions,
    faults: &mut Vec<Fault>,
) {
    let room = FilmRoom::on(geometry, layouts.size_mm, 0.0);
    let Some([length, width]) = layouts.size_mm else {
        return;
    };
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
                "{units} units overlap at the {}: neighbours are {apart_mm:.1} mm apart there, and films of {length} x {width} mm have no room; fewer units, another direction or smaller films have",
                section_name(section_deg)
            );
            Fault::add(faults, &entry(&fields.at(list), i), detail);
        }
    }
    for (i, layout) in layouts.free.iter().enumerate() {
        let films = member(&entry(&fields.at("free"), i), "films");
        for (j, film) in layout.films.iter().enumerate() {
            let before = layout.films.iter().take(j);
            let under = before
                .enumerate()
                .find(|(_, other)| !room.has_both(film, other));
            if let Some((other, place)) = under {
                let [around, along] = room.between_mm(place, film);
                let detail = format!(
                    "overlaps film {other} of the layout: their middles are {:.1} mm apart, and films are {length} x {width} mm",
                    around.hypot(along)
                );
                Fault::add(faults, &entry(&films, j), detail);
            }
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
