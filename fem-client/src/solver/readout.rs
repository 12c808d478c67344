//! Places where the strain is read.

use document::fault::Fault;
use document::fields::{Fields, Range};
use document::{Choice, Table};
use serde::{Deserialize, Serialize};

use crate::scene::Film;
use crate::solver::gauge::Gauge;

/// Places where the strain is read, beside P1-P5 and the section points that every response has.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Readout {
    /// Dense map of the inner surface; absent: no map.
    pub grid: Option<Grid>,
    /// Whether the map has the places of its points, too: a picture needs them of one point of a study, and no other grows by them.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub shape: bool,
    /// Whether the map has the places to which its points have moved, too: without where they were, which a neighbour says.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub positions: bool,
    /// Lines around the wheel.
    pub rings: Vec<RingLine>,
    /// Wheel angle from the contact centre up to which bricks grow slowly, degrees, where the ground itself asks for less: slopes of strains far from the
    /// contact need it.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub fine_deg: Option<f64>,
    /// Single points, each with a direction.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub gauges: Vec<Gauge>,
    /// Films without stiffness that follow the wall: what they would read of it.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub films: Vec<Film>,
    /// Paths of numbers of the scene by which the response is differentiated, as in `ground.depths_mm[2]`.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub derivatives: Vec<String>,
}

/// A line around the wheel.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RingLine {
    /// Section angle from the crown, degrees.
    pub section_deg: f64,
    /// Angles to the circumferential direction in which the strain is read beside 0 and 90, degrees.
    pub turned_deg: Vec<f64>,
}

impl RingLine {
    /// A line at a section angle (degrees), in both main directions alone.
    pub fn at(section_deg: f64) -> Self {
        Self {
            section_deg,
            turned_deg: Vec::new(),
        }
    }
}

/// A regular grid on the inner surface, centred on the contact, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, Table)]
#[table(rule = check_circumferential(circumferential), rule = check_meridional(meridional))]
pub struct Grid {
    /// Points along the circumference, odd.
    #[field(required = "an odd number of points, 3 to 201", within = GRID_POINTS)]
    pub circumferential: usize,
    /// Points from bead to bead, odd.
    #[field(required = "an odd number of points, 3 to 201", within = GRID_POINTS)]
    pub meridional: usize,
    /// Half of the circumferential extent, degrees.
    #[field(default = 45.0, within = HALF_WIDTH)]
    pub half_width_deg: f64,
}

/// Points along either side of a grid.
const GRID_POINTS: (u64, u64) = (3, 201);
const HALF_WIDTH: Range = Range::new(0.1, 180.0, "degrees");

fn check_circumferential(points: &usize, fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    check_odd(*points, &fields.at("circumferential"), faults);
}

fn check_meridional(points: &usize, fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    check_odd(*points, &fields.at("meridional"), faults);
}

fn check_odd(points: usize, at: &str, faults: &mut Vec<Fault>) {
    if points.is_multiple_of(2) {
        let detail = format!("must be odd, so that a point lies in the middle; it is {points}");
        Fault::add(faults, at, detail);
    }
}

/// Named meridional positions of a film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Choice)]
pub enum Position {
    /// 0 degrees from the crown.
    Crown,
    /// 45 degrees from the crown.
    Shoulder,
    /// 90 degrees from the crown.
    Sidewall,
}

impl Position {
    /// Meridional angle from the crown, degrees.
    pub const fn angle_deg(self) -> f64 {
        match self {
            Self::Crown => 0.0,
            Self::Shoulder => 45.0,
            Self::Sidewall => 90.0,
        }
    }
}
