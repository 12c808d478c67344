//! Mooney-Rivlin: W = C10 (I1 - 3) + C01 (I2 - 3) in the isochoric invariants
//! I1 = J^(-2/3) F:F and I2 = J^(-4/3) ((F:F)^2 - C:C) / 2, C = F^T F.

use super::isochoric::{Isochoric, von_mises_of_principal};
use crate::tensor::{
    Tensor, Tensor4, cofactor, cofactor_derivative, determinant, multiply, transpose,
};

/// The two constants, MPa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MooneyRivlin {
    /// Weight of the first invariant, MPa.
    pub c10: f64,
    /// Weight of the second invariant, MPa.
    pub c01: f64,
}

/// Invariants of F without the volumetric scaling, and what their derivatives need.
struct Kinematics {
    cofactor: Tensor,
    right_cauchy_green: Tensor,
    j: f64,
    i1: f64,
    i2: f64,
}

impl Kinematics {
    fn new(f: &Tensor) -> Self {
        let c = multiply(&transpose(f), f);
        let i1 = c[0][0] + c[1][1] + c[2][2];
        // I2 is the squared norm of the cofactor: no cancellation near a large stretch.
        let cofactor = cofactor(f);
        let i2 = cofactor.iter().flatten().map(|g| g * g).sum();
        Self {
            cofactor,
            right_cauchy_green: c,
            j: determinant(f),
            i1,
            i2,
        }
    }

    /// Derivatives of I1 and I2 by F: 2 F and 2 (I1 F - F C).
    fn gradients(&self, f: &Tensor) -> (Tensor, Tensor) {
        let fc = multiply(f, &self.right_cauchy_green);
        let (mut d1, mut d2) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
        for i in 0..3 {
            for j in 0..3 {
                d1[i][j] = 2.0 * f[i][j];
                d2[i][j] = 2.0 * (self.i1 * f[i][j] - fc[i][j]);
            }
        }
        (d1, d2)
    }
}

/// First derivatives of the energy, which stress and tangent share.
struct Slopes {
    /// Factors C10 J^(-2/3) and C01 J^(-4/3).
    scale: [f64; 2],
    /// Derivatives of the scales by J.
    scale_slope: [f64; 2],
    /// Derivatives of I1 and I2 by F.
    invariants: [Tensor; 2],
    /// Factor of the cofactor in the stress.
    volumetric: f64,
    stress: Tensor,
}

impl MooneyRivlin {
    fn slopes(&self, f: &Tensor, k: &Kinematics) -> Slopes {
        let (d1, d2) = k.gradients(f);
        let s = k.j.powf(-2.0 / 3.0);
        let scale = [self.c10 * s, self.c01 * s * s];
        let scale_slope = [-2.0 / 3.0 * scale[0] / k.j, -4.0 / 3.0 * scale[1] / k.j];
        let volumetric = scale_slope[0] * k.i1 + scale_slope[1] * k.i2;
        let mut stress = [[0.0; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                stress[i][j] =
                    scale[0] * d1[i][j] + scale[1] * d2[i][j] + volumetric * k.cofactor[i][j];
            }
        }
        Slopes {
            scale,
            scale_slope,
            invariants: [d1, d2],
            volumetric,
            stress,
        }
    }
}

impl Isochoric for MooneyRivlin {
    fn energy(&self, deformation_gradient: &Tensor) -> f64 {
        let k = Kinematics::new(deformation_gradient);
        let s = k.j.powf(-2.0 / 3.0);
        self.c10 * (s * k.i1 - 3.0) + self.c01 * (s * s * k.i2 - 3.0)
    }

    fn stress(&self, deformation_gradient: &Tensor) -> Tensor {
        self.slopes(deformation_gradient, &Kinematics::new(deformation_gradient))
            .stress
    }

    #[allow(non_snake_case)] // book symbols
    fn stress_and_tangent(&self, deformation_gradient: &Tensor) -> (Tensor, Tensor4) {
        let F = deformation_gradient;
        let k = Kinematics::new(F);
        let Slopes {
            scale: [f1, f2],
            scale_slope: [g1, g2],
            invariants: [d1, d2],
            volumetric,
            stress,
        } = self.slopes(F, &k);
        let b = multiply(F, &transpose(F));
        let (C, G) = (&k.right_cauchy_green, &k.cofactor);
        // Second derivatives of c J^(-a) by J, for a = 2/3 and a = 4/3.
        let h = (10.0 / 9.0 * f1 * k.i1 + 28.0 / 9.0 * f2 * k.i2) / (k.j * k.j);
        let mut A = cofactor_derivative(F);
        for i in 0..3 {
            for j in 0..3 {
                let mixed_ij = g1 * d1[i][j] + g2 * d2[i][j];
                let row = &mut A[3 * i + j];
                for m in 0..3 {
                    for n in 0..3 {
                        let same_i = if i == m { 1.0 } else { 0.0 };
                        let same_j = if j == n { 1.0 } else { 0.0 };
                        let second_i1 = 2.0 * same_i * same_j;
                        let second_i2 = 4.0 * F[i][j] * F[m][n] + 2.0 * k.i1 * same_i * same_j
                            - 2.0 * (same_i * C[n][j] + F[i][n] * F[m][j] + b[i][m] * same_j);
                        let mixed_mn = g1 * d1[m][n] + g2 * d2[m][n];
                        let value = &mut row[3 * m + n];
                        *value = volumetric * *value
                            + f1 * second_i1
                            + f2 * second_i2
                            + mixed_ij * G[m][n]
                            + G[i][j] * mixed_mn
                            + h * G[i][j] * G[m][n];
                    }
                }
            }
        }
        (stress, A)
    }

    fn shear_modulus(&self) -> f64 {
        2.0 * (self.c10 + self.c01)
    }

    fn von_mises(&self, stretches: [f64; 3]) -> f64 {
        // Cauchy stress up to a pressure: 2 (C10 l_i^2 - C01 l_i^-2).
        von_mises_of_principal(stretches.map(|l| 2.0 * (self.c10 * l * l - self.c01 / (l * l))))
    }
}
