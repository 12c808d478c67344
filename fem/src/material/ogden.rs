//! Ogden: W = sum over terms of (2 mu / alpha^2) (l1^alpha + l2^alpha + l3^alpha - 3) in the isochoric principal stretches
//! l_a = J^(-1/3) lambda_a (R. W. Ogden, Proc. R. Soc. Lond. A 326 (1972) 565).
//!
//! The weight is that of Abaqus and CalculiX, in which the terms' mu add up to the initial shear modulus; Ogden's own mu
//! is 2 / alpha times this one.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | `n_a`, `N_a` | current and reference principal directions, F N_a = lambda_a n_a |
//! | `c_a` | lambda_a^2, eigenvalue of C = F^T F |
//! | `beta_a` | principal Kirchhoff stress dW / d ln(lambda_a); they add up to zero |
//! | `gamma_ab` | d beta_a / d ln(lambda_b) |
//!
//! The second Piola-Kirchhoff stress is the sum of beta_a / c_a N_a x N_a. Its derivative by C has the moduli
//! gamma_ab / (c_a c_b) - 2 beta_a / c_a^2 (a = b) on the diagonal and the divided differences of beta_a / c_a by c_a
//! beside it. A difference of powers divided by that of their bases is (x^k - y^k) / (x - y) = y^(k-1) expm1(k ln(1 + d)) / d with
//! d = (x - y) / y: exact to round-off however close x is to y, and k y^(k-1) where they are equal.

use super::isochoric::{Isochoric, von_mises_of_principal};
use crate::tensor::{Tensor, Tensor4, multiply, symmetric_eigen, transpose};

/// A term of Ogden's law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OgdenTerm {
    /// Share of the initial shear modulus, MPa.
    pub mu: f64,
    /// Exponent, not zero.
    pub alpha: f64,
}

/// The terms.
#[derive(Debug, Clone, PartialEq)]
pub struct Ogden {
    /// Terms, at least one.
    pub terms: Vec<OgdenTerm>,
}

/// Pairs of principal directions.
const PAIRS: [(usize, usize); 3] = [(0, 1), (1, 2), (2, 0)];

/// Principal stretches and directions of a deformation.
struct Spectrum {
    /// c_a.
    squares: [f64; 3],
    /// ln l_a, of the isochoric stretches.
    logarithms: [f64; 3],
    /// N_a in the columns.
    directions: Tensor,
}

impl Spectrum {
    fn new(f: &Tensor) -> Self {
        let (squares, directions) = symmetric_eigen(&multiply(&transpose(f), f));
        Self {
            squares,
            logarithms: isochoric(squares.map(|c| 0.5 * c.ln())),
            directions,
        }
    }
}

/// Logarithmic stretches without their mean.
fn isochoric(logarithms: [f64; 3]) -> [f64; 3] {
    let mean = (logarithms[0] + logarithms[1] + logarithms[2]) / 3.0;
    logarithms.map(|l| l - mean)
}

/// Derivatives of the energy by the principal stretches.
struct Moduli {
    beta: [f64; 3],
    gamma: [[f64; 3]; 3],
    /// Divided differences of beta_a / c_a, one for each of the pairs.
    shear: [f64; 3],
}

impl Ogden {
    fn energy_of(&self, logarithms: &[f64; 3]) -> f64 {
        let term = |t: &OgdenTerm| {
            let sum: f64 = logarithms.iter().map(|l| (t.alpha * l).exp_m1()).sum();
            2.0 * t.mu / (t.alpha * t.alpha) * sum
        };
        self.terms.iter().map(term).sum()
    }

    fn beta(&self, logarithms: &[f64; 3]) -> [f64; 3] {
        let mut beta = [0.0; 3];
        for t in &self.terms {
            let powers = logarithms.map(|l| (t.alpha * l).exp_m1());
            let mean = (powers[0] + powers[1] + powers[2]) / 3.0;
            for a in 0..3 {
                beta[a] += 2.0 * t.mu / t.alpha * (powers[a] - mean);
            }
        }
        beta
    }

