//! Stiffness of a film of several isotropic layers (classical lamination theory, R. M. Jones, Mechanics of Composite Materials, 2nd ed., 1999, section 4.3).
//!
//! Heights are measured from the neutral plane, positive inwards, away from the wall. There the strain is e = e0 - z k, with the strain e0 of the neutral plane and
//! its change of curvature k, positive where the surface becomes more hollow towards the cavity.

/// Forces or strains along, across and in shear; of strains the third is doubled.
type InPlane = [f64; 3];

/// An isotropic layer in plane stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    /// Young's modulus, MPa.
    pub modulus: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Thickness, mm.
    pub thickness: f64,
}

impl Layer {
    /// Stresses by the strains, MPa.
    pub fn moduli(&self) -> [InPlane; 3] {
        let nu = self.poisson_ratio;
        let k = self.plane_strain_modulus();
        [
            [k, nu * k, 0.0],
            [nu * k, k, 0.0],
            [0.0, 0.0, 0.5 * (1.0 - nu) * k],
        ]
    }

    fn plane_strain_modulus(&self) -> f64 {
        self.modulus / (1.0 - self.poisson_ratio * self.poisson_ratio)
    }
}

/// Layers as one sheet about its neutral plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Laminate {
    /// Tensions by the strains of the neutral plane, N/mm.
    pub membrane: [InPlane; 3],
    /// Moments by the changes of curvature, N mm.
    pub bending: [InPlane; 3],
    /// The layer that makes charge.
    pub piezo: Layer,
    /// Height of that layer's middle above the neutral plane, mm.
    pub piezo_height: f64,
}

impl Laminate {
    /// Layers from the wall inwards, of which one makes charge.
    ///
    /// The neutral plane is that of the moduli in plane strain; layers of different Poisson's ratios couple tension and bending a little more, which is left out.
    ///
    /// # Panics
    /// When there is no such layer.
    pub fn new(layers: &[Layer], piezo: usize) -> Self {
        let mut bottom = 0.0;
        let middles: Vec<f64> = layers
            .iter()
            .map(|layer| {
                bottom += layer.thickness;
                bottom - 0.5 * layer.thickness
            })
            .collect();
        let weight = |layer: &Layer| layer.plane_strain_modulus() * layer.thickness;
        let moments = layers.iter().zip(&middles).map(|(l, z)| weight(l) * z);
        let neutral = moments.sum::<f64>() / layers.iter().map(weight).sum::<f64>();
        let (mut membrane, mut bending) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
        for (layer, middle) in layers.iter().zip(&middles) {
            let t = layer.thickness;
            let second_moment = t * t * t / 12.0 + t * (middle - neutral).powi(2);
            for (row, moduli) in layer.moduli().iter().enumerate() {
                for (column, modulus) in moduli.iter().enumerate() {
                    membrane[row][column] += modulus * t;
                    bending[row][column] += modulus * second_moment;
                }
            }
        }
        Self {
            membrane,
            bending,
            piezo: layers[piezo],
            piezo_height: middles[piezo] - neutral,
        }
    }

    /// Mean stresses of the layer that makes charge, MPa, where the neutral plane has this strain and this change of curvature (1/mm).
    pub(crate) fn piezo_stress(&self, strain: &InPlane, curvature: &InPlane) -> InPlane {
        let there = [0, 1, 2].map(|k| strain[k] - self.piezo_height * curvature[k]);
        product(&self.piezo.moduli(), &there)
    }
}

