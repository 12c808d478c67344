//! Profile of the ground: a sphere on it, a cylinder that lies there, an edge, or roughness.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::fields::{Fields, Range, plain};
use document::typed::lists::Each;
use document::{Choice, Table};

use super::shared_ranges::LENGTH;

const PLACE: Range = Range::new(-LENGTH.high, LENGTH.high, "mm");
const ANGLE: Range = Range::new(-360.0, 360.0, "degrees");
/// Radius of a profile of which nothing is said, mm.
const USUAL_RADIUS: f64 = 10.0;
/// Direction across the wheel, degrees.
const ACROSS: f64 = 90.0;
/// Deviation and correlation length of rough ground of which nothing is said, mm, and its seed.
const USUAL_ROUGH: Roughness = Roughness {
    rms_mm: 0.1,
    correlation_mm: 5.0,
    seed: 1,
};
/// Most that the deviation may be of the correlation length: flanks are then 34 degrees steep at their deviation, 2 rms / length.
const ROUGHEST: f64 = 1.0 / 3.0;

/// Profile of the ground: the highest points of a sphere, a cylinder and an edge are as high as the stations' ground, the mean of rough ground is.
#[derive(Debug, Clone, PartialEq, Table)]
#[table(rule = check_rough(kind, rms_mm, correlation_mm), then = completed)]
pub struct GroundProfile {
    /// Kind of the profile.
    #[field(default = ProfileKind::Sphere)]
    pub kind: ProfileKind,
    /// Radius of the round, mm.
    #[field(default = USUAL_RADIUS, within = LENGTH)]
    pub radius_mm: f64,
    /// Place of its highest point, along the wheel (x, rolling direction) and across it (y, along the axle) from where the tire touches flat ground, mm.
    #[field(default = [0.0; 2], within = Each::of("a list of 2 places in mm, along the wheel and across it", PLACE))]
    pub place_mm: [f64; 2],
    /// Direction of a cylinder's axis or an edge, degrees from the rolling direction; 90 is across the wheel. An edge falls off to the left of it; a sphere and rough ground have none.
    #[field(default = ACROSS, within = ANGLE)]
    pub direction_deg: f64,
    /// Standard deviation of rough ground's height, mm; 0.1 when left out there.
    #[field(within = LENGTH)]
    pub rms_mm: Option<f64>,
    /// Distance over which the correlation of rough ground's heights falls to 1/e, mm, at least three deviations; 5 when left out there.
    #[field(within = LENGTH)]
    pub correlation_mm: Option<f64>,
    /// Seed from which rough ground is drawn; 1 when left out there.
    #[field(within = (0, u64::MAX))]
    pub seed: Option<u64>,
}

/// Roughness of rough ground: a normal field of heights whose correlation over a distance r is exp(-(r / correlation_mm)^2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    /// Standard deviation of the height, mm.
    pub rms_mm: f64,
    /// Correlation length, mm.
    pub correlation_mm: f64,
    /// Seed of the draw.
    pub seed: u64,
}

/// Kind of a profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum ProfileKind {
    /// A sphere; beyond nine tenths of its radius a cone goes on from there.
    Sphere,
    /// A cylinder that lies on the ground; beyond nine tenths of its radius planes go on from there.
    Cylinder,
    /// A rounded edge, behind which the ground falls off.
    Edge,
    /// Rough ground.
    Rough,
}

impl GroundProfile {
    /// Roughness of it, where nothing is said the usual one.
    pub fn roughness(&self) -> Roughness {
        Roughness {
            rms_mm: self.rms_mm.unwrap_or(USUAL_ROUGH.rms_mm),
            correlation_mm: self.correlation_mm.unwrap_or(USUAL_ROUGH.correlation_mm),
            seed: self.seed.unwrap_or(USUAL_ROUGH.seed),
        }
    }

    /// Unit vector to the left of its direction; exact where that is along the wheel or across it.
    pub fn left(&self) -> [f64; 2] {
        match self.direction_deg.rem_euclid(360.0) {
            0.0 => [0.0, 1.0],
            90.0 => [-1.0, 0.0],
            180.0 => [0.0, -1.0],
            270.0 => [1.0, 0.0],
            other => {
                let (sin, cos) = other.to_radians().sin_cos();
                [-sin, cos]
            }
        }
    }

