//! Readings of a layout whose signals scatter together: their covariance at one contact, as noise of each film and modes of all.
//!
//! With D the variances of noise and A the modes at the films, the covariance is C = D + A A'. By Woodbury's identity (1950) r' C^-1 r is r' D^-1 r - |B r|^2,
//! with B = L^-1 A' D^-1, L Cholesky's factor of 1 + A' D^-1 A, and ln det C = ln det D + 2 ln det L. The modes' scores after readings r off their means have
//! the mean L'^-1 B r.

use crate::arrangement::Arrangement;
use crate::field::film_field::{LoadField, Noise};
use crate::fisher::information::{Information, MOST};

/// Covariance of a layout's readings with the contact at one angle and depth.
pub(crate) struct JointScatter {
    /// Means by film.
    pub means: Vec<f64>,
    /// Variances of noise by film.
    pub variances: Vec<f64>,
    /// B by mode: a factor for each film.
    pub whitened: Vec<Vec<f64>>,
    /// Value of ln det C, of noise in units of its floor.
    pub log_determinant: f64,
    /// Numbers that go with the modes, each its mean and its factors of B r.
    pub told: Vec<(f64, Vec<f64>)>,
}

impl JointScatter {
    /// The covariance with the contact at an angle, degrees.
    pub fn new(
        field: &LoadField,
        arrangement: &Arrangement,
        noise: &Noise,
        contact_deg: f64,
    ) -> Self {
        let films = &arrangement.films;
        let places = films
            .iter()
            .map(|film| (film.kind, film.theta_deg - contact_deg));
        let signal = |kind: usize| &field.kinds[kind].signal;
        let means: Vec<f64> = places
            .clone()
            .map(|(kind, apart)| signal(kind).at(apart))
            .collect();
        let variances: Vec<f64> = places
            .clone()
            .zip(&means)
            .map(|((kind, apart), mean)| {
                let own = noise.variance(*mean, signal(kind).slope(apart));
                own + field.scatter(kind, apart)
            })
            .collect();
        let mode = |mode: usize| -> Vec<f64> {
            let at = |(kind, apart): (usize, f64)| field.modes.kinds[kind][mode].at(apart);
            places.clone().map(at).collect()
        };
        let modes: Vec<Vec<f64>> = (0..field.modes.count()).map(mode).collect();
        let mut whitened: Vec<Vec<f64>> = modes
            .iter()
            .map(|mode| mode.iter().zip(&variances).map(|(a, d)| a / d).collect())
            .collect();
        let factor = factor(&modes, &whitened);
        let mut told: Vec<(f64, Vec<f64>)> = field
            .modes
            .told
            .iter()
            .map(|told| (told.mean, told.with_modes.clone()))
            .collect();
        forwards(&factor, &mut whitened);
        for (_, with_modes) in &mut told {
            let mut columns: Vec<Vec<f64>> = with_modes.iter().map(|own| vec![*own]).collect();
            forwards(&factor, &mut columns);
            *with_modes = columns.concat();
        }
        let floor = noise.floor * noise.floor;
        let of_noise: f64 = variances.iter().map(|d| (d / floor).ln()).sum();
        let of_modes: f64 = factor.iter().enumerate().map(|(i, row)| row[i].ln()).sum();
        Self {
            means,
            variances,
            whitened,
            log_determinant: of_noise + 2.0 * of_modes,
            told,
        }
    }

    /// Distances of readings from their means.
    fn off(&self, readings: &[f64]) -> Vec<f64> {
        readings
            .iter()
            .zip(&self.means)
            .map(|(y, h)| y - h)
            .collect()
    }

    /// B r for readings off their means.
    fn scores(&self, off: &[f64]) -> Vec<f64> {
        self.whitened.iter().map(|row| dot(row, off)).collect()
    }

    /// Logarithm of the density of readings, but for a constant.
    pub fn log(&self, readings: &[f64]) -> f64 {
        let off = self.off(readings);
        let noise: f64 = off
            .iter()
            .zip(&self.variances)
            .map(|(r, d)| r * r / d)
            .sum();
        let modes: f64 = self.scores(&off).iter().map(|score| score * score).sum();
        -0.5 * (noise - modes + self.log_determinant)
    }

    /// Means after readings of the numbers that go with the modes.
    pub fn told(&self, readings: &[f64]) -> Vec<f64> {
        let scores = self.scores(&self.off(readings));
        let told = self.told.iter();
        told.map(|(mean, factors)| mean + dot(factors, &scores))
            .collect()
    }

    /// Takes off information on the unknowns what the modes hide of it; `slopes` are the films' derivatives by the unknowns.
    pub(crate) fn hide(&self, information: &mut Information, slopes: &[[f64; MOST]]) {
        for row in &self.whitened {
            let mut hidden = [0.0; MOST];
            for (factor, slopes) in row.iter().zip(slopes) {
                for (sum, slope) in hidden.iter_mut().zip(slopes) {
                    *sum += factor * slope;
                }
            }
            information.take(&hidden);
        }
    }
}

