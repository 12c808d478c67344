//! Reads which strains are asked for, and where: directions and the dense map.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use fem_client::document::fault::{Fault, entry};
use fem_client::document::fields::{Fields, Range, choice, shown};
use fem_client::solver::Grid;
use fem_client::solver::direction::Direction;
use serde_json::Value;

use crate::study::directions::Directions;

/// Most points along either side of the dense map.
const MOST_GRID_POINTS: u64 = 201;
const HALF_WIDTH: Range = Range::new(0.1, 180.0, "degrees");
const DEFAULT_HALF_WIDTH_DEG: f64 = 45.0;

/// Which strains, and the dense map where the study asks for one.
pub(crate) fn candidates(
    fields: &Fields<'_>,
    faults: &mut Vec<Fault>,
) -> Option<(Directions, Option<Grid>)> {
    let Some((value, pointer)) = fields.get("candidates") else {
        return Some((Directions::Both, None));
    };
    let known = ["points", "directions", "grid"];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    fields.choice("points", &[("P1-P5", ())], (), faults);
    let directions = directions(&fields, faults);
    let grid = grid(&fields, faults);
    Some((directions?, grid?))
}

fn directions(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Directions> {
    let Some((value, pointer)) = fields.get("directions") else {
        return Some(Directions::Both);
    };
    let known = Direction::ALL.map(|direction| (direction.as_str(), direction));
    let named = list(value, &pointer, known.len(), faults, |value, at, faults| {
        choice(value, at, &known, faults)
    })?;
    let directions = Directions::of(&named);
    if directions.is_none() {
        Fault::add(faults, &pointer, "must name x, y or both; it is empty");
    }
    directions
}

/// The dense map; Some(None) when the study asks for none.
fn grid(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Option<Grid>> {
    let Some((value, pointer)) = fields.get("grid") else {
        return Some(None);
    };
    let known = ["circumferential", "meridional", "half_width_deg"];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    let circumferential = grid_points(&fields, "circumferential", faults);
    let meridional = grid_points(&fields, "meridional", faults);
    let half_width = fields.number("half_width_deg", HALF_WIDTH, DEFAULT_HALF_WIDTH_DEG, faults);
    Some(Some(Grid {
        circumferential: circumferential?,
        meridional: meridional?,
        half_width_deg: half_width?,
    }))
}

fn grid_points(fields: &Fields<'_>, name: &str, faults: &mut Vec<Fault>) -> Option<usize> {
    let what = format!("an odd number of points, 3 to {MOST_GRID_POINTS}");
    fields.required(name, &what, faults)?;
    let points = fields.integer(name, (3, MOST_GRID_POINTS), 3, faults)?;
    if points.is_multiple_of(2) {
        let detail = format!("must be odd, so that a point lies in the middle; it is {points}");
        Fault::add(faults, &fields.at(name), detail);
    }
    Some(points as usize)
}

/// Reads a list whose entries differ; all entries are read before the first fault ends it.
pub(crate) fn list<T: PartialEq>(
    value: &Value,
    pointer: &str,
    longest: usize,
    faults: &mut Vec<Fault>,
    read: impl Fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<Vec<T>> {
    let Some(items) = value.as_array().filter(|items| items.len() <= longest) else {
        let detail = format!(
            "must be a list of at most {longest} entries; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
        return None;
    };
    let mut read_items = Vec::new();
    for (i, item) in items.iter().enumerate() {
        let at = entry(pointer, i);
        let Some(item) = read(item, &at, faults) else {
            continue;
        };
        if read_items.contains(&item) {
            Fault::add(faults, &at, "is in the list already");
        }
        read_items.push(item);
    }
    (read_items.len() == items.len()).then_some(read_items)
}
