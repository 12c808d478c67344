//! Random parameters and frequent laws of the models.

use gsa::law::distribution::Distribution;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::exact::{Factor, of};

/// A source of random parameters.
pub struct Draw(ChaCha8Rng);

impl Draw {
    pub fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.0.next_u64() >> 11) as f64 * (0.5 * f64::EPSILON);
        low + (high - low) * unit
    }

    pub fn count(&mut self, low: usize, high: usize) -> usize {
        self.range(low as f64, (high + 1) as f64) as usize
    }

    pub fn many(&mut self, n: usize, low: f64, high: f64) -> Vec<f64> {
        (0..n).map(|_| self.range(low, high)).collect()
    }

    /// The sum of twelve uniforms less six: near enough to a standard normal for a coefficient.
    pub fn coefficient(&mut self) -> f64 {
        self.many(12, 0.0, 1.0).iter().sum::<f64>() - 6.0
    }
}

pub fn uniform(low: f64, high: f64, n: usize) -> Vec<Distribution> {
    vec![Distribution::uniform(low, high).expect("a valid law"); n]
}

pub fn normal(n: usize) -> Vec<Distribution> {
    vec![Distribution::normal(0.0, 1.0).expect("a valid law"); n]
}

pub fn x(input: usize) -> Factor {
    of(input, |x| x)
}
