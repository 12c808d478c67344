//! Shape of the ground beside its stations, the same at every depth: a sphere, a cylinder, an edge or waves.

use std::sync::Arc;

/// Share of the radius from which on a round falls no faster: there it is 64 degrees steep.
const STEEPEST: f64 = 0.9;

/// Height with its first and second derivatives over x and y, mm and 1/mm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Height {
    /// The height.
    pub value: f64,
    /// Derivatives by x and y.
    pub slope: [f64; 2],
    /// Second derivatives: by x twice, by x and y, by y twice.
    pub curvature: [f64; 3],
}

/// Deviations of waves' heights above which their highest crests near the contact are not expected to rise.
const CRESTS: f64 = 3.0;

/// Profile of the ground. The highest points of rounds are at height 0, waves are about it.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Profile {
    /// Plane: the ground is as its stations say.
    #[default]
    Plane,
    /// A sphere.
    Sphere(Round),
    /// A cylinder that lies on it, and falls off to both sides of this unit vector.
    Cylinder(Round, [f64; 2]),
    /// An edge, behind which it falls off along this unit vector; before it, it is plane.
    Edge(Round, [f64; 2]),
    /// A sum of waves.
    Waves(Waves),
}

/// Waves that add up.
#[derive(Debug, Clone, PartialEq)]
pub struct Waves {
    waves: Arc<[Wave]>,
    /// Sum of the amplitudes, mm: no place is higher.
    highest: f64,
    /// Height of the crests that are to be expected near the contact, mm.
    crest: f64,
}

impl Waves {
    /// Adds these up.
    pub fn new(waves: Vec<Wave>) -> Self {
        let variance: f64 = waves.iter().map(|w| 0.5 * w.amplitude * w.amplitude).sum();
        Self {
            highest: waves.iter().map(|wave| wave.amplitude.abs()).sum(),
            crest: CRESTS * variance.sqrt(),
            waves: waves.into(),
        }
    }
}

/// A wave of the ground, a cos(k . x + p).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Amplitude a, mm.
    pub amplitude: f64,
    /// Wave vector k over x and y, rad/mm.
    pub vector: [f64; 2],
    /// Phase p at the origin, rad.
    pub phase: f64,
}

impl Wave {
    /// Adds its height with derivatives at a place, mm.
    fn add_to(&self, height: &mut Height, [x, y]: [f64; 2]) {
        let [kx, ky] = self.vector;
        let (sin, cos) = (kx * x + ky * y + self.phase).sin_cos();
        let [value, slope] = [self.amplitude * cos, -self.amplitude * sin];
        height.value += value;
        height.slope[0] += slope * kx;
        height.slope[1] += slope * ky;
        height.curvature[0] -= value * kx * kx;
        height.curvature[1] -= value * kx * ky;
        height.curvature[2] -= value * ky * ky;
    }
}

/// A round of this radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Round {
    /// Place of its highest point, mm.
    pub centre: [f64; 2],
    /// The radius, mm.
    pub radius: f64,
}

impl Round {
    /// Height and two derivatives at a distance from the highest point, which isn't negative, mm.
    fn fall(&self, distance: f64) -> [f64; 3] {
        let circle = |s: f64| {
            let rise = (self.radius * self.radius - s * s).sqrt();
            let curvature = -self.radius * self.radius / (rise * rise * rise);
            [rise - self.radius, -s / rise, curvature]
        };
        let last = STEEPEST * self.radius;
        if distance < last {
            circle(distance)
        } else {
            let [height, slope, _] = circle(last);
            [height + slope * (distance - last), slope, 0.0]
        }
    }

    /// Height of what varies along a unit vector alone; `one_sided`, against it, it is plane.
    fn ridge(&self, [x, y]: [f64; 2], off: [f64; 2], one_sided: bool) -> Height {
        let aside = (x - self.centre[0]) * off[0] + (y - self.centre[1]) * off[1];
        if one_sided && aside <= 0.0 {
            return Height::default();
        }
        let [value, slope, curvature] = self.fall(aside.abs());
        let slope = slope.copysign(-aside);
        Height {
            value,
            slope: off.map(|o| slope * o),
            curvature: [
                curvature * off[0] * off[0],
                curvature * off[0] * off[1],
                curvature * off[1] * off[1],
            ],
        }
    }

    fn sphere(&self, [x, y]: [f64; 2]) -> Height {
        let from = [x - self.centre[0], y - self.centre[1]];
        let distance = from[0].hypot(from[1]);
        let [value, slope, curvature] = self.fall(distance);
        if distance == 0.0 {
            return Height {
                value,
                slope: [0.0; 2],
                curvature: [curvature, 0.0, curvature],
            };
        }
        let out = from.map(|d| d / distance);
        let around = slope / distance;
        Height {
            value,
            slope: out.map(|o| slope * o),
            curvature: [
                around + (curvature - around) * out[0] * out[0],
                (curvature - around) * out[0] * out[1],
                around + (curvature - around) * out[1] * out[1],
            ],
        }
    }
}