    /// Whether before and behind the contact centre are alike.
    pub(super) fn is_symmetric(&self) -> bool {
        self.is_even(self.place_mm, self.left())
    }

    /// Whether both sides of the wheel's middle plane are alike.
    pub(super) fn is_alike_across(&self) -> bool {
        let [place, left] = [self.place_mm, self.left()].map(|[x, y]| [y, x]);
        self.is_even(place, left)
    }

    /// Whether its height varies across the wheel.
    pub(super) fn varies_across(&self) -> bool {
        let [_, across] = self.left();
        match self.kind {
            ProfileKind::Sphere | ProfileKind::Rough => true,
            ProfileKind::Cylinder | ProfileKind::Edge => across != 0.0,
        }
    }

    /// Whether it is its own image where the first coordinate of these, its place and the vector to its left, changes its sign.
    fn is_even(&self, [place, _]: [f64; 2], [left, other]: [f64; 2]) -> bool {
        match self.kind {
            ProfileKind::Sphere => place == 0.0,
            ProfileKind::Cylinder => left == 0.0 || (other == 0.0 && place == 0.0),
            ProfileKind::Edge => left == 0.0,
            ProfileKind::Rough => false,
        }
    }
}

/// Roughness is rough ground's alone, and no steeper than a gap along the normal can say.
fn check_rough(
    kind: &ProfileKind,
    rms_mm: &Option<f64>,
    correlation_mm: &Option<f64>,
    fields: &Fields<'_>,
    faults: &mut Vec<Fault>,
) {
    if *kind != ProfileKind::Rough {
        for field in ["rms_mm", "correlation_mm", "seed"] {
            if let Some((_, at)) = fields.get(field) {
                Fault::add(faults, &at, "belongs to kind \"rough\": leave it out");
            }
        }
        return;
    }
    let length = correlation_mm.unwrap_or(USUAL_ROUGH.correlation_mm);
    let rms = rms_mm.unwrap_or(USUAL_ROUGH.rms_mm);
    if rms > ROUGHEST * length {
        let detail = format!(
            "must be at most a third of correlation_mm ({} mm); it is {}",
            plain(length),
            plain(rms)
        );
        Fault::add(faults, &fields.at("rms_mm"), detail);
    }
}

/// Rough ground says all of its roughness.
fn completed(mut profile: GroundProfile, _: &Fields<'_>) -> GroundProfile {
    if profile.kind == ProfileKind::Rough {
        let own = profile.roughness();
        profile.rms_mm = Some(own.rms_mm);
        profile.correlation_mm = Some(own.correlation_mm);
        profile.seed = Some(own.seed);
    }
    profile
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symmetries_are_those_of_shape_and_place() {
        let profile = |kind, place_mm, direction_deg| GroundProfile {
            kind,
            radius_mm: 5.0,
            place_mm,
            direction_deg,
            rms_mm: None,
            correlation_mm: None,
            seed: None,
        };
        use ProfileKind::{Cylinder, Edge, Rough, Sphere};
        // Alike before and behind, alike left and right, varies across.
        for (own, expected) in [
            (profile(Sphere, [0.0, 0.0], 90.0), [true, true, true]),
            (profile(Sphere, [1.0, 0.0], 90.0), [false, true, true]),
            (profile(Sphere, [0.0, 1.0], 90.0), [true, false, true]),
            (profile(Cylinder, [0.0, 3.0], 90.0), [true, true, false]),
            (profile(Cylinder, [1.0, 0.0], -90.0), [false, true, false]),
            (profile(Cylinder, [1.0, 0.0], 180.0), [true, true, true]),
            (profile(Cylinder, [0.0, 1.0], 0.0), [true, false, true]),
            (profile(Cylinder, [0.0, 0.0], 30.0), [false, false, true]),
            (profile(Edge, [0.0, 0.0], 270.0), [false, true, false]),
            (profile(Edge, [2.0, 0.0], 0.0), [true, false, true]),
            (profile(Rough, [0.0, 0.0], 0.0), [false, false, true]),
        ] {
            let found = [
                own.is_symmetric(),
                own.is_alike_across(),
                own.varies_across(),
            ];
            assert_eq!(found, expected, "{own:?}");
        }
    }
}
