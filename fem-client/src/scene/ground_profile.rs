//! Profile of the ground: a sphere on it, a cylinder that lies there, or an edge.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fields::Range;
use document::typed::lists::Each;
use document::{Choice, Table};

use super::shared_ranges::LENGTH;

const PLACE: Range = Range::new(-LENGTH.high, LENGTH.high, "mm");
const ANGLE: Range = Range::new(-360.0, 360.0, "degrees");
/// Radius of a profile of which nothing is said, mm.
const USUAL_RADIUS: f64 = 10.0;
/// Direction across the wheel, degrees.
const ACROSS: f64 = 90.0;

/// Profile of the ground: its highest points are as high as the stations' ground.
#[derive(Debug, Clone, PartialEq, Table)]
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
    /// Direction of a cylinder's axis or an edge, degrees from the rolling direction; 90 is across the wheel. An edge falls off to the left of it; a sphere has none.
    #[field(default = ACROSS, within = ANGLE)]
    pub direction_deg: f64,
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
}

impl GroundProfile {
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
        self.kind == ProfileKind::Sphere || across != 0.0
    }

    /// Whether it is its own image where the first coordinate of these, its place and the vector to its left, changes its sign.
    fn is_even(&self, [place, _]: [f64; 2], [left, other]: [f64; 2]) -> bool {
        match self.kind {
            ProfileKind::Sphere => place == 0.0,
            ProfileKind::Cylinder => left == 0.0 || (other == 0.0 && place == 0.0),
            ProfileKind::Edge => left == 0.0,
        }
    }
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
        };
        use ProfileKind::{Cylinder, Edge, Sphere};
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
