//! Neo-Hookean: W = C10 (I1 - 3) in the isochoric invariant I1 = J^(-2/3) F:F.

use super::first_invariant::FirstInvariant;
use super::isochoric::{Isochoric, von_mises_of_principal};
use crate::tensor::{Tensor, Tensor4};

/// The constant, MPa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NeoHookean {
    /// Half of the shear modulus, MPa.
    pub c10: f64,
}

impl Isochoric for NeoHookean {
    fn energy(&self, deformation_gradient: &Tensor) -> f64 {
        self.c10 * FirstInvariant::new(deformation_gradient).excess
    }

    fn stress(&self, deformation_gradient: &Tensor) -> Tensor {
        FirstInvariant::new(deformation_gradient).stress(self.c10)
    }

    fn stress_and_tangent(&self, deformation_gradient: &Tensor) -> (Tensor, Tensor4) {
        let i1 = FirstInvariant::new(deformation_gradient);
        let tangent = i1.tangent(deformation_gradient, self.c10, 0.0);
        (i1.stress(self.c10), tangent)
    }

    fn shear_modulus(&self) -> f64 {
        2.0 * self.c10
    }

    fn von_mises(&self, stretches: [f64; 3]) -> f64 {
        // Cauchy stress up to a pressure: 2 C10 l_i^2.
        von_mises_of_principal(stretches.map(|l| 2.0 * self.c10 * l * l))
    }
}
