//! The mixed displacement-pressure brick.
//!
//! With the pressure `p` an independent, element-wise discontinuous field and `c` the bulk compliance (1/kappa; 0 is
//! exactly incompressible), the element makes stationary
//!
//! > integral of W_iso(F) + p (J - 1) - c p^2 / 2 over the reference volume.
//!
//! Residuals, with G the cofactor of F and q the pressure modes:
//!
//! > r_u = integral of (P_iso + p G) : grad(du),   r_p = integral of q (J - 1) - c M p,   M = integral of q q.
//!
//! One Newton step eliminates the pressures on the element. Where c is smaller than the compliance [`SolidModel::step_compliance`]
//! the step (never the residual) uses that larger one: a proximal step, whose limit is the exact constraint and whose
//! matrix stays positive definite and well conditioned for any bulk modulus. Pressures kept as unknowns make this
//! converge where p = kappa (J - 1), inserted, does not.

mod stress;

pub use self::stress::MeanStress;

use crate::cell::element::{Order, brick_gradients, brick_points, pressure_modes};
use crate::cell::mesh::Mesh;
use crate::material::Isochoric;
use crate::surface::stretch::StretchRange;
use crate::tensor::{Tensor, cofactor, cofactor_derivative, determinant};

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
    pub fn step_compliance(&self) -> f64 {
        self.compliance
            .max(1.0 / (STEP_BULK_RATIO * self.material.shear_modulus()))
    }
}

/// Reference geometry of all bricks at their integration points, computed once per mesh.
#[derive(Debug)]
pub struct SolidGeometry {
    order: Order,
    points: usize,
    /// Pressure modes at each integration point.
    modes: Vec<Vec<f64>>,
    /// Shape function gradients dN/dX: brick, point, node, axis.
    gradients: Vec<[f64; 3]>,
    /// Reference volume of each integration point: brick, point.
    weights: Vec<f64>,
    /// Inverse of M: brick, row, column.
    inverse_mass: Vec<f64>,
    /// M: brick, row, column.
    mass: Vec<f64>,
}

/// A brick is turned inside out or has no volume in the reference state.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("brick {element} has a non-positive Jacobian {jacobian} in the reference state")]
pub struct InvalidReference {
    /// Which brick.
    pub element: usize,
    /// Determinant of the map from the reference cube.
    pub jacobian: f64,
}

impl SolidGeometry {
    /// Integrates the reference geometry.
    ///
    /// # Errors
    /// [`InvalidReference`] names the first inverted brick.
    pub fn new(mesh: &Mesh) -> Result<Self, InvalidReference> {
        let order = mesh.order;
        let rule = brick_points(order);
        let modes: Vec<_> = rule
            .iter()
            .map(|(point, _)| pressure_modes(order, *point))
            .collect();
        let tables: Vec<_> = rule
            .iter()
            .map(|(point, _)| brick_gradients(order, *point))
            .collect();
        let mut geometry = Self {
            order,
            points: rule.len(),
            modes,
            gradients: Vec::new(),
            weights: Vec::new(),
            inverse_mass: Vec::new(),
            mass: Vec::new(),
        };
        for element in 0..mesh.brick_count() {
            for ((_, weight), table) in rule.iter().zip(&tables) {
                let jacobian = jacobian_matrix(mesh, element, table);
                let volume = determinant(&jacobian);
                if volume.is_nan() || volume <= 0.0 {
                    return Err(InvalidReference {
                        element,
                        jacobian: volume,
                    });
                }
                // dN/dX = J^-T dN/dxi, with J_ij = dX_i/dxi_j.
                let inverse_transpose = cofactor(&jacobian).map(|row| row.map(|c| c / volume));
                geometry.gradients.extend(table.iter().map(|g| {
                    [0, 1, 2].map(|i| (0..3).map(|j| inverse_transpose[i][j] * g[j]).sum())
                }));
                geometry.weights.push(weight * volume);
            }
            geometry.push_mass(element);
        }
        Ok(geometry)
    }

    fn push_mass(&mut self, element: usize) {
        let m = self.order.pressure_modes();
        let mut mass = vec![0.0; m * m];
        for (modes, weight) in self.modes.iter().zip(self.point_weights(element)) {
            for r in 0..m {
                for c in 0..m {
                    mass[r * m + c] += weight * modes[r] * modes[c];
                }
            }
        }
        self.inverse_mass.extend(inverse_spd(&mass, m));
        self.mass.extend(mass);
    }

    fn point_weights(&self, element: usize) -> &[f64] {
        &self.weights[element * self.points..(element + 1) * self.points]
    }

