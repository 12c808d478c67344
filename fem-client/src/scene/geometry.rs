//! Shape of the tire.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, member};
use document::fields::{Fields, Range, plain, shown};
use document::{Choice, Table, Value};

use super::shared_ranges::LENGTH;

const BEAD_ANGLE: Range = Range::new(60.0, 150.0, "degrees");
/// Thinnest wall, in section radii: below it the solid elements degenerate.
const THINNEST_WALL: f64 = 1e-3;
/// Least radius of the bead about the axle, in outer radii: the torus must have a hole.
const SMALLEST_BEAD_RADIUS: f64 = 0.01;

/// A toroidal tire whose wall is an arc of a ring section, clamped at the beads.
#[derive(Debug, Clone, PartialEq, Table)]
#[table(before = check_kind, rule = check_shape)]
pub struct Geometry {
    /// Kind of body; only the tire is modelled so far.
    #[field(default = GeometryKind::Tire)]
    pub kind: GeometryKind,
    /// Radius of the uninflated tire at the crown, mm.
    #[field(default = 50.0, within = LENGTH)]
    pub outer_radius_mm: f64,
    /// Outer radius of the toroidal section, mm.
    #[field(default = 12.5, within = LENGTH)]
    pub section_radius_mm: f64,
    /// Wall thickness, mm.
    #[field(default = 3.0, within = LENGTH)]
    pub wall_mm: f64,
    /// Angle from the crown at which the wall ends and is clamped, degrees.
    #[field(default = 120.0, within = BEAD_ANGLE)]
    pub bead_angle_deg: f64,
}

/// Kinds of bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum GeometryKind {
    /// Pneumatic tire.
    Tire,
}

/// Only the tire is modelled: another kind is one fault, whatever its fields are.
fn check_kind(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<()> {
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
    Fault::add(faults, &member(at, "kind"), detail);
    None
}

fn check_shape(geometry: &Geometry, fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<()> {
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
    // What else stands in the scene is judged with this shape all the same.
    Some(())
}
