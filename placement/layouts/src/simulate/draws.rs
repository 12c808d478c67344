//! Random numbers of simulated contacts: the same for all layouts of one seed.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::arrangement::Arrangement;
use crate::simulate::normal_pairs::normal_pair;

/// Contacts in one period of a layout; as many more where there is none.
const CONTACTS: usize = 24;
/// Contacts of a layout without symmetry: every 2.5 degrees.
const MOST_CONTACTS: usize = 144;

/// Standard normal numbers, the same for all layouts: by sample, then film.
#[derive(Debug, Clone, PartialEq)]
pub struct Draws {
    seed: u64,
    samples: usize,
    films: usize,
    normals: Vec<f64>,
}

impl Draws {
    /// Draws so many readings, or a few more, of layouts of up to so many films.
    pub fn new(seed: u64, samples: usize, films: usize) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let most = MOST_CONTACTS * samples.div_ceil(MOST_CONTACTS);
        // The first of each pair alone.
        let normals = (0..most * films).map(|_| normal_pair(&mut rng)[0]);
        Self {
            normals: normals.collect(),
            seed,
            samples,
            films,
        }
    }

    /// Contacts of a layout that are simulated.
    pub(super) fn contacts_of(arrangement: &Arrangement) -> usize {
        match arrangement.period_deg < 360.0 {
            true => CONTACTS,
            false => MOST_CONTACTS,
        }
    }

    /// Samples of each contact of a layout that has so many.
    pub(super) fn repeats(&self, contacts: usize) -> usize {
        self.samples.div_ceil(contacts)
    }

    /// Number of samples of a layout, or a few more, of the largest kind.
    pub(super) fn most(&self) -> usize {
        MOST_CONTACTS * self.samples.div_ceil(MOST_CONTACTS)
    }

    /// The seed.
    pub(super) fn seed(&self) -> u64 {
        self.seed
    }

    /// Numbers of a sample, one for each film.
    pub(super) fn of(&self, sample: usize) -> &[f64] {
        &self.normals[sample * self.films..][..self.films]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAMPLES: usize = 480;

    #[test]
    fn one_seed_gives_the_same_numbers() {
        let [a, b, c] = [7, 7, 8].map(|seed| Draws::new(seed, SAMPLES, 3));
        assert_eq!(a, b);
        assert_ne!(a, c);
        let mean = a.normals.iter().sum::<f64>() / a.normals.len() as f64;
        let square = a.normals.iter().map(|z| z * z).sum::<f64>() / a.normals.len() as f64;
        // 1728 numbers: three of their standard errors.
        assert!(
            mean.abs() < 3.0 / 1728f64.sqrt()
                && (square - 1.0).abs() < 3.0 * (2.0 / 1728f64).sqrt()
        );
    }
}
