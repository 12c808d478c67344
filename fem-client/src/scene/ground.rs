//! The ground, and whether it lies under the tire.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::fields::{Fields, Range, plain};
use document::typed::lists::{Each, Entries};
use document::{Choice, Table};

use super::contact::Contact;
use super::geometry::Geometry;
use super::ground_profile::{GroundProfile, ProfileKind};
use super::shared_ranges::LENGTH;

/// Forces that press the ground.
pub const LOAD: Range = Range::new(0.0, 1e9, "N");
/// Depths of the ground below the inflated tire.
pub const DEPTH: Range = Range::new(0.0, LENGTH.high, "mm");
/// Inclinations of the wheel.
const CAMBER: Range = Range::new(-30.0, 30.0, "degrees");
const WAY: Range = Range::new(-LENGTH.high, LENGTH.high, "mm");
/// Least correlation length of rough ground, of the wall. At a half strains at P3 differ by 3 % of the change between the coarse and the standard mesh of the foot tire, moments by a sixth; at
/// a third moments differ by their size.
const FINEST_OF_WALL: f64 = 0.5;
/// Most stations of the ground.
const MAX_STATIONS: usize = 21;
/// Stations, and their depths in mm, of a ground of which nothing is said.
const USUAL_STATIONS: usize = 5;
const USUAL_DEPTH: f64 = 1.0;

/// Rigid height field over stations along the circumference, each pressed in by its own depth, below a wheel that may lean.
#[derive(Debug, Clone, PartialEq, Table)]
#[table(rule = check_one_given(), rule = check_stations(stations, depths_mm), then = completed)]
pub struct Ground {
    /// Number of stations, odd; the length of `depths_mm` where there is one.
    #[field(default = USUAL_STATIONS, within = (1, MAX_STATIONS as u64))]
    pub stations: usize,
    /// Horizontal distance of neighbouring stations, mm.
    #[field(default = 5.5, within = LENGTH)]
    pub station_spacing_mm: f64,
    /// Shape functions of the height field.
    #[field(default = StationFunctions::Bspline)]
    pub station_functions: StationFunctions,
    /// Depth of each station, mm, along the ground's normal from where flat ground touches the inflated tire; none where a load is given.
    #[field(default = vec![USUAL_DEPTH; USUAL_STATIONS], with = depths)]
    pub depths_mm: Vec<f64>,
    /// Force along its normal with which a flat ground presses on the whole tire, N, in place of depths.
    #[field(within = LOAD)]
    pub load_n: Option<f64>,
    /// Ways by which the ground is dragged once it presses, mm: along the wheel (x, rolling direction) and across it (y, along the axle).
    #[field(omitted, within = Each::of("a list of 2 ways in mm, along the wheel and across it", WAY))]
    pub shift_mm: [f64; 2],
    /// Inclination of the wheel to the ground's normal, degrees, right-handed about x: a positive one leans the top towards -y and presses the side at negative section
    /// angles.
    #[field(omitted, within = CAMBER)]
    pub camber_deg: f64,
    /// Profile of the ground beside its stations, the same at every depth; a plane when left out.
    pub profile: Option<GroundProfile>,
}

/// Shape functions of the height field; they sum to one everywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum StationFunctions {
    /// Uniform cubic B-splines.
    Bspline,
    /// Piecewise linear.
    Hat,
}

/// Depths, which the canonical text leaves out where a load stands in their place.
mod depths {
    use document::Value;
    use document::fault::Fault;
    use document::json_schema::Schemas;
    use document::typed::field_value::Field;

    use super::*;

    const WITHIN: Entries<Range> = Entries::of(1, MAX_STATIONS, "depths in mm", DEPTH);

    pub fn read(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<Vec<f64>> {
        Vec::read(value, at, &WITHIN, faults)
    }

    pub fn write(depths: &Vec<f64>) -> Option<Value> {
        depths.write().filter(|_| !depths.is_empty())
    }

    pub fn schema(schemas: &mut Schemas) -> Value {
        Vec::<f64>::schema(&WITHIN, schemas)
    }
}

impl Ground {
    /// Whether before and behind the contact centre are alike.
    pub fn is_symmetric(&self) -> bool {
        let depths = &self.depths_mm;
        let is_even = depths.iter().zip(depths.iter().rev()).all(|(a, b)| a == b);
        let of_profile = self.profile.as_ref();
        is_even && self.shift_mm[0] == 0.0 && of_profile.is_none_or(GroundProfile::is_symmetric)
    }

    /// Whether both sides of the wheel's middle plane are alike.
    pub fn is_alike_across(&self) -> bool {
        let of_profile = self.profile.as_ref();
        let is_alike = of_profile.is_none_or(GroundProfile::is_alike_across);
        self.shift_mm[1] == 0.0 && !self.leans() && is_alike
    }

