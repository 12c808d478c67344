//! Reads the tire's shape.

use serde_json::Value;

use super::shared_ranges::LENGTH;
use crate::document::fault::{Fault, member};
use crate::document::fields::{Fields, Range, plain, shown};
use crate::scene::Geometry;

const BEAD_ANGLE: Range = Range::new(60.0, 150.0, "degrees");
/// Thinnest wall, in section radii: below it the solid elements degenerate.
const THINNEST_WALL: f64 = 1e-3;
/// Least radius of the bead about the axle, in outer radii: the torus must have a hole.
const SMALLEST_BEAD_RADIUS: f64 = 0.01;

pub(super) fn geometry(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Geometry> {
    check_kind(value, pointer, faults)?;
    let mut shape = Geometry::default();
    let numbers = [
        ("outer_radius_mm", LENGTH, &mut shape.outer_radius_mm),
        ("section_radius_mm", LENGTH, &mut shape.section_radius_mm),
        ("wall_mm", LENGTH, &mut shape.wall_mm),
        ("bead_angle_deg", BEAD_ANGLE, &mut shape.bead_angle_deg),
    ];
    let fields = Fields::of_numbers(value, pointer, &["kind"], numbers, faults)?;
    check_shape(&shape, &fields, faults);
    Some(shape)
}

/// Only the tire is modelled: another kind is one fault, whatever its fields are.
fn check_kind(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<()> {
    let Some(kind) = value
        .get("kind")
        .filter(|kind| kind.as_str() != Some("tire"))
    else {
        return Some(());
    };
    let known = ["ring", "cylinder", "sphere", "block", "mesh"]
        .iter()
        .find(|name| kind.as_str() == Some(name));
    let detail = match known {
        Some(name) => format!("this version models only \"tire\"; \"{name}\" isn't available yet"),
        None => format!(
            "must be \"tire\", the only kind that this version models; it is {}",
            shown(kind)
        ),
    };
    Fault::add(faults, &member(pointer, "kind"), detail);
    None
}

fn check_shape(geometry: &Geometry, fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    let Geometry {
        outer_radius_mm: outer,
        section_radius_mm: section,
        wall_mm: wall,
        bead_angle_deg,
        ..
    } = *geometry;
    if wall >= section {
        let detail = format!(
            "must be less than section_radius_mm ({} mm), or there is no cavity; it is {} mm",
            plain(section),
            plain(wall)
        );
        Fault::add(faults, &fields.at("wall_mm"), detail);
    } else if wall < THINNEST_WALL * section {
        let detail = format!(
            "must be at least {} mm, a thousandth of section_radius_mm",
            plain(THINNEST_WALL * section)
        );
        Fault::add(faults, &fields.at("wall_mm"), detail);
    }
    let span = 1.0 - bead_angle_deg.to_radians().cos();
    if outer - section * span < SMALLEST_BEAD_RADIUS * outer {
        let largest = (1.0 - SMALLEST_BEAD_RADIUS) * outer / span;
        let detail = format!(
            "must be at most {:.6} mm for this outer radius and bead angle, or the beads reach the axle; it is {} mm",
            largest,
            plain(section)
        );
        Fault::add(faults, &fields.at("section_radius_mm"), detail);
    }
}
