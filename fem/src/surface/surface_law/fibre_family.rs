//! A family of parallel fibres: W = k (lambda - 1)^2 / 2 per reference area, with the fibre's stretch lambda and the stiffness k in tension, a
//! fraction of it in compression, because cords buckle. The tension is continuous and zero in the reference state; its slope jumps there.

use super::elastic_layer::{InPlane, SurfaceLaw};

/// Direction and stiffness of a fibre family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FibreFamily {
    /// Angle from the first axis to the fibres in the reference state, rad.
    pub angle: f64,
    /// Stiffness in tension, N/mm.
    pub stiffness: f64,
    /// Stiffness in compression over that in tension, 0 to 1.
    pub compression_ratio: f64,
}

impl FibreFamily {
    /// Derivatives of the strain along the fibre by E11, E22, 2 E12.
    fn projection(&self) -> InPlane {
        let (sin, cos) = self.angle.sin_cos();
        [cos * cos, sin * sin, cos * sin]
    }

    /// Stretch of the fibres in a surface with this strain.
    pub fn stretch(&self, strain: &InPlane) -> f64 {
        1.0 + self.extension(strain)
    }

    /// lambda - 1 from lambda^2 = 1 + 2 e without cancellation.
    fn extension(&self, strain: &InPlane) -> f64 {
        let m = self.projection();
        let e = m[0] * strain[0] + m[1] * strain[1] + m[2] * strain[2];
        2.0 * e / (1.0 + (1.0 + 2.0 * e).sqrt())
    }

    fn slope(&self, extension: f64) -> f64 {
        if extension >= 0.0 {
            self.stiffness
        } else {
            self.stiffness * self.compression_ratio
        }
    }

    /// Tension along the fibres in a surface with this strain: force per reference length across the family, N/mm.
    pub fn tension(&self, strain: &InPlane) -> f64 {
        let extension = self.extension(strain);
        self.slope(extension) * extension
    }
}

impl SurfaceLaw for FibreFamily {
    fn energy(&self, strain: &InPlane) -> f64 {
        let extension = self.extension(strain);
        0.5 * self.slope(extension) * extension * extension
    }

    fn tensions(&self, strain: &InPlane) -> (InPlane, [InPlane; 3]) {
        let (m, extension) = (self.projection(), self.extension(strain));
        let (stretch, slope) = (1.0 + extension, self.slope(extension));
        // dW/de = T / lambda, because d lambda / de = 1 / lambda.
        let along = slope * extension / stretch;
        let modulus = (slope - along) / (stretch * stretch);
        (
            m.map(|m| along * m),
            m.map(|row| m.map(|column| modulus * (row * column))),
        )
    }

    fn stiffness(&self) -> f64 {
        self.stiffness
    }
}