impl Profile {
    /// Height with its derivatives at a place on the ground, mm.
    pub fn at(&self, place: [f64; 2]) -> Height {
        match self {
            Self::Plane => Height::default(),
            Self::Sphere(round) => round.sphere(place),
            Self::Cylinder(round, off) => round.ridge(place, *off, false),
            Self::Edge(round, off) => round.ridge(place, *off, true),
            Self::Waves(waves) => {
                let mut height = Height::default();
                for wave in waves.waves.iter() {
                    wave.add_to(&mut height, place);
                }
                height
            }
        }
    }

    /// Height that no place is above, mm.
    pub fn highest(&self) -> f64 {
        match self {
            Self::Waves(waves) => waves.highest,
            Self::Plane | Self::Sphere(_) | Self::Cylinder(..) | Self::Edge(..) => 0.0,
        }
    }

    /// Height of its highest points, or of the crests that are to be expected of waves, mm.
    pub(crate) fn crest(&self) -> f64 {
        match self {
            Self::Waves(waves) => waves.crest,
            _ => self.highest(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROUND: Round = Round {
        centre: [0.5, -0.25],
        radius: 3.0,
    };

    fn waves() -> Profile {
        let wave = |amplitude, vector, phase| Wave {
            amplitude,
            vector,
            phase,
        };
        Profile::Waves(Waves::new(vec![
            wave(0.3, [0.6, -0.8], 0.4),
            wave(-0.4, [1.1, 0.3], -2.0),
        ]))
    }

    fn all() -> [Profile; 6] {
        [
            Profile::Sphere(ROUND),
            Profile::Cylinder(ROUND, [0.0, 1.0]),
            Profile::Cylinder(ROUND, [-0.6, 0.8]),
            Profile::Edge(ROUND, [-0.6, 0.8]),
            Profile::Edge(ROUND, [0.28, -0.96]),
            waves(),
        ]
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let h = 1e-4;
        for profile in all() {
            for k in 0..400 {
                let place = [0.037 * f64::from(k) - 7.4, 0.9 * f64::from(k % 17) - 7.1];
                let at = profile.at(place);
                let moved = |axis: usize, by: f64| {
                    let mut place = place;
                    place[axis] += by;
                    profile.at(place)
                };
                for axis in 0..2 {
                    let [low, high] = [-h, h].map(|by| moved(axis, by));
                    // Third derivatives are below 3 / radius^2 / (1 - 0.81)^2.5 = 21 where nothing bends anew.
                    let slope = (high.value - low.value) / (2.0 * h);
                    assert!(
                        (slope - at.slope[axis]).abs() < 2e-4,
                        "{profile:?} {place:?}"
                    );
                    let bends = (high.curvature[0] - low.curvature[0]).abs() > 0.05
                        || (high.curvature[2] - low.curvature[2]).abs() > 0.05;
                    for other in 0..2 {
                        let curvature = (high.slope[other] - low.slope[other]) / (2.0 * h);
                        let expected = at.curvature[axis + other];
                        assert!(
                            bends || (curvature - expected).abs() < 1e-5,
                            "{profile:?} {place:?} {curvature} {expected}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn heights_are_those_of_the_circle_and_then_of_its_tangent() {
        let [x, y] = ROUND.centre;
        let sphere = Profile::Sphere(ROUND);
        assert_eq!(sphere.at([x, y]).value, 0.0);
        assert!((sphere.at([x, y]).curvature[0] + 1.0 / 3.0).abs() < 1e-15);
        // 1.8 of 3 mm: 2.4 mm above the middle.
        assert!((sphere.at([x + 1.8, y]).value + 0.6).abs() < 1e-14);
        // Beyond nine tenths it goes on as steep as it is there.
        let [a, b, c] = [4.0, 5.0, 6.0].map(|s| sphere.at([x, y - s]).value);
        let steep = -0.9 / 0.19f64.sqrt();
        assert!((b - a - steep).abs() < 1e-12 && (c - b - steep).abs() < 1e-12);
        // A cylinder along x is as high everywhere along it, and falls to both sides; an edge to one alone.
        let off = [0.0, 1.0];
        let [cylinder, edge] = [Profile::Cylinder(ROUND, off), Profile::Edge(ROUND, off)];
        for along in [-9.0, 0.0, 4.0] {
            assert!((cylinder.at([along, y + 1.8]).value + 0.6).abs() < 1e-14);
            assert!((cylinder.at([along, y - 1.8]).value + 0.6).abs() < 1e-14);
            assert!((edge.at([along, y + 1.8]).value + 0.6).abs() < 1e-14);
            assert_eq!(edge.at([along, y - 1.8]), Height::default());
        }
    }

    #[test]
    fn waves_add_up_and_their_crests_are_three_deviations_high() {
        let at = waves().at([0.0; 2]).value;
        assert!((at - (0.3 * 0.4f64.cos() - 0.4 * 2.0f64.cos())).abs() < 1e-15);
        // Half of 0.09 and 0.16 is the variance.
        assert!((waves().crest() - 3.0 * 0.125f64.sqrt()).abs() < 1e-15);
        assert!((waves().highest() - 0.7).abs() < 1e-15);
        assert_eq!(Profile::Sphere(ROUND).crest(), 0.0);
    }
}