    /// Whether the wheel leans to it.
    pub fn leans(&self) -> bool {
        self.camber_deg != 0.0
    }

    /// Whether it may push the wheel to a side: the wheel leans, or the ground's height varies across.
    pub fn may_push_across(&self) -> bool {
        let of_profile = self.profile.as_ref();
        self.leans() || of_profile.is_some_and(GroundProfile::varies_across)
    }

    /// Whether it is dragged.
    pub fn is_dragged(&self) -> bool {
        self.shift_mm != [0.0; 2]
    }

    /// Returns this ground with its stations at these depths, mm.
    pub fn at_depths(&self, depths_mm: Vec<f64>) -> Self {
        Self {
            depths_mm,
            load_n: None,
            ..self.clone()
        }
    }

    /// Returns this ground before it is dragged.
    pub fn undragged(&self) -> Self {
        Self {
            shift_mm: [0.0; 2],
            ..self.clone()
        }
    }
}

fn check_one_given(fields: &Fields<'_>, faults: &mut Vec<Fault>) {
    if let (Some((_, at)), Some(_)) = (fields.get("load_n"), fields.get("depths_mm")) {
        let detail = "stands in place of depths_mm, which is given too: leave one of them out";
        Fault::add(faults, &at, detail);
    }
    if let (Some((_, at)), Some(_)) = (fields.get("load_n"), fields.get("profile")) {
        let detail = "presses flat ground: leave it or profile out; depths_mm go with a profile";
        Fault::add(faults, &at, detail);
    }
}

/// Stations are as many as depths, and odd.
fn check_stations(
    stations: &usize,
    depths_mm: &[f64],
    fields: &Fields<'_>,
    faults: &mut Vec<Fault>,
) {
    let has = |name: &str| fields.get(name).is_some();
    let stations = match has("stations") {
        true => *stations,
        false => depths_mm.len(),
    };
    if has("depths_mm") && depths_mm.len() != stations {
        let detail = format!(
            "must equal the length of depths_mm, which is {}; it is {stations}",
            depths_mm.len()
        );
        Fault::add(faults, &fields.at("stations"), detail);
    } else if stations.is_multiple_of(2) {
        let detail = format!(
            "must be odd, so that one station lies at the contact centre; it is {stations}"
        );
        Fault::add(faults, &fields.at("stations"), detail);
    }
}

/// Stations and depths follow from each other, and depths from a load.
fn completed(mut ground: Ground, fields: &Fields<'_>) -> Ground {
    let has = |name: &str| fields.get(name).is_some();
    if !has("stations") {
        ground.stations = ground.depths_mm.len();
    }
    if !has("depths_mm") {
        ground.depths_mm = match has("load_n") {
            true => Vec::new(),
            false => vec![USUAL_DEPTH; ground.stations],
        };
    }
    ground
}

/// Rules that tie the ground to the tire above it.
pub(super) fn check_under(
    geometry: &Geometry,
    ground: &Ground,
    scene: &Fields<'_>,
    faults: &mut Vec<Fault>,
) {
    let at = scene.at("ground");
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
            Fault::add(faults, &format!("{at}/{field}/{i}"), detail);
        }
    }
    let own = ground
        .profile
        .as_ref()
        .filter(|own| own.kind == ProfileKind::Rough);
    let finest = FINEST_OF_WALL * geometry.wall_mm;
    if let Some(rough) = own
        .map(GroundProfile::roughness)
        .filter(|own| own.correlation_mm < finest)
    {
        let detail = format!(
            "must be at least {} mm, half of the wall: meshes are too coarse for finer roughness; it is {}",
            plain(finest),
            plain(rough.correlation_mm)
        );
        Fault::add(faults, &format!("{at}/profile/correlation_mm"), detail);
    }
    let half_width = (ground.stations - 1) as f64 / 2.0 * ground.station_spacing_mm;
    if half_width > geometry.outer_radius_mm {
        let largest = 2.0 * geometry.outer_radius_mm / (ground.stations - 1) as f64;
        let detail = format!(
            "must be at most {} mm, so that all stations lie below the tire",
            plain(largest)
        );
        Fault::add(faults, &format!("{at}/station_spacing_mm"), detail);
    }
}

/// Only friction lets dragged ground take the tire along.
pub(super) fn check_grip(
    ground: &Ground,
    contact: &Contact,
    scene: &Fields<'_>,
    faults: &mut Vec<Fault>,
) {
    if ground.is_dragged() && contact.friction == 0.0 {
        let detail = "needs contact.friction: without friction the ground slides under the tire and nothing changes";
        Fault::add(faults, &format!("{}/shift_mm", scene.at("ground")), detail);
    }
}
