//! Polynomials fitted to samples around a corner of a surface mesh.

use crate::cell::element::Order;
use crate::surface::small_system::solve_spd;

/// Samples of a patch: position relative to its corner, and (s1, s2, shear) there.
pub type Sample = ([f64; 2], [f64; 3]);

/// A polynomial around a corner in coordinates scaled by the patch's size.
#[derive(Debug, Clone)]
pub struct Patch {
    scale: [f64; 2],
    coefficients: Vec<[f64; 3]>,
}

/// Number of monomials of complete polynomials: degree 1 for 4-node faces, degree 2 for 9-node faces.
fn monomial_count(order: Order) -> usize {
    match order.edge_nodes() {
        2 => 3,
        _ => 6,
    }
}

/// The monomials, of which the first [`monomial_count`] are used.
fn monomials([a, b]: [f64; 2]) -> [f64; 6] {
    [1.0, a, b, a * a, a * b, b * b]
}

impl Patch {
    fn scaled(&self, s: [f64; 2]) -> [f64; 2] {
        [s[0] / self.scale[0], s[1] / self.scale[1]]
    }

    /// Least squares through the samples by the normal equations; coordinates scaled to the patch keep them well
    /// conditioned.
    pub fn fit(order: Order, samples: &[Sample]) -> Self {
        let scale = [0, 1].map(|k| {
            samples
                .iter()
                .map(|(s, _)| s[k].abs())
                .fold(f64::MIN_POSITIVE, f64::max)
        });
        let mut patch = Self {
            scale,
            coefficients: Vec::new(),
        };
        let rows = samples.iter().map(|(s, _)| monomials(patch.scaled(*s)));
        let n = monomial_count(order);
        let mut normal = vec![vec![0.0; n]; n];
        let mut rhs = vec![[0.0; 3]; n];
        for (row, (_, value)) in rows.zip(samples) {
            for i in 0..n {
                for j in 0..n {
                    normal[i][j] += row[i] * row[j];
                }
                for k in 0..3 {
                    rhs[i][k] += row[i] * value[k];
                }
            }
        }
        solve_spd(&mut normal, &mut rhs);
        patch.coefficients = rhs;
        patch
    }

    /// Value at a position relative to the corner.
    pub fn at(&self, position: [f64; 2]) -> [f64; 3] {
        let mut value = [0.0; 3];
        for (c, b) in self
            .coefficients
            .iter()
            .zip(monomials(self.scaled(position)))
        {
            for k in 0..3 {
                value[k] += b * c[k];
            }
        }
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_complete_polynomial_is_reproduced() {
        let field = |[a, b]: [f64; 2]| [1.0 + 2.0 * a - b, a * a - 3.0 * a * b, 0.5 * b * b];
        let samples: Vec<Sample> = (0..16)
            .map(|i| [0.3 * f64::from(i % 4) - 0.4, 7.0 * f64::from(i / 4) - 9.0])
            .map(|s| (s, field(s)))
            .collect();
        let patch = Patch::fit(Order::Quadratic, &samples);
        for (value, exact) in patch.at([0.1, 2.0]).into_iter().zip(field([0.1, 2.0])) {
            // Normal equations of scaled monomials have a condition number below 1e3; the field reaches 60.
            assert!(
                (value - exact).abs() < 1e3 * 60.0 * f64::EPSILON,
                "{value} for {exact}"
            );
        }
    }
}