/// A matrix times in-plane components.
pub fn product(matrix: &[InPlane; 3], vector: &InPlane) -> InPlane {
    matrix.map(|row| (0..3).map(|k| row[k] * vector[k]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    const PVDF: Layer = Layer {
        modulus: 2500.0,
        poisson_ratio: 0.34,
        thickness: 0.028,
    };
    const POLYESTER: Layer = Layer {
        modulus: 3500.0,
        poisson_ratio: 0.34,
        thickness: 0.125,
    };

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-10 * b.abs().max(1e-12), "{a} {b}");
    }

    #[test]
    fn a_single_layer_bends_as_a_plate_and_sees_no_curvature() {
        let laminate = Laminate::new(&[PVDF], 0);
        let k = 2500.0 / (1.0 - 0.34 * 0.34);
        close(laminate.membrane[0][0], k * 0.028);
        close(laminate.bending[1][1], k * 0.028_f64.powi(3) / 12.0);
        close(laminate.bending[0][1], 0.34 * laminate.bending[1][1]);
        assert_eq!(laminate.piezo_height, 0.0);
    }

    /// Equal Poisson's ratios: the transformed section of a beam.
    #[test]
    fn a_film_on_polyester_reads_curvature_by_its_height_whichever_side_is_up() {
        let up = Laminate::new(&[POLYESTER, PVDF], 1);
        let down = Laminate::new(&[PVDF, POLYESTER], 0);
        let (a, b) = (3500.0 * 0.125, 2500.0 * 0.028);
        let neutral = (a * 0.0625 + b * 0.139) / (a + b);
        close(up.piezo_height, 0.139 - neutral);
        close(down.piezo_height, -up.piezo_height);
        // Parallel axes: own second moments and those about the common neutral plane.
        let own = 3500.0 * 0.125_f64.powi(3) / 12.0 + 2500.0 * 0.028_f64.powi(3) / 12.0;
        let steiner = a * b / (a + b) * 0.0765_f64.powi(2);
        close(up.bending[0][0], (own + steiner) / (1.0 - 0.34 * 0.34));
        // Flattened by 0.061 / mm: what lies further in is stretched.
        let stress = up.piezo_stress(&[0.0; 3], &[0.0, -0.061, 0.0]);
        let strain = up.piezo_height * 0.061;
        close(stress[1], 2500.0 / (1.0 - 0.34 * 0.34) * strain);
        close(stress[0], 0.34 * stress[1]);
        assert!((0.0039..0.0041).contains(&strain), "{strain}");
    }

    #[test]
    fn a_layer_in_uniaxial_tension_has_young_s_modulus_and_poisson_s_ratio() {
        let laminate = Laminate::new(&[PVDF], 0);
        let tension = product(&laminate.membrane, &[0.01, -0.34 * 0.01, 0.0]);
        close(tension[0], 2500.0 * 0.028 * 0.01);
        assert!(tension[1].abs() < 1e-13);
    }

    #[test]
    fn a_layer_is_isotropic() {
        let membrane = Laminate::new(&[POLYESTER], 0).membrane;
        let energy = |strain: &[f64; 3]| -> f64 {
            let tension = product(&membrane, strain);
            (0..3).map(|k| 0.5 * tension[k] * strain[k]).sum()
        };
        for (angle, [e11, e22, shear]) in
            [(0.4_f64, [0.1, -0.05, 0.02]), (-2.1, [0.03, 0.08, -0.1])]
        {
            let (s, c) = angle.sin_cos();
            let turned = [
                c * c * e11 + s * s * e22 + c * s * shear,
                s * s * e11 + c * c * e22 - c * s * shear,
                2.0 * c * s * (e22 - e11) + (c * c - s * s) * shear,
            ];
            close(energy(&turned), energy(&[e11, e22, shear]));
        }
    }

    /// A film glued to itself is the thicker film.
    #[test]
    fn layers_of_one_stuff_are_one_layer() {
        let third = Layer {
            thickness: PVDF.thickness / 3.0,
            ..PVDF
        };
        let (split, whole) = (Laminate::new(&[third; 3], 1), Laminate::new(&[PVDF], 0));
        for row in 0..3 {
            for column in 0..3 {
                close(split.membrane[row][column], whole.membrane[row][column]);
                close(split.bending[row][column], whole.bending[row][column]);
            }
        }
        assert!(split.piezo_height.abs() < 1e-17);
    }
}