    fn moduli(&self, spectrum: &Spectrum) -> Moduli {
        let c = &spectrum.squares;
        let mut gamma = [[0.0; 3]; 3];
        let mut differences = [0.0; 3];
        // The base of each divided difference is the smaller eigenvalue: d is never near -1.
        let pairs = PAIRS.map(|(a, b)| if c[a] < c[b] { (a, b) } else { (b, a) });
        let gaps = pairs.map(|(low, high)| (c[high] - c[low]) / c[low]);
        for t in &self.terms {
            let powers = spectrum.logarithms.map(|l| (t.alpha * l).exp());
            let mean = (powers[0] + powers[1] + powers[2]) / 3.0;
            for a in 0..3 {
                for b in 0..3 {
                    let own = if a == b { powers[a] } else { 0.0 };
                    gamma[a][b] += 2.0 * t.mu * (own + (mean - powers[a] - powers[b]) / 3.0);
                }
            }
            for ((difference, gap), (low, _)) in differences.iter_mut().zip(gaps).zip(pairs) {
                let k = 0.5 * t.alpha;
                let ratio = if gap == 0.0 {
                    k
                } else {
                    (k * gap.ln_1p()).exp_m1() / gap
                };
                *difference += 2.0 * t.mu / t.alpha * powers[low] * ratio;
            }
        }
        let beta = self.beta(&spectrum.logarithms);
        let shear = std::array::from_fn(|k| {
            let (low, high) = pairs[k];
            (differences[k] - beta[low]) / (c[low] * c[high])
        });
        Moduli { beta, gamma, shear }
    }
}

/// The sum of beta_a / c_a (F N_a) x N_a.
fn first_piola_kirchhoff(beta: &[f64; 3], c: &[f64; 3], dyads: &[[[f64; 9]; 3]; 3]) -> Tensor {
    let mut stress = [[0.0; 3]; 3];
    for a in 0..3 {
        for k in 0..9 {
            stress[k / 3][k % 3] += beta[a] / c[a] * dyads[a][a][k];
        }
    }
    stress
}

/// (F N_a) x N_b for all a and b.
fn dyads(f: &Tensor, directions: &Tensor) -> [[[f64; 9]; 3]; 3] {
    let current = multiply(f, directions);
    std::array::from_fn(|a| {
        std::array::from_fn(|b| std::array::from_fn(|k| current[k / 3][a] * directions[k % 3][b]))
    })
}

impl Isochoric for Ogden {
    fn energy(&self, deformation_gradient: &Tensor) -> f64 {
        self.energy_of(&Spectrum::new(deformation_gradient).logarithms)
    }

    fn stress(&self, deformation_gradient: &Tensor) -> Tensor {
        let spectrum = Spectrum::new(deformation_gradient);
        let dyads = dyads(deformation_gradient, &spectrum.directions);
        first_piola_kirchhoff(&self.beta(&spectrum.logarithms), &spectrum.squares, &dyads)
    }

    /// Returns S and A: with M_ab = (F N_a) x N_b and S the second Piola-Kirchhoff stress, A = sum_ab D_ab M_aa x M_bb + sum_(a<b) T_ab (M_ab + M_ba)
    /// x (M_ab + M_ba) + 1 x S.
    fn stress_and_tangent(&self, deformation_gradient: &Tensor) -> (Tensor, Tensor4) {
        let spectrum = Spectrum::new(deformation_gradient);
        let Moduli { beta, gamma, shear } = self.moduli(&spectrum);
        let c = &spectrum.squares;
        let m = dyads(deformation_gradient, &spectrum.directions);
        let mut tangent = [[0.0; 9]; 9];
        let mut add = |factor: f64, left: &[f64; 9], right: &[f64; 9]| {
            for (row, l) in tangent.iter_mut().zip(left) {
                for (value, r) in row.iter_mut().zip(right) {
                    *value += factor * l * r;
                }
            }
        };
        for a in 0..3 {
            for b in 0..3 {
                let own = if a == b { 2.0 * beta[a] } else { 0.0 };
                add((gamma[a][b] - own) / (c[a] * c[b]), &m[a][a], &m[b][b]);
            }
        }
        for ((a, b), t) in PAIRS.into_iter().zip(shear) {
            let both: [f64; 9] = std::array::from_fn(|k| m[a][b][k] + m[b][a][k]);
            add(t, &both, &both);
        }
        let n = &spectrum.directions;
        for j in 0..3 {
            for l in 0..3 {
                let second: f64 = (0..3).map(|a| beta[a] / c[a] * n[j][a] * n[l][a]).sum();
                for i in 0..3 {
                    tangent[3 * i + j][3 * i + l] += second;
                }
            }
        }
        (first_piola_kirchhoff(&beta, c, &m), tangent)
    }

    fn shear_modulus(&self) -> f64 {
        self.terms.iter().map(|t| t.mu).sum()
    }

    fn von_mises(&self, stretches: [f64; 3]) -> f64 {
        von_mises_of_principal(self.beta(&isochoric(stretches.map(f64::ln))))
    }
}
