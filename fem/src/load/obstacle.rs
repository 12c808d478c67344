//! The rigid ground: a height field z_g(x) that is constant across the wheel, and may be dragged sideways as a whole.

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
    /// Height of the ground at zero depth, mm.
    pub base: f64,
    /// Distance of neighbouring stations, mm; the middle one sits at x = 0 of the ground that isn't dragged.
    pub spacing: f64,
    /// Shape functions.
    pub functions: StationFunctions,
    /// Depth of each station, mm. The functions of stations beyond the ends belong to the ends.
    pub depths: Vec<f64>,
    /// Ways by which the ground is dragged along x and y, mm; stations and friction's anchors go with it.
    pub shift: [f64; 2],
}

impl HeightField {
    /// Height (mm), slope and curvature (1/mm) at x (mm).
    pub fn height(&self, x: f64) -> [f64; 3] {
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

    fn field(functions: StationFunctions, depths: &[f64]) -> HeightField {
        HeightField {
            base: -50.0,
            spacing: 5.5,
            functions,
            depths: depths.to_vec(),
            shift: [0.0; 2],
        }
    }

    #[test]
    fn equal_depths_are_a_flat_plate_everywhere() {
        for functions in [StationFunctions::BSpline, StationFunctions::Hat] {
            let ground = field(functions, &[1.25; 5]);
            for i in -400..=400 {
                let [height, slope, curvature] = ground.height(f64::from(i) * 0.31);
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
            assert!((ground.height(5.5 * (k as f64 - 2.0))[0] - (depth - 50.0)).abs() < 1e-14);
        }
        assert_eq!(ground.height(-1e9)[0], -49.0);
        assert_eq!(ground.height(1e9)[0], -45.0);
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
            assert_eq!(dragged.height(x + 0.5), resting.height(x));
        }
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let ground = field(StationFunctions::BSpline, &[0.3, 1.9, 0.7, 1.1, 0.2]);
        let h = 1e-4;
        for i in -20..=20 {
            let x = f64::from(i) * 0.83 + 0.1;
            let [_, slope, curvature] = ground.height(x);
            let (plus, minus) = (ground.height(x + h), ground.height(x - h));
            // Round-off 50 eps / h = 1e-10, truncation h^2 z''' = 1e-9.
            assert!(((plus[0] - minus[0]) / (2.0 * h) - slope).abs() < 1e-8);
            assert!(((plus[1] - minus[1]) / (2.0 * h) - curvature).abs() < 1e-4 * 0.5);
        }
    }
}
