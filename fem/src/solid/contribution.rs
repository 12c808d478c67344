//! Residuals and tangent of one brick.

use super::solid_geometry::{SolidGeometry, deformation_gradient};
use super::solid_model::SolidModel;
use crate::cell::element::Order;
use crate::tensor::{Tensor, cofactor, cofactor_derivative, determinant};

/// Contribution of a brick, in buffers that are reused from brick to brick.
#[derive(Debug, Clone)]
pub(crate) struct SolidContribution {
    /// Nodal forces r_u, N.
    pub residual: Vec<f64>,
    /// r_p, mm^3.
    pub pressure_residual: Vec<f64>,
    /// Smallest J of an integration point; minus infinity when one isn't a number.
    pub min_volume_ratio: f64,
    /// Derivative of r_p by the displacements, mm^2: mode, unknown.
    pub coupling: Vec<f64>,
    /// Derivative of r_u by the displacements, N/mm, condensed by [`SolidContribution::condense`]; row by row, only the
    /// upper triangle is meaningful.
    pub stiffness: Vec<f64>,
    stress_rows: Vec<f64>,
    condensed: Vec<f64>,
}

impl SolidContribution {
    /// Buffers for bricks of this order.
    pub fn new(order: Order) -> Self {
        let unknowns = 3 * order.brick_nodes();
        let modes = order.pressure_modes();
        Self {
            residual: vec![0.0; unknowns],
            pressure_residual: vec![0.0; modes],
            min_volume_ratio: 1.0,
            coupling: vec![0.0; modes * unknowns],
            stiffness: vec![0.0; unknowns * unknowns],
            stress_rows: vec![0.0; 9 * unknowns],
            condensed: vec![0.0; modes * unknowns],
        }
    }

    fn clear(&mut self, tangent: bool) {
        self.residual.fill(0.0);
        self.pressure_residual.fill(0.0);
        self.min_volume_ratio = f64::INFINITY;
        if tangent {
            self.coupling.fill(0.0);
            self.stiffness.fill(0.0);
        }
    }

    /// Integrates one brick with these nodal displacements (mm) and pressures (MPa); the tangent only when asked for.
    pub fn integrate(
        &mut self,
        model: &SolidModel,
        geometry: &SolidGeometry,
        element: usize,
        displacement: &[[f64; 3]],
        pressure: &[f64],
        tangent: bool,
    ) {
        self.clear(tangent);
        let nodes = displacement.len();
        for (point, &weight) in geometry.point_weights(element).iter().enumerate() {
            let gradients = geometry.point_gradients(element, point, nodes);
            let f = deformation_gradient(displacement, gradients);
            let (g, j) = (cofactor(&f), determinant(&f));
            self.min_volume_ratio = if j.is_nan() {
                f64::NEG_INFINITY
            } else {
                self.min_volume_ratio.min(j)
            };
            let modes = &geometry.modes[point];
            let p: f64 = modes.iter().zip(pressure).map(|(q, value)| q * value).sum();
            for (residual, q) in self.pressure_residual.iter_mut().zip(modes) {
                *residual += weight * q * (j - 1.0);
            }
            let stress = if tangent {
                let (stress, mut moduli) = model.material.stress_and_tangent(&f);
                let geometric = cofactor_derivative(&f);
                for (row, extra) in moduli.iter_mut().zip(&geometric) {
                    for (value, d) in row.iter_mut().zip(extra) {
                        *value = weight * (*value + p * d);
                    }
                }
                self.add_stiffness(gradients, &moduli);
                self.add_coupling(gradients, &g, modes, weight);
                stress
            } else {
                model.material.stress(&f)
            };
            self.add_residual(gradients, &stress, &g, p, weight);
        }
        let m = pressure.len();
        let mass = geometry.mass(element);
        for (r, residual) in self.pressure_residual.iter_mut().enumerate() {
            let product: f64 = (0..m).map(|c| mass[r * m + c] * pressure[c]).sum();
            *residual -= model.compliance * product;
        }
    }

    fn add_residual(
        &mut self,
        gradients: &[[f64; 3]],
        stress: &Tensor,
        g: &Tensor,
        p: f64,
        weight: f64,
    ) {
        for (force, gradient) in self.residual.chunks_exact_mut(3).zip(gradients) {
            for i in 0..3 {
                force[i] += weight
                    * (0..3)
                        .map(|j| (stress[i][j] + p * g[i][j]) * gradient[j])
                        .sum::<f64>();
            }
        }
    }

