//! Stresses of bricks, as pictures show them.

use super::solid_geometry::SolidGeometry;
use super::solid_model::SolidModel;
use crate::tensor::{Tensor, determinant, multiply, transpose};

/// Means over a brick's current volume, MPa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanStress {
    /// Cauchy stress, MPa.
    pub cauchy: Tensor,
    /// Von Mises stress, MPa: the mean of it, which isn't that of the mean stress.
    pub von_mises: f64,
}

impl SolidGeometry {
    /// Mean stresses of a brick with these nodal displacements and pressures, from its integration points.
    ///
    /// The Cauchy stress is P_iso F^T / J + p 1; its first part has no trace, because the law is isochoric.
    pub fn mean_stress(
        &self,
        model: &SolidModel,
        element: usize,
        displacement: &[[f64; 3]],
        pressure: &[f64],
    ) -> MeanStress {
        let mut mean = MeanStress {
            cauchy: [[0.0; 3]; 3],
            von_mises: 0.0,
        };
        let mut volume = 0.0;
        let gradients = self.deformation_gradients(element, displacement);
        let points = gradients.zip(&self.modes).zip(self.point_weights(element));
        for ((f, modes), weight) in points {
            // The weight is J's share of the current volume; J itself cancels against 1/J.
            let kirchhoff = multiply(&model.material.stress(&f), &transpose(&f));
            let current = weight * determinant(&f);
            let p: f64 = modes.iter().zip(pressure).map(|(q, value)| q * value).sum();
            let mut squares = 0.0;
            for i in 0..3 {
                for j in 0..3 {
                    mean.cauchy[i][j] += weight * kirchhoff[i][j];
                    squares += kirchhoff[i][j] * kirchhoff[i][j];
                }
                mean.cauchy[i][i] += current * p;
            }
            mean.von_mises += weight * (1.5 * squares).sqrt();
            volume += current;
        }
        MeanStress {
            cauchy: mean.cauchy.map(|row| row.map(|s| s / volume)),
            von_mises: mean.von_mises / volume,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::element::Order;
    use crate::cell::mesh::Mesh;
    use crate::material::NeoHookean;

    /// A unit cube stretched by l along x and by l^(-1/2) across: sigma_x - sigma_y = mu (l^2 - 1/l), which is the von Mises stress too.
    #[test]
    fn a_stretched_cube_has_the_stress_of_the_closed_form() {
        let nodes: Vec<[f64; 3]> = (0..8)
            .map(|a| [a & 1, a >> 1 & 1, a >> 2].map(f64::from))
            .collect();
        let mesh = Mesh {
            order: Order::Linear,
            nodes: nodes.clone(),
            bricks: (0..8).collect(),
        };
        let (mu, stretch, p) = (0.36, 1.7f64, -0.2);
        let model = SolidModel {
            material: Box::new(NeoHookean { c10: 0.5 * mu }),
            compliance: 0.0,
        };
        let across = stretch.powf(-0.5) - 1.0;
        let displacement: Vec<[f64; 3]> = nodes
            .iter()
            .map(|x| [(stretch - 1.0) * x[0], across * x[1], across * x[2]])
            .collect();
        let geometry = SolidGeometry::new(&mesh).unwrap();
        let stress = geometry.mean_stress(&model, 0, &displacement, &[p]);
        let difference = mu * (stretch * stretch - 1.0 / stretch);
        let exact = [2.0 / 3.0, -1.0 / 3.0, -1.0 / 3.0].map(|share| share * difference + p);
        for i in 0..3 {
            for j in 0..3 {
                let expected = if i == j { exact[i] } else { 0.0 };
                assert!((stress.cauchy[i][j] - expected).abs() < 1e-14);
            }
        }
        assert!((stress.von_mises - difference).abs() < 1e-14);
    }
}
