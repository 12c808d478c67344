//! Random parameters.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

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
}
