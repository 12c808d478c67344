//! A thin isotropic film in plane stress: St. Venant-Kirchhoff,
//! W = h E / (2 (1 - nu^2)) (E11^2 + E22^2 + 2 nu E11 E22 + 2 (1 - nu) E12^2).
//!
//! A stiff polymer film such as PVDF strains by a few percent at most before it yields. There all hyperelastic laws with
//! the same two constants agree to first order in the strain, and this is the simplest of them that is free of stress
//! under any rotation; its tangent is constant.

use super::elastic_layer::{InPlane, SurfaceLaw};

/// Elasticity and thickness of a film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Film {
    /// Young's modulus, MPa.
    pub modulus: f64,
    /// Poisson's ratio, above -1 and up to 0.5.
    pub poisson_ratio: f64,
    /// Thickness, mm.
    pub thickness: f64,
}

impl Film {
    fn moduli(&self) -> [InPlane; 3] {
        let nu = self.poisson_ratio;
        let k = self.modulus * self.thickness / (1.0 - nu * nu);
        [
            [k, nu * k, 0.0],
            [nu * k, k, 0.0],
            [0.0, 0.0, 0.5 * (1.0 - nu) * k],
        ]
    }
}

impl SurfaceLaw for Film {
    fn energy(&self, strain: &InPlane) -> f64 {
        let (tensions, _) = self.tensions(strain);
        0.5 * (0..3).map(|v| tensions[v] * strain[v]).sum::<f64>()
    }

    fn tensions(&self, strain: &InPlane) -> (InPlane, [InPlane; 3]) {
        let moduli = self.moduli();
        let tensions = moduli.map(|row| (0..3).map(|v| row[v] * strain[v]).sum());
        (tensions, moduli)
    }

    fn stiffness(&self) -> f64 {
        self.moduli()[0][0]
    }
}
