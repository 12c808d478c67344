//! Contract of the isochoric laws.

use crate::tensor::{Tensor, Tensor4};

/// An isochoric stored energy: W(F) = W(J^(-1/3) F), zero with zero stress at F = 1.
pub trait Isochoric: std::fmt::Debug + Send + Sync {
    /// Stored energy per reference volume, MPa.
    fn energy(&self, deformation_gradient: &Tensor) -> f64;

    /// First Piola-Kirchhoff stress dW/dF, MPa.
    fn stress(&self, deformation_gradient: &Tensor) -> Tensor;

    /// Stress and tangent d2W/dF2, MPa.
    fn stress_and_tangent(&self, deformation_gradient: &Tensor) -> (Tensor, Tensor4);

    /// Shear modulus in the reference state, MPa.
    fn shear_modulus(&self) -> f64;

    /// Von Mises stress of a volume-preserving deformation with these principal stretches, MPa.
    fn von_mises(&self, stretches: [f64; 3]) -> f64;
}

/// Von Mises stress from principal Cauchy stresses, MPa, which may all be off by one pressure.
pub(super) fn von_mises_of_principal(s: [f64; 3]) -> f64 {
    (0.5 * ((s[0] - s[1]).powi(2) + (s[1] - s[2]).powi(2) + (s[2] - s[0]).powi(2))).sqrt()
}
