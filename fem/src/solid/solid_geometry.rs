//! Reference geometry of the bricks, and what follows from it and the displacements alone.

use crate::cell::element::{Order, brick_gradients, brick_points, pressure_modes};
use crate::cell::mesh::Mesh;
use crate::surface::stretch::StretchRange;
use crate::tensor::{IDENTITY, Tensor, cofactor, determinant};

/// Reference geometry of all bricks at their integration points, computed once per mesh.
#[derive(Debug)]
pub struct SolidGeometry {
    order: Order,
    points: usize,
    /// Pressure modes at each integration point.
    pub(super) modes: Vec<Vec<f64>>,
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
    /// Number of the brick.
    pub element: usize,
    /// Determinant of the map from the reference cube, mm^3.
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

    /// Reference volume of each integration point of a brick, mm^3.
    pub(super) fn point_weights(&self, element: usize) -> &[f64] {
        &self.weights[element * self.points..(element + 1) * self.points]
    }

    /// Gradients dN/dX of a brick's shape functions at an integration point, 1/mm.
    pub(super) fn point_gradients(
        &self,
        element: usize,
        point: usize,
        nodes: usize,
    ) -> &[[f64; 3]] {
        let offset = (element * self.points + point) * nodes;
        &self.gradients[offset..offset + nodes]
    }

    /// M of a brick by rows, mm^3.
    pub(super) fn mass(&self, element: usize) -> &[f64] {
        let entries = self.order.pressure_modes().pow(2);
        &self.mass[element * entries..(element + 1) * entries]
    }

    /// Inverse of M of a brick by rows, 1/mm^3.
    pub(super) fn inverse_mass(&self, element: usize) -> &[f64] {
        let entries = self.order.pressure_modes().pow(2);
        &self.inverse_mass[element * entries..(element + 1) * entries]
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

    /// F at the integration points of a brick.
    pub(super) fn deformation_gradients(
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

    /// Reference volume of a brick, mm^3.
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

/// F = 1 + grad u at a point with these gradients of the shape functions.
pub(super) fn deformation_gradient(displacement: &[[f64; 3]], gradients: &[[f64; 3]]) -> Tensor {
    let mut f = IDENTITY;
    for (u, g) in displacement.iter().zip(gradients) {
        for i in 0..3 {
            for j in 0..3 {
                f[i][j] += u[i] * g[j];
            }
        }
    }
    f
}
