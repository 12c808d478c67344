//! Layouts whose films would lie on each other.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry, member};
use document::fields::Fields;
use fem_client::scene::Geometry;

use crate::layouts::film_room::FilmRoom;
use crate::layouts::layout_settings::{Layouts, section_name, units_of};
use crate::parts::directions::Directions;
use crate::parts::film_place::FilmPlace;

/// A fault for each number of units whose films overlap, and for each film of a layout by hand that lies on an earlier one. Of common spacings, which nobody wrote,
/// those that overlap are left out.
pub(crate) fn check_overlaps(
    layouts: &mut Layouts,
    fields: &Fields<'_>,
    geometry: &Geometry,
    directions: Directions,
    faults: &mut Vec<Fault>,
) {
    let room = FilmRoom::on(geometry, layouts.size_mm, 0.0);
    let Some([length, width]) = layouts.size_mm else {
        return;
    };
    let crowded = |layouts: &Layouts, units: usize| crowded_at(layouts, &room, units, directions);
    if fields.get("spacings_deg").is_none() {
        let mut spacings = std::mem::take(&mut layouts.spacings_deg);
        spacings.retain(|spacing| crowded(layouts, units_of(*spacing)).is_none());
        layouts.spacings_deg = spacings;
    }
    let of_spacings = layouts
        .spacings_deg
        .iter()
        .map(|spacing| units_of(*spacing));
    let named = of_spacings.enumerate().map(|named| ("spacings_deg", named));
    let of_units = layouts.units.iter().copied().enumerate();
    for (list, (i, units)) in named.chain(of_units.map(|named| ("units", named))) {
        if let Some((section_deg, apart_mm)) = crowded(layouts, units) {
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
fn crowded_at(
    layouts: &Layouts,
    room: &FilmRoom,
    units: usize,
    directions: Directions,
) -> Option<(f64, f64)> {
    let sections = layouts.sections_deg();
    let sets = layouts.sets(directions);
    let mut laid = sections
        .iter()
        .flat_map(|phi| sets.iter().map(move |set| (*phi, set)));
    laid.find_map(|(phi_deg, set)| {
        let rings = match layouts.staggered && set.len() > 1 {
            true => vec![
                ring(units, set, phi_deg, false),
                ring(units, set, phi_deg, true),
            ],
            false => vec![ring(units, set, phi_deg, false)],
        };
        let mut pairs = rings.iter().flat_map(|ring| pairs(ring));
        let (one, other) = pairs.find(|(one, other)| !room.has_both(one, other))?;
        let [around, _] = room.between_mm(one, other);
        Some((phi_deg, around.abs()))
    })
}

/// Films of two neighbouring units; staggered, those of a unit are spread up to the next.
fn ring(units: usize, set: &[f64], phi_deg: f64, staggered: bool) -> Vec<FilmPlace> {
    let spacing = 360.0 / units as f64;
    let step = match staggered {
        true => spacing / set.len() as f64,
        false => 0.0,
    };
    let unit = |number: usize| {
        set.iter().enumerate().map(move |(k, angle_deg)| FilmPlace {
            theta_deg: spacing * number as f64 + step * k as f64,
            phi_deg,
            angle_deg: *angle_deg,
        })
    };
    (0..units.min(2)).flat_map(unit).collect()
}

fn pairs(films: &[FilmPlace]) -> impl Iterator<Item = (&FilmPlace, &FilmPlace)> {
    let with_later = |(k, one)| films.iter().skip(k + 1).map(move |other| (one, other));
    films.iter().enumerate().flat_map(with_later)
}
