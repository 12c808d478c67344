//! Stretches: of a surface at a point, and the extremes in a body.

use crate::tensor::{Tensor, multiply, symmetric_eigen, transpose};

/// Stretches along the chart's lines at a point, and the cosine-like product of the two current tangents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Stretch along s1.
    pub s1: f64,
    /// Stretch along s2.
    pub s2: f64,
    /// Off-diagonal component of the right Cauchy-Green tensor: stretches times the cosine of the current angle.
    pub shear: f64,
}

impl Stretch {
    /// Stretch of the material line at this angle (rad) to s1 in the reference state.
    pub fn along(&self, angle: f64) -> f64 {
        self.squared_along(angle).sqrt()
    }

    /// Green-Lagrange strain (lambda^2 - 1) / 2 of that line.
    pub fn green_lagrange_along(&self, angle: f64) -> f64 {
        0.5 * (self.squared_along(angle) - 1.0)
    }

    fn squared_along(&self, angle: f64) -> f64 {
        let (sin, cos) = angle.sin_cos();
        let (a, b) = (cos * self.s1, sin * self.s2);
        (a * a + b * b + 2.0 * cos * sin * self.shear).max(0.0)
    }

    /// Principal stretches within the surface, larger first.
    pub fn principal(&self) -> (f64, f64) {
        let (a, b) = (self.s1 * self.s1, self.s2 * self.s2);
        let (mean, half) = (0.5 * (a + b), 0.5 * (a - b));
        let radius = half.hypot(self.shear);
        ((mean + radius).sqrt(), (mean - radius).max(0.0).sqrt())
    }
}

/// Extremes of the principal stretches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StretchRange {
    /// Smallest principal stretch: below 1 under compression.
    pub smallest: f64,
    /// Largest principal stretch.
    pub largest: f64,
}

impl StretchRange {
    /// Stretches of a body at rest.
    pub(crate) const UNDEFORMED: Self = Self {
        smallest: 1.0,
        largest: 1.0,
    };

    /// Returns the stretches of a deformation gradient: roots of the extreme eigenvalues of F^T F.
    pub fn of(deformation_gradient: &Tensor) -> Self {
        let f = deformation_gradient;
        let (squares, _) = symmetric_eigen(&multiply(&transpose(f), f));
        let stretches = squares.map(|square| square.max(0.0).sqrt());
        Self {
            smallest: stretches.into_iter().fold(f64::INFINITY, f64::min),
            largest: stretches.into_iter().fold(0.0, f64::max),
        }
    }

    /// The range of both.
    pub fn with(self, other: Self) -> Self {
        Self {
            smallest: self.smallest.min(other.smallest),
            largest: self.largest.max(other.largest),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x = (X + g Y, Y): the line at angle t becomes (cos t + g sin t, sin t).
    #[test]
    fn any_line_of_a_sheared_sheet_has_its_stretch() {
        let g: f64 = 0.4;
        let stretch = Stretch {
            s1: 1.0,
            s2: (1.0 + g * g).sqrt(),
            shear: g,
        };
        for angle in [0.0, 0.3, 0.5 * std::f64::consts::PI, 2.2, -1.0] {
            let (sin, cos) = f64::sin_cos(angle);
            let exact = (cos + g * sin).hypot(sin);
            assert!((stretch.along(angle) - exact).abs() < 1e-15, "{angle}");
            let green_lagrange = 0.5 * (exact * exact - 1.0);
            assert!((stretch.green_lagrange_along(angle) - green_lagrange).abs() < 1e-15);
        }
    }

    #[test]
    fn principal_stretches_of_a_sheared_sheet() {
        // Simple shear by g: C = [[1, g], [g, 1 + g^2]], principal stretches l and 1 / l, l - 1 / l = g.
        let g: f64 = 0.4;
        let stretch = Stretch {
            s1: 1.0,
            s2: (1.0 + g * g).sqrt(),
            shear: g,
        };
        let (l1, l2) = stretch.principal();
        assert!((l1 * l2 - 1.0).abs() < 1e-15 && (l1 - l2 - g).abs() < 1e-15);
    }

    #[test]
    fn a_turned_body_has_the_stretches_of_the_one_at_rest() {
        // diag(2, 0.5, 1) after a turn by 30 degrees about the third axis
        let (sin, cos) = (0.5, 0.75_f64.sqrt());
        let f = [
            [2.0 * cos, -0.5 * sin, 0.0],
            [2.0 * sin, 0.5 * cos, 0.0],
            [0.0, 0.0, 1.0],
        ];
        let range = StretchRange::of(&f).with(StretchRange::UNDEFORMED);
        assert!((range.largest - 2.0).abs() < 1e-15 && (range.smallest - 0.5).abs() < 1e-15);
    }
}
