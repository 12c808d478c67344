//! Reads the ground, and checks that it lies under the tire.

use serde_json::Value;

use super::shared_ranges::LENGTH;
use crate::document::fault::{Fault, entry};
use crate::document::fields::{Fields, Range, number, plain, shown};
use crate::scene::{Contact, Geometry, Ground, StationFunctions};

const LOAD: Range = Range::new(0.0, 1e9, "N");

/// Most stations of the ground.
pub const MAX_STATIONS: usize = 21;

pub(super) fn ground(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Ground> {
    let known = [
        "stations",
        "station_spacing_mm",
        "station_functions",
        "depths_mm",
        "load_n",
        "shift_mm",
    ];
    let fields = Fields::open(value, pointer, &known, faults)?;
    let default = Ground::default();
    let options = [
        ("bspline", StationFunctions::Bspline),
        ("hat", StationFunctions::Hat),
    ];
    let spacing = fields.number(
        "station_spacing_mm",
        LENGTH,
        default.station_spacing_mm,
        faults,
    );
    let functions = fields.choice(
        "station_functions",
        &options,
        default.station_functions,
        faults,
    );
    let depths = match fields.get("depths_mm") {
        None => Some(None),
        Some((value, pointer)) => depths(value, &pointer, faults).map(Some),
    };
    let load = match fields.get("load_n") {
        None => Some(None),
        Some((value, pointer)) => number(value, &pointer, LOAD, faults).map(Some),
    };
    let shift = match fields.get("shift_mm") {
        None => Some(default.shift_mm),
        Some((value, pointer)) => shift(value, &pointer, faults),
    };
    if let (Some((_, pointer)), Some(_)) = (fields.get("load_n"), fields.get("depths_mm")) {
        let detail = "stands in place of depths_mm, which is given too: leave one of them out";
        Fault::add(faults, &pointer, detail.to_owned());
    }
    let length = depths.as_ref().map_or(default.stations, |given| {
        given.as_ref().map_or(default.stations, Vec::len)
    });
    let stations =
        fields.integer("stations", (1, MAX_STATIONS as u64), length as u64, faults)? as usize;
    let depths = depths?;
    let given = depths.is_some() || fields.get("load_n").is_none();
    let depths = depths.unwrap_or_else(|| vec![1.0; if given { stations } else { 0 }]);
    if given && depths.len() != stations {
        let detail = format!(
            "must equal the length of depths_mm, which is {}; it is {stations}",
            depths.len()
        );
        Fault::add(faults, &fields.at("stations"), detail);
    } else if stations.is_multiple_of(2) {
        let detail = format!(
            "must be odd, so that one station lies at the contact centre; it is {stations}"
        );
        Fault::add(faults, &fields.at("stations"), detail);
    }
    Some(Ground {
        stations,
        station_spacing_mm: spacing?,
        station_functions: functions?,
        depths_mm: depths,
        load_n: load?,
        shift_mm: shift?,
    })
}

fn depths(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Vec<f64>> {
    let items = value
        .as_array()
        .filter(|items| (1..=MAX_STATIONS).contains(&items.len()));
    let Some(items) = items else {
        let detail = format!(
            "must be a list of 1 to {MAX_STATIONS} depths in mm; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
        return None;
    };
    entries(items, pointer, Range::new(0.0, LENGTH.high, "mm"), faults)
}

fn shift(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<[f64; 2]> {
    let Some(items) = value.as_array().filter(|items| items.len() == 2) else {
        let detail = format!(
            "must be a list of 2 ways in mm, along the wheel and across it; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
        return None;
    };
    let range = Range::new(-LENGTH.high, LENGTH.high, "mm");
    entries(items, pointer, range, faults)?.try_into().ok()
}

/// Reads all before stopping at the first None, so that every faulty entry is named.
fn entries(
    items: &[Value],
    pointer: &str,
    range: Range,
    faults: &mut Vec<Fault>,
) -> Option<Vec<f64>> {
    let read: Vec<Option<f64>> = items
        .iter()
        .enumerate()
        .map(|(i, item)| number(item, &entry(pointer, i), range, faults))
        .collect();
    read.into_iter().collect()
}

/// Rules that tie the ground to the tire above it.
pub(super) fn check_ground_under(
    geometry: &Geometry,
    ground: &Ground,
    pointer: &str,
    faults: &mut Vec<Fault>,
) {
    let deepest = Range::new(0.0, geometry.section_radius_mm, "mm (section_radius_mm)");
    let farthest = Range {
        low: -deepest.high,
        ..deepest
    };
    for (field, values, range) in [
        ("depths_mm", ground.depths_mm.as_slice(), deepest),
        ("shift_mm", ground.shift_mm.as_slice(), farthest),
    ] {
        let beyond = |value: f64| !(range.low..=range.high).contains(&value);
        for (i, value) in values.iter().enumerate().filter(|(_, v)| beyond(**v)) {
            let detail = format!("must be a number {range}; it is {}", plain(*value));
            Fault::add(faults, &format!("{pointer}/{field}/{i}"), detail);
        }
    }
    let half_width = (ground.stations - 1) as f64 / 2.0 * ground.station_spacing_mm;
    if half_width > geometry.outer_radius_mm {
        let largest = 2.0 * geometry.outer_radius_mm / (ground.stations - 1) as f64;
        let detail = format!(
            "must be at most {} mm, so that all stations lie below the tire",
            plain(largest)
        );
        Fault::add(faults, &format!("{pointer}/station_spacing_mm"), detail);
    }
}

/// Only friction lets dragged ground take the tire along.
pub(super) fn check_grip(
    ground: &Ground,
    contact: &Contact,
    pointer: &str,
    faults: &mut Vec<Fault>,
) {
    if ground.is_dragged() && contact.friction == 0.0 {
        let detail = "needs contact.friction: without friction the ground slides under the tire and nothing changes";
        Fault::add(faults, &format!("{pointer}/shift_mm"), detail.to_owned());
    }
}
