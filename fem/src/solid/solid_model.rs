//! Law and compressibility of the solid.

use crate::material::Isochoric;

/// Ratio of the step's bulk modulus to the shear modulus for (nearly) incompressible solids. A Newton step then leaves
/// about its inverse of the volume error behind, while the matrix loses no more than five digits.
const STEP_BULK_RATIO: f64 = 1e5;

/// Law and compressibility of the solid.
#[derive(Debug)]
pub struct SolidModel {
    /// Isochoric law.
    pub material: Box<dyn Isochoric>,
    /// Bulk compliance 1/kappa, 1/MPa; 0 is exactly incompressible.
    pub compliance: f64,
}

impl SolidModel {
    /// Compliance used in the Newton step, 1/MPa.
    pub(crate) fn step_compliance(&self) -> f64 {
        self.compliance
            .max(1.0 / (STEP_BULK_RATIO * self.material.shear_modulus()))
    }
}
