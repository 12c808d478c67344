//! Times of a study's solves, beside what was expected of them.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use placement::estimate::Pace;
use results::Estimate;

/// Told by whoever stores solves, asked by whoever tells what happens.
pub struct Timekeeper {
    begun: Instant,
    pace: Mutex<Option<Pace>>,
}

impl Timekeeper {
    /// Begins with a study that begins now; without a pace it says nothing.
    pub fn new(pace: Option<Pace>) -> Self {
        Self {
            begun: Instant::now(),
            pace: Mutex::new(pace),
        }
    }

    /// Returns what was expected at first.
    pub fn estimate(&self) -> Option<Estimate> {
        self.pace().as_ref().map(|pace| pace.estimate().clone())
    }

    /// Takes note of a solve.
    pub fn solved(&self, key: &str, wall_s: f64) {
        if let Some(pace) = self.pace().as_mut() {
            pace.solved(key, wall_s);
        }
    }

    /// Returns what is expected now, where that is far from what was said last.
    pub fn revised(&self) -> Option<Estimate> {
        let elapsed_s = self.begun.elapsed().as_secs_f64();
        self.pace().as_mut()?.revised(elapsed_s)
    }

    /// Sums are whole even when a thread panicked while it held them.
    fn pace(&self) -> MutexGuard<'_, Option<Pace>> {
        self.pace.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
