//! Where the strain is read.

use serde::{Deserialize, Serialize};

use crate::scene::Film;
use crate::solver::gauge::Gauge;

/// Where the strain is read, beside P1-P5 and the section points that every response has.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Readout {
    /// Dense map of the inner surface; absent: no map.
    pub grid: Option<Grid>,
    /// Where the map's points lie, too: a picture needs it of one point of a study, and no other grows by it.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub shape: bool,
    /// Where the map's points have moved to, too: without where they were, which a neighbour says.
    #[serde(skip_serializing_if = "std::ops::Not::not", default)]
    pub positions: bool,
    /// Lines around the wheel.
    pub rings: Vec<RingLine>,
    /// Half of the sector around the contact that is meshed finely, degrees, where the ground itself asks for less: slopes of strains far from the contact
    /// need it.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub fine_deg: Option<f64>,
    /// Single points, each with a direction.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub gauges: Vec<Gauge>,
    /// Films without stiffness that follow the wall: what they would read of it.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub films: Vec<Film>,
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Points along the circumference, odd.
    pub circumferential: usize,
    /// Points from bead to bead, odd.
    pub meridional: usize,
    /// Half of the circumferential extent, degrees.
    pub half_width_deg: f64,
}

/// Named meridional positions of a film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
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
