//! Reads where films lie: section angles, directions, places, and lists of them.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::fields::{Fields, number, shown};
use document::typed::lists::distinct_list as list;
use fem_client::scene::Scene;
use serde_json::Value;

use crate::layouts::layout_bounds::ANGLE;
use crate::layouts::layout_settings::farthest_section_deg;
use crate::parts::film_place::FilmPlace;

/// Reads a list into its place, where it is given.
pub(super) fn entries<T: PartialEq>(
    fields: &Fields<'_>,
    name: &str,
    place: &mut Vec<T>,
    longest: usize,
    faults: &mut Vec<Fault>,
    read: impl Fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) {
    if let Some((value, pointer)) = fields.get(name)
        && let Some(items) = list(value, &pointer, longest, faults, read)
    {
        *place = items;
    }
}

/// A section angle up to a wall's thickness off the bead, where the clamp makes strains of its own.
pub(super) fn section(
    value: &Value,
    pointer: &str,
    scene: Option<&Scene>,
    faults: &mut Vec<Fault>,
) -> Option<f64> {
    let farthest = scene.map_or(180.0, |scene| farthest_section_deg(&scene.geometry));
    let read = value.as_f64().filter(|angle| angle.abs() <= farthest);
    if read.is_none() {
        let detail = format!(
            "must be an angle from the crown of -{farthest:.1} to {farthest:.1} degrees, a wall's thickness off the bead; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
    }
    read.map(|angle| angle + 0.0)
}

/// A direction, degrees to the circumference: a name or an angle.
pub(super) fn direction(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<f64> {
    match value.as_str() {
        Some("x") => Some(0.0),
        Some("y") => Some(90.0),
        None if value.is_number() => number(value, pointer, ANGLE, faults),
        _ => {
            Fault::add(
                faults,
                pointer,
                format!(
                    "must be \"x\", \"y\" or an angle in degrees; it is {}",
                    shown(value)
                ),
            );
            None
        }
    }
}

/// Reads where a film lies, on a scene where it is known.
pub fn film(
    value: &Value,
    pointer: &str,
    scene: Option<&Scene>,
    faults: &mut Vec<Fault>,
) -> Option<FilmPlace> {
    let fields = Fields::open(
        value,
        pointer,
        &["theta_deg", "phi_deg", "angle_deg"],
        faults,
    )?;
    let theta_deg = fields.number("theta_deg", ANGLE, 0.0, faults);
    let phi_deg = fields
        .get("phi_deg")
        .map_or(Some(0.0), |(value, at)| section(value, &at, scene, faults));
    let angle_deg = fields.number("angle_deg", ANGLE, 0.0, faults);
    Some(FilmPlace {
        theta_deg: theta_deg?,
        phi_deg: phi_deg?,
        angle_deg: angle_deg?,
    })
}
