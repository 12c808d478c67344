//! Reads limits to where films can be glued, of all layouts or of a search.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry};
use document::fields::{Fields, number, shown};
use fem_client::scene::Scene;
use serde_json::Value;

use crate::layouts::film_place_reader::{entries, film};
use crate::layouts::gluing_limits::GluingLimits;
use crate::layouts::layout_bounds::{ANGLE, DISTANCE, MOST_ENTRIES};

/// The limits; films that are glued on already are listed by this name.
pub(super) fn gluing_limits(
    fields: &Fields<'_>,
    taken: &str,
    scene: Option<&Scene>,
    faults: &mut Vec<Fault>,
) -> GluingLimits {
    let mut limits = GluingLimits::default();
    let glued = |value: &Value, at: &str, faults: &mut Vec<Fault>| film(value, at, scene, faults);
    entries(
        fields,
        taken,
        &mut limits.taken,
        MOST_ENTRIES,
        faults,
        glued,
    );
    let sectors = &mut limits.forbidden_deg;
    entries(
        fields,
        "forbidden_deg",
        sectors,
        MOST_ENTRIES,
        faults,
        sector,
    );
    let least = fields.number("least_distance_mm", DISTANCE, 0.0, faults);
    limits.least_distance_mm = least.unwrap_or_default();
    limits
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