    /// Mean J of a brick.
    pub fn mean_volume_ratio(&self, element: usize, displacement: &[[f64; 3]]) -> f64 {
        let ratios = self
            .deformation_gradients(element, displacement)
            .map(|f| determinant(&f));
        let weights = self.point_weights(element);
        let deformed: f64 = ratios
            .zip(weights)
            .map(|(ratio, weight)| weight * ratio)
            .sum();
        deformed / self.volume(element)
    }

    /// Smallest and largest principal stretch at the integration points of a brick.
    pub fn stretch_range(&self, element: usize, displacement: &[[f64; 3]]) -> StretchRange {
        self.deformation_gradients(element, displacement)
            .map(|f| StretchRange::of(&f))
            .fold(StretchRange::UNDEFORMED, StretchRange::with)
    }

    fn deformation_gradients(
        &self,
        element: usize,
        displacement: &[[f64; 3]],
    ) -> impl Iterator<Item = Tensor> {
        let nodes = displacement.len();
        let start = element * self.points * nodes;
        self.gradients[start..start + self.points * nodes]
            .chunks_exact(nodes)
            .map(|gradients| deformation_gradient(displacement, gradients))
    }

    /// Reference volume of a brick.
    pub fn volume(&self, element: usize) -> f64 {
        self.point_weights(element).iter().sum()
    }
}

fn jacobian_matrix(mesh: &Mesh, element: usize, gradients: &[[f64; 3]]) -> Tensor {
    let lateral = mesh.order.lateral_tangent();
    let mut jacobian = lateral.map(|component| [0.0, component, 0.0]);
    for (&node, gradient) in mesh.brick(element).iter().zip(gradients) {
        let position = &mesh.nodes[node as usize];
        for i in 0..3 {
            for j in 0..3 {
                jacobian[i][j] += position[i] * gradient[j];
            }
        }
    }
    jacobian
}

/// Inverse of a small symmetric positive definite matrix by Gauss-Jordan elimination.
fn inverse_spd(matrix: &[f64], n: usize) -> Vec<f64> {
    let mut work = matrix.to_vec();
    let mut inverse = vec![0.0; n * n];
    for i in 0..n {
        inverse[i * n + i] = 1.0;
    }
    for pivot in 0..n {
        let scale = 1.0 / work[pivot * n + pivot];
        for c in 0..n {
            work[pivot * n + c] *= scale;
            inverse[pivot * n + c] *= scale;
        }
        for r in (0..n).filter(|&r| r != pivot) {
            let factor = work[r * n + pivot];
            for c in 0..n {
                work[r * n + c] -= factor * work[pivot * n + c];
                inverse[r * n + c] -= factor * inverse[pivot * n + c];
            }
        }
    }
    inverse
}

/// What one brick contributes, in buffers that are reused from brick to brick.
#[derive(Debug, Clone)]
pub struct SolidContribution {
    /// Nodal forces r_u.
    pub residual: Vec<f64>,
    /// r_p.
    pub pressure_residual: Vec<f64>,
    /// Smallest J of an integration point; minus infinity when one isn't a number.
    pub min_volume_ratio: f64,
    /// Derivative of r_p by the displacements: mode, unknown.
    pub coupling: Vec<f64>,
    /// Derivative of r_u by the displacements, condensed by [`SolidContribution::condense`]; row by row, only the upper
    /// triangle is meaningful.
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

    /// Integrates one brick with these nodal displacements and pressures; the tangent only when asked for.
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
            let offset = (element * geometry.points + point) * nodes;
            let gradients = &geometry.gradients[offset..offset + nodes];
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
        let mass = &geometry.mass[element * m * m..(element + 1) * m * m];
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
    pub fn condense(&mut self, model: &SolidModel, geometry: &SolidGeometry, element: usize) {
        let unknowns = self.residual.len();
        let m = self.pressure_residual.len();
        let inverse = &geometry.inverse_mass[element * m * m..(element + 1) * m * m];
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

    /// Pressure increments M^-1 (B du + r_p) / c, given the sum of the two terms.
    pub fn pressure_increment(
        model: &SolidModel,
        geometry: &SolidGeometry,
        element: usize,
        volume_change: &[f64],
        increment: &mut [f64],
    ) {
        let m = volume_change.len();
        let inverse = &geometry.inverse_mass[element * m * m..(element + 1) * m * m];
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

fn deformation_gradient(displacement: &[[f64; 3]], gradients: &[[f64; 3]]) -> Tensor {
    let mut f = crate::tensor::IDENTITY;
    for (u, g) in displacement.iter().zip(gradients) {
        for i in 0..3 {
            for j in 0..3 {
                f[i][j] += u[i] * g[j];
            }
        }
    }
    f
}
