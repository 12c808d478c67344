//! An archive in memory, for runs that leave nothing behind.

use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

use fem_client::solver::{Cost, StartState};

use crate::points::archive::{Archive, ArchiveError, Outcome, PointRecord};

/// Forgets everything when it is dropped.
#[derive(Debug, Default)]
pub struct MemoryArchive {
    points: Mutex<HashMap<String, (Outcome, Cost)>>,
    starts: Mutex<HashMap<String, StartState>>,
}

impl Archive for MemoryArchive {
    fn load(
        &self,
        keys: &[String],
        _: usize,
    ) -> Result<Vec<Option<(Outcome, Cost)>>, ArchiveError> {
        let points = lock(&self.points);
        Ok(keys.iter().map(|key| points.get(key).cloned()).collect())
    }

    fn save(&self, point: &PointRecord<'_>) -> Result<(), ArchiveError> {
        let answer = || (point.outcome.clone(), point.cost);
        lock(&self.points)
            .entry(point.key.to_owned())
            .or_insert_with(answer);
        if let Some(start) = point.start {
            lock(&self.starts)
                .entry(point.key.to_owned())
                .or_insert_with(|| start.clone());
        }
        Ok(())
    }

    fn load_start(&self, key: &str) -> Result<Option<StartState>, ArchiveError> {
        Ok(lock(&self.starts).get(key).cloned())
    }
}

/// A map is whole even when a thread panicked while it was locked.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
