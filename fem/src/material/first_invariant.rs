//! The isochoric first invariant I1 = J^(-2/3) F:F with its derivatives, which the laws W(I1) share.
//!
//! With G = dJ/dF:
//!
//! > dI1/dF = 2 J^(-2/3) F - (2/3) (I1 / J) G,
//! > d2I1/dF2 = 2 J^(-2/3) 1 - (4/3) J^(-5/3) (F x G + G x F) + (10/9) (I1 / J^2) G x G - (2/3) (I1 / J) dG/dF.

use crate::tensor::{Tensor, Tensor4, cofactor, cofactor_derivative, determinant};

/// I1 at one deformation.
pub(super) struct FirstInvariant {
    /// I1 - 3; zero in the reference state.
    pub excess: f64,
    /// dI1/dF.
    gradient: Tensor,
    cofactor: Tensor,
    j: f64,
    /// J^(-2/3).
    scale: f64,
}

impl FirstInvariant {
    pub(super) fn new(f: &Tensor) -> Self {
        let (cofactor, j) = (cofactor(f), determinant(f));
        let scale = j.powf(-2.0 / 3.0);
        let i1 = scale * f.iter().flatten().map(|c| c * c).sum::<f64>();
        let volumetric = -2.0 / 3.0 * i1 / j;
        let gradient = [0, 1, 2]
            .map(|i| [0, 1, 2].map(|k| 2.0 * scale * f[i][k] + volumetric * cofactor[i][k]));
        Self {
            excess: i1 - 3.0,
            gradient,
            cofactor,
            j,
            scale,
        }
    }

    /// First Piola-Kirchhoff stress of a law with the slope dW/dI1, MPa.
    pub(super) fn stress(&self, slope: f64) -> Tensor {
        self.gradient.map(|row| row.map(|g| slope * g))
    }

    /// Tangent of a law with the slope dW/dI1 and the curvature d2W/dI1^2, MPa.
    pub(super) fn tangent(&self, f: &Tensor, slope: f64, curvature: f64) -> Tensor4 {
        let i1 = self.excess + 3.0;
        let volumetric = -2.0 / 3.0 * slope * i1 / self.j;
        let mixed = -4.0 / 3.0 * slope * self.scale / self.j;
        let square = 10.0 / 9.0 * slope * i1 / (self.j * self.j);
        let flat = |t: &Tensor| -> [f64; 9] { std::array::from_fn(|c| t[c / 3][c % 3]) };
        let mut tangent = cofactor_derivative(f);
        let (f, g, d) = (flat(f), flat(&self.cofactor), flat(&self.gradient));
        for (r, row) in tangent.iter_mut().enumerate() {
            for (c, value) in row.iter_mut().enumerate() {
                *value = volumetric * *value
                    + mixed * (f[r] * g[c] + g[r] * f[c])
                    + square * g[r] * g[c]
                    + curvature * d[r] * d[c];
            }
            row[r] += 2.0 * slope * self.scale;
        }
        tangent
    }
}
