//! The rigid ground: a height field z_g(x) of stations, constant across its own y axis, and a profile on it; it may lean about the x axis, and may be dragged as a
//! whole.

use crate::load::ground_shape::{Height, Profile};
use crate::tensor::Vector;

/// Axes of ground below a body that is turned about the x axis: those of the body, turned back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundAxes {
    /// Angle by which the body is turned, right-handed about x, rad.
    pub angle: f64,
    sin: f64,
    cos: f64,
}

impl GroundAxes {
    /// Axes of level ground.
    pub const LEVEL: Self = Self {
        angle: 0.0,
        sin: 0.0,
        cos: 1.0,
    };

    /// Axes below a body that is turned by an angle, rad.
    pub fn below(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { angle, sin, cos }
    }

    /// Returns the unit vectors along the ground's x, y and z axis.
    pub fn vectors(&self) -> [Vector; 3] {
        [
            [1.0, 0.0, 0.0],
            [0.0, self.cos, -self.sin],
            [0.0, self.sin, self.cos],
        ]
    }

    /// Returns the coordinates of a body's point in these axes.
    pub fn coordinates(&self, [x, y, z]: Vector) -> Vector {
        [x, self.cos * y - self.sin * z, self.sin * y + self.cos * z]
    }

    /// Returns a vector of these axes in those of the body.
    pub fn to_body(&self, [x, y, z]: Vector) -> Vector {
        [x, self.cos * y + self.sin * z, self.cos * z - self.sin * y]
    }
}

/// Shape of the stations' influence; both families sum to one everywhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StationFunctions {
    /// Uniform cubic B-splines: twice continuously differentiable.
    BSpline,
    /// Piecewise linear.
    Hat,
}

impl StationFunctions {
    /// Value and first two derivatives of the function centred at 0 with unit spacing; from the right at a kink.
    fn evaluate(self, x: f64) -> [f64; 3] {
        let (a, sign) = (x.abs(), if x < 0.0 { -1.0 } else { 1.0 });
        match self {
            Self::Hat if (-1.0..1.0).contains(&x) => [1.0 - a, -sign, 0.0],
            Self::BSpline if a < 1.0 => [
                2.0 / 3.0 - a * a + 0.5 * a * a * a,
                sign * (1.5 * a * a - 2.0 * a),
                3.0 * a - 2.0,
            ],
            Self::BSpline if a < 2.0 => {
                let b = 2.0 - a;
                [b * b * b / 6.0, -sign * 0.5 * b * b, b]
            }
            _ => [0.0; 3],
        }
    }

    /// Half of the support's width in spacings.
    fn reach(self) -> i64 {
        match self {
            Self::Hat => 1,
            Self::BSpline => 2,
        }
    }
}

/// Ground whose height is interpolated from stations along x. The body lies above it; a positive depth raises it.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightField {
    /// Axes of the ground; heights are along their z axis.
    pub axes: GroundAxes,
    /// Height of the ground at zero depth, mm.
    pub base: f64,
    /// Distance of neighbouring stations, mm; the middle one sits at x = 0 of the ground that isn't dragged.
    pub spacing: f64,
    /// Shape functions.
    pub functions: StationFunctions,
    /// Depth of each station, mm. The functions of stations beyond the ends belong to the ends.
    pub depths: Vec<f64>,
    /// Ways by which the ground is dragged along its x and y axis, mm; stations and friction's anchors go with it.
    pub shift: [f64; 2],
    /// Profile that it has beside its stations.
    pub profile: Profile,
}

impl HeightField {
    /// Gap between a body's point and the ground, along the ground's z axis, mm: negative below the ground.
    pub fn gap(&self, position: Vector) -> f64 {
        let [x, y, z] = self.axes.coordinates(position);
        z - self.height(x, y).value
    }

    /// Height with its derivatives below or above a point in the ground's coordinates, mm; none where the point is above all that the profile may rise to there:
    /// waves aren't added up for it.
    pub fn near(&self, [x, y, z]: Vector) -> Option<Height> {
        let stations = self.of_stations(x);
        let is_near = z <= stations[0] + self.profile.highest();
        is_near.then(|| self.on(stations, [x, y]))
    }

    /// Depth that the stations give at the contact's centre, mm.
    pub fn depth(&self) -> f64 {
        self.of_stations(0.0)[0] - self.base
    }

    /// Height with its derivatives at x and y, mm.
    pub fn height(&self, x: f64, y: f64) -> Height {
        self.on(self.of_stations(x), [x, y])
    }

    /// Height with its derivatives at x and y, mm, where the stations give these.
    fn on(&self, [value, slope, curvature]: [f64; 3], [x, y]: [f64; 2]) -> Height {
        let profile = self.profile.at([x - self.shift[0], y - self.shift[1]]);
        Height {
            value: value + profile.value,
            slope: [slope + profile.slope[0], profile.slope[1]],
            curvature: [
                curvature + profile.curvature[0],
                profile.curvature[1],
                profile.curvature[2],
            ],
        }
    }

