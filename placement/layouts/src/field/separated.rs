//! Fields over depth and wheel angle as short sums of products: f(u, d) = sum over r of c_r(d) a_r(u).
//!
//! The functions are fields themselves, each the one that those before describe worst, less what they describe of it (Gram and Schmidt, with the largest rest
//! first). A field of a contact that grows with the depth needs six to ten of them for six digits.

use crate::field::hermite::Turn;

/// A separated field of several kinds of film.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Separated {
    /// c_r by depth and r.
    pub coefficients: Vec<Vec<f64>>,
    /// a_r by kind and r.
    pub functions: Vec<Vec<Turn>>,
}

impl Separated {
    /// Separates fields by depth and kind, a sample each degree; what is below `tolerance` of the largest field is left out.
    pub fn of(fields: &[Vec<Vec<f64>>], tolerance: f64) -> Self {
        let kinds = fields.first().map_or(0, Vec::len);
        let mut rest: Vec<Vec<f64>> = fields.iter().map(|kinds| kinds.concat()).collect();
        let largest = rest.iter().map(|field| square(field)).fold(0.0, f64::max);
        let mut separated = Self {
            coefficients: vec![Vec::new(); fields.len()],
            functions: vec![Vec::new(); kinds],
        };
        while let Some(direction) = worst(&rest, tolerance * tolerance * largest) {
            for (field, coefficients) in rest.iter_mut().zip(&mut separated.coefficients) {
                let coefficient: f64 = field.iter().zip(&direction).map(|(a, b)| a * b).sum();
                for (value, part) in field.iter_mut().zip(&direction) {
                    *value -= coefficient * part;
                }
                coefficients.push(coefficient);
            }
            let of_kinds = direction.chunks_exact(direction.len() / kinds);
            for (functions, samples) in separated.functions.iter_mut().zip(of_kinds) {
                functions.push(Turn::new(samples.to_vec()));
            }
        }
        separated
    }

    /// Counts the products that are summed.
    pub fn rank(&self) -> usize {
        self.coefficients.first().map_or(0, Vec::len)
    }
}

/// The largest field scaled to length one, if its square is above a limit.
fn worst(fields: &[Vec<f64>], limit: f64) -> Option<Vec<f64>> {
    let squares = fields.iter().map(|field| square(field));
    let (field, length) = fields
        .iter()
        .zip(squares)
        .max_by(|a, b| a.1.total_cmp(&b.1))?;
    let scale = length.sqrt();
    (length > limit).then(|| field.iter().map(|value| value / scale).collect())
}

fn square(field: &[f64]) -> f64 {
    field.iter().map(|value| value * value).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_of_three_products_is_found_as_such() {
        let depths: Vec<f64> = (0..9).map(|k| 0.2 + 0.1 * f64::from(k)).collect();
        let kind = |d: f64, shift: f64| -> Vec<f64> {
            (0..360)
                .map(|u| f64::from(u).to_radians() + shift)
                .map(|u| d * u.sin() + d * d * (2.0 * u).cos() + d.sqrt() * (5.0 * u).sin())
                .collect()
        };
        let fields: Vec<Vec<Vec<f64>>> = depths
            .iter()
            .map(|&d| vec![kind(d, 0.0), kind(d, 0.7)])
            .collect();
        let separated = Separated::of(&fields, 1e-10);
        assert_eq!(separated.rank(), 3);
        for (field, coefficients) in fields.iter().zip(&separated.coefficients) {
            for (kind, functions) in field.iter().zip(&separated.functions) {
                for degree in [0, 17, 359] {
                    let sum: f64 = coefficients
                        .iter()
                        .zip(functions)
                        .map(|(c, a)| c * a.samples()[degree])
                        .sum();
                    assert!((sum - kind[degree]).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn fields_of_nothing_have_no_products() {
        assert_eq!(Separated::of(&[vec![vec![0.0; 360]]], 1e-6).rank(), 0);
    }
}