/// Cholesky's factor of 1 + A' D^-1 A, by rows: modes at the films, and these over the variances.
fn factor(modes: &[Vec<f64>], over_variances: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut factor: Vec<Vec<f64>> = Vec::with_capacity(modes.len());
    for (i, mode) in modes.iter().enumerate() {
        let mut row = Vec::with_capacity(i + 1);
        for (j, other) in over_variances.iter().enumerate().take(i + 1) {
            let before = |own: &[f64]| dot(&own[..j], &row[..j]);
            let entry = if i == j {
                (1.0 + dot(mode, other) - before(&row)).sqrt()
            } else {
                (dot(mode, other) - before(&factor[j])) / factor[j][j]
            };
            row.push(entry);
        }
        factor.push(row);
    }
    factor
}

/// Solves with a lower factor, in place, for all columns of rows.
fn forwards(factor: &[Vec<f64>], rows: &mut [Vec<f64>]) {
    for (i, own) in factor.iter().enumerate() {
        let (before, rest) = rows.split_at_mut(i);
        let row = &mut rest[0];
        for (other, entry) in before.iter().zip(own) {
            for (value, other) in row.iter_mut().zip(other) {
                *value -= entry * other;
            }
        }
        for value in row.iter_mut() {
            *value /= own[i];
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::film_field::DepthFields;
    use crate::field::response_surface::Drawn;
    use crate::field::response_surface::tests::surface;

    const NOISE: Noise = Noise {
        floor: 0.02,
        in_volts: false,
        gain_std: 0.05,
        place_std_deg: 0.5,
    };
    const CONTACT_DEG: f64 = 17.3;

    /// Solves with a positive definite matrix by elimination; returns ln det, too.
    fn solved(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> (Vec<f64>, f64) {
        let count = right.len();
        let mut logarithm = 0.0;
        for k in 0..count {
            logarithm += matrix[k][k].ln();
            for i in k + 1..count {
                let factor = matrix[i][k] / matrix[k][k];
                for j in k..count {
                    matrix[i][j] -= factor * matrix[k][j];
                }
                right[i] -= factor * right[k];
            }
        }
        for k in (0..count).rev() {
            let behind: f64 = (k + 1..count).map(|j| matrix[k][j] * right[j]).sum();
            right[k] = (right[k] - behind) / matrix[k][k];
        }
        (right, logarithm)
    }

    #[test]
    fn a_covariance_of_modes_is_that_of_the_full_matrix() {
        let field = DepthFields::over_contacts(surface(), Drawn::All, true).at(0.9);
        let arrangement = Arrangement::regular(7, &[0, 1], true);
        let joint = JointScatter::new(&field, &arrangement, &NOISE, CONTACT_DEG);
        let count = arrangement.films.len();
        assert!(field.modes.count() >= 2);
        let mode = |film: usize, mode: usize| {
            let laid = &arrangement.films[film];
            field.modes.kinds[laid.kind][mode].at(laid.theta_deg - CONTACT_DEG)
        };
        let entry = |i: usize, j: usize| {
            let noise = if i == j { joint.variances[i] } else { 0.0 };
            let modes = 0..field.modes.count();
            noise + modes.map(|k| mode(i, k) * mode(j, k)).sum::<f64>()
        };
        let matrix: Vec<Vec<f64>> = (0..count)
            .map(|i| (0..count).map(|j| entry(i, j)).collect())
            .collect();
        let off: Vec<f64> = (0..count).map(|i| 0.1 * (1.7 * i as f64).sin()).collect();
        let readings: Vec<f64> = joint.means.iter().zip(&off).map(|(h, r)| h + r).collect();
        let (weighted, logarithm) = solved(matrix.clone(), off.clone());
        let floors = count as f64 * (NOISE.floor * NOISE.floor).ln();
        let expected = -0.5 * (dot(&off, &weighted) + logarithm - floors);
        assert!((joint.log(&readings) - expected).abs() < 1e-9 * expected.abs());
        // What is told is the mean given the readings: its covariance with them times these weights.
        for (told, own) in joint.told(&readings).iter().zip(&field.modes.told) {
            let with = |film: usize| {
                let modes = own.with_modes.iter().enumerate();
                modes.map(|(k, with)| with * mode(film, k)).sum::<f64>()
            };
            let covariances: Vec<f64> = (0..count).map(with).collect();
            let expected = own.mean + dot(&covariances, &weighted);
            assert!(
                (told - expected).abs() < 1e-9 * (1.0 + expected.abs()),
                "{told} {expected}"
            );
        }
        // Information on angle and depth is J' C^-1 J.
        let mut found = Information::of(2);
        let slopes = arrangement
            .films
            .iter()
            .zip(&joint.variances)
            .map(|(film, variance)| {
                let kind = &field.kinds[film.kind];
                let mut slopes = [0.0; MOST];
                for (slope, own) in slopes
                    .iter_mut()
                    .zip(kind.derivatives(film.theta_deg - CONTACT_DEG))
                {
                    *slope = own;
                }
                found.add(&slopes, *variance);
                slopes
            });
        let slopes: Vec<[f64; MOST]> = slopes.collect();
        joint.hide(&mut found, &slopes);
        let column =
            |unknown: usize| -> Vec<f64> { slopes.iter().map(|own| own[unknown]).collect() };
        for i in 0..2 {
            let (weighted, _) = solved(matrix.clone(), column(i));
            for j in 0..2 {
                let expected = dot(&column(j), &weighted);
                let scale = (found.entry(i, i) * found.entry(j, j)).sqrt();
                assert!(
                    (found.entry(i, j) - expected).abs() < 1e-9 * scale,
                    "{i} {j}"
                );
            }
        }
    }
}