    /// Height (mm), slope and curvature (1/mm) that the stations give at x (mm).
    fn of_stations(&self, x: f64) -> [f64; 3] {
        let centre = (self.depths.len() as f64 - 1.0) / 2.0;
        // Far outside all functions belong to an end station; clamping keeps the index small for any finite x.
        let limit = self.depths.len() as f64 + 4.0;
        let station = ((x - self.shift[0]) / self.spacing + centre).clamp(-limit, limit);
        let nearest = station.floor() as i64;
        let mut height = [self.base, 0.0, 0.0];
        for k in nearest - self.functions.reach() + 1..=nearest + self.functions.reach() {
            let depth = self.depths[k.clamp(0, self.depths.len() as i64 - 1) as usize];
            let [value, slope, curvature] = self.functions.evaluate(station - k as f64);
            height[0] += depth * value;
            height[1] += depth * slope / self.spacing;
            height[2] += depth * curvature / (self.spacing * self.spacing);
        }
        height
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::ground_shape::Round;

    fn field(functions: StationFunctions, depths: &[f64]) -> HeightField {
        HeightField {
            axes: GroundAxes::LEVEL,
            base: -50.0,
            spacing: 5.5,
            functions,
            depths: depths.to_vec(),
            shift: [0.0; 2],
            profile: Profile::Plane,
        }
    }

    #[test]
    fn equal_depths_are_a_flat_plate_everywhere() {
        for functions in [StationFunctions::BSpline, StationFunctions::Hat] {
            let ground = field(functions, &[1.25; 5]);
            for i in -400..=400 {
                let [height, slope, curvature] = ground.of_stations(f64::from(i) * 0.31);
                // Four terms of size depth (1.25) times values up to 2, each rounded: below 1e-14, and 50 eps for the base.
                assert!((height + 48.75).abs() < 2e-14, "height {height} at {i}");
                assert!(
                    slope.abs() < 1e-14 && curvature.abs() < 1e-14,
                    "slope {slope} curvature {curvature} at {i}"
                );
            }
        }
    }

    #[test]
    fn hats_interpolate_and_ends_go_on() {
        let ground = field(StationFunctions::Hat, &[1.0, 2.0, 3.0, 4.0, 5.0]);
        for (k, depth) in [1.0, 2.0, 3.0, 4.0, 5.0].into_iter().enumerate() {
            assert!((ground.of_stations(5.5 * (k as f64 - 2.0))[0] - (depth - 50.0)).abs() < 1e-14);
        }
        assert_eq!(ground.of_stations(-1e9)[0], -49.0);
        assert_eq!(ground.of_stations(1e9)[0], -45.0);
    }

    #[test]
    fn a_dragged_ground_has_the_height_that_it_had_where_it_was() {
        let resting = field(StationFunctions::BSpline, &[0.3, 1.9, 0.7, 1.1, 0.2]);
        let dragged = HeightField {
            shift: [0.5, -2.0],
            ..resting.clone()
        };
        for i in -20..=20 {
            // Eighths, so that the shift is taken off without rounding.
            let x = f64::from(i) * 0.625;
            assert_eq!(dragged.of_stations(x + 0.5), resting.of_stations(x));
        }
    }

    #[test]
    fn a_profile_stands_on_the_stations_and_goes_with_the_ground() {
        let round = Round {
            centre: [1.0, 2.0],
            radius: 4.0,
        };
        let ground = HeightField {
            shift: [0.5, -0.25],
            profile: Profile::Sphere(round),
            ..field(StationFunctions::BSpline, &[0.3, 1.9, 0.7, 1.1, 0.2])
        };
        let top = ground.height(1.5, 1.75);
        let [value, slope, curvature] = ground.of_stations(1.5);
        assert_eq!((top.value, top.slope), (value, [slope, 0.0]));
        assert_eq!(top.curvature, [curvature - 0.25, 0.0, -0.25]);
        assert_eq!(ground.gap([1.5, 1.75, value + 0.5]), 0.5);
    }

    #[test]
    fn level_axes_are_the_bodys_to_the_bit() {
        for angle in [0.0, -0.0] {
            let axes = GroundAxes::below(angle);
            for point in [[0.1, -0.7, -49.3], [-3.0, 1e-9, 1e9]] {
                assert_eq!(
                    (axes.coordinates(point), axes.to_body(point)),
                    (point, point)
                );
            }
        }
    }

    #[test]
    fn ground_leans_the_other_way_than_the_body() {
        // A body whose top leans to -y: the ground is nearer to it there.
        let axes = GroundAxes::below(0.3);
        let [_, _, up] = axes.vectors();
        assert!(up[1] > 0.0 && (up[1] - 0.3f64.sin()).abs() < 1e-15);
        let ground = HeightField {
            axes,
            ..field(StationFunctions::BSpline, &[0.0])
        };
        assert!(ground.gap([0.0, -10.0, -45.0]) < ground.gap([0.0, 10.0, -45.0]));
        let point = [0.3, -1.7, 2.9];
        let back = axes.to_body(axes.coordinates(point));
        for i in 0..3 {
            assert!((back[i] - point[i]).abs() < 1e-15);
        }
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let ground = field(StationFunctions::BSpline, &[0.3, 1.9, 0.7, 1.1, 0.2]);
        let h = 1e-4;
        for i in -20..=20 {
            let x = f64::from(i) * 0.83 + 0.1;
            let [_, slope, curvature] = ground.of_stations(x);
            let (plus, minus) = (ground.of_stations(x + h), ground.of_stations(x - h));
            // Round-off 50 eps / h = 1e-10, truncation h^2 z''' = 1e-9.
            assert!(((plus[0] - minus[0]) / (2.0 * h) - slope).abs() < 1e-8);
            assert!(((plus[1] - minus[1]) / (2.0 * h) - curvature).abs() < 1e-4 * 0.5);
        }
    }
}
