//! Yeoh: W = C10 (I1 - 3) + C20 (I1 - 3)^2 + C30 (I1 - 3)^3 in the isochoric invariant I1 = J^(-2/3) F:F
//! (O. H. Yeoh, Rubber Chem. Technol. 66 (1993) 754).

use super::first_invariant::FirstInvariant;
use super::isochoric::{Isochoric, von_mises_of_principal};
use crate::tensor::{Tensor, Tensor4};

/// The three constants, MPa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Yeoh {
    /// Half of the initial shear modulus, MPa.
    pub c10: f64,
    /// Weight of the square, MPa; negative where the rubber softens at moderate stretch.
    pub c20: f64,
    /// Weight of the cube, MPa; positive where it stiffens at large stretch.
    pub c30: f64,
}

impl Yeoh {
    /// dW/dI1 at I1 - 3 = x.
    fn slope(&self, x: f64) -> f64 {
        self.c10 + x * (2.0 * self.c20 + x * 3.0 * self.c30)
    }

    /// d2W/dI1^2 at I1 - 3 = x.
    fn curvature(&self, x: f64) -> f64 {
        2.0 * self.c20 + x * 6.0 * self.c30
    }
}

impl Isochoric for Yeoh {
    fn energy(&self, deformation_gradient: &Tensor) -> f64 {
        let x = FirstInvariant::new(deformation_gradient).excess;
        x * (self.c10 + x * (self.c20 + x * self.c30))
    }

    fn stress(&self, deformation_gradient: &Tensor) -> Tensor {
        let i1 = FirstInvariant::new(deformation_gradient);
        i1.stress(self.slope(i1.excess))
    }

    fn stress_and_tangent(&self, deformation_gradient: &Tensor) -> (Tensor, Tensor4) {
        let i1 = FirstInvariant::new(deformation_gradient);
        let (slope, curvature) = (self.slope(i1.excess), self.curvature(i1.excess));
        let tangent = i1.tangent(deformation_gradient, slope, curvature);
        (i1.stress(slope), tangent)
    }

    fn shear_modulus(&self) -> f64 {
        2.0 * self.c10
    }

    fn von_mises(&self, stretches: [f64; 3]) -> f64 {
        // Cauchy stress up to a pressure: 2 W'(I1) l_i^2.
        let squares = stretches.map(|l| l * l);
        let slope = self.slope(squares.iter().sum::<f64>() - 3.0);
        von_mises_of_principal(squares.map(|s| 2.0 * slope * s))
    }
}