    fn add_coupling(&mut self, gradients: &[[f64; 3]], g: &Tensor, modes: &[f64], weight: f64) {
        let unknowns = self.residual.len();
        for (node, gradient) in gradients.iter().enumerate() {
            for i in 0..3 {
                let value = weight * (0..3).map(|j| g[i][j] * gradient[j]).sum::<f64>();
                for (mode, q) in modes.iter().enumerate() {
                    self.coupling[mode * unknowns + 3 * node + i] += q * value;
                }
            }
        }
    }

    /// Adds grad^T A grad, upper triangle by rows. First D = A grad (9 rows), then K_(a i) += sum_J grad_(a J) D_(i J).
    fn add_stiffness(&mut self, gradients: &[[f64; 3]], moduli: &[[f64; 9]; 9]) {
        let unknowns = self.residual.len();
        for (row, moduli) in self.stress_rows.chunks_exact_mut(unknowns).zip(moduli) {
            for (values, g) in row.chunks_exact_mut(3).zip(gradients) {
                values[0] = moduli[0] * g[0] + moduli[1] * g[1] + moduli[2] * g[2];
                values[1] = moduli[3] * g[0] + moduli[4] * g[1] + moduli[5] * g[2];
                values[2] = moduli[6] * g[0] + moduli[7] * g[1] + moduli[8] * g[2];
            }
        }
        let rows: Vec<&[f64]> = self.stress_rows.chunks_exact(unknowns).collect();
        for (node, g) in gradients.iter().enumerate() {
            let start = 3 * node;
            for i in 0..3 {
                let target =
                    &mut self.stiffness[(start + i) * unknowns + start..(start + i + 1) * unknowns];
                let (d0, d1, d2) = (
                    &rows[3 * i][start..],
                    &rows[3 * i + 1][start..],
                    &rows[3 * i + 2][start..],
                );
                for (((value, a), b), c) in target.iter_mut().zip(d0).zip(d1).zip(d2) {
                    *value += g[0] * a + g[1] * b + g[2] * c;
                }
            }
        }
    }

    /// Eliminates the pressures: adds B^T M^-1 B / c to the stiffness.
    pub(crate) fn condense(
        &mut self,
        model: &SolidModel,
        geometry: &SolidGeometry,
        element: usize,
    ) {
        let unknowns = self.residual.len();
        let m = self.pressure_residual.len();
        let inverse = geometry.inverse_mass(element);
        let scale = 1.0 / model.step_compliance();
        self.condensed.fill(0.0);
        for r in 0..m {
            let target = &mut self.condensed[r * unknowns..(r + 1) * unknowns];
            for c in 0..m {
                let factor = scale * inverse[r * m + c];
                for (value, b) in target
                    .iter_mut()
                    .zip(&self.coupling[c * unknowns..(c + 1) * unknowns])
                {
                    *value += factor * b;
                }
            }
        }
        for mode in 0..m {
            let condensed = &self.condensed[mode * unknowns..(mode + 1) * unknowns];
            let coupling = &self.coupling[mode * unknowns..(mode + 1) * unknowns];
            for (row, &b) in coupling.iter().enumerate() {
                let target = &mut self.stiffness[row * unknowns + row..(row + 1) * unknowns];
                for (value, y) in target.iter_mut().zip(&condensed[row..]) {
                    *value += b * y;
                }
            }
        }
    }

    /// Pressure increments M^-1 (B du + r_p) / c, MPa, given the sum of the two terms, mm^3.
    pub(crate) fn pressure_increment(
        model: &SolidModel,
        geometry: &SolidGeometry,
        element: usize,
        volume_change: &[f64],
        increment: &mut [f64],
    ) {
        let m = volume_change.len();
        let inverse = geometry.inverse_mass(element);
        let scale = 1.0 / model.step_compliance();
        for (row, value) in inverse.chunks_exact(m).zip(increment) {
            *value = scale
                * row
                    .iter()
                    .zip(volume_change)
                    .map(|(w, v)| w * v)
                    .sum::<f64>();
        }
    }
}
