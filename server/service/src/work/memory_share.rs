//! Memory that studies and fits share: each takes what it is expected to need, or waits until it is free.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// Bytes that are counted as one.
const UNIT: u64 = 1 << 20;

/// Memory, handed out in the order in which it is asked for.
#[derive(Debug)]
pub struct MemoryShare {
    units: u32,
    free: Arc<Semaphore>,
    waiting: AtomicUsize,
}

/// Memory that was taken, until this is dropped.
#[derive(Debug)]
pub(crate) struct TakenMemory {
    _units: OwnedSemaphorePermit,
}

impl MemoryShare {
    /// Shares so many bytes.
    pub fn new(bytes: u64) -> Self {
        let most = u32::try_from(Semaphore::MAX_PERMITS).unwrap_or(u32::MAX);
        let units = u32::try_from(bytes / UNIT).map_or(most, |units| units.clamp(1, most));
        Self {
            units,
            free: Arc::new(Semaphore::new(units as usize)),
            waiting: AtomicUsize::new(0),
        }
    }

    /// Waits until so many bytes are free, and takes them. More than there are counts as all: what asks for them was let in.
    pub(crate) async fn take(&self, bytes: u64) -> Option<TakenMemory> {
        let _waits = Waits::begin(&self.waiting);
        let taken = self.free.clone().acquire_many_owned(self.units_of(bytes));
        Some(TakenMemory {
            _units: taken.await.ok()?,
        })
    }

    /// Takes so many bytes where they are free now.
    pub(crate) fn try_take(&self, bytes: u64) -> Option<TakenMemory> {
        let taken = self
            .free
            .clone()
            .try_acquire_many_owned(self.units_of(bytes));
        Some(TakenMemory {
            _units: taken.ok()?,
        })
    }

    /// Whether anybody waits for memory.
    pub(crate) fn is_awaited(&self) -> bool {
        self.waiting.load(Ordering::Relaxed) > 0
    }

    fn units_of(&self, bytes: u64) -> u32 {
        u32::try_from(bytes.div_ceil(UNIT)).map_or(self.units, |units| units.min(self.units))
    }
}

/// Count of those that wait, of which this is one until it is dropped.
struct Waits<'a>(&'a AtomicUsize);

impl<'a> Waits<'a> {
    fn begin(count: &'a AtomicUsize) -> Self {
        count.fetch_add(1, Ordering::Relaxed);
        Self(count)
    }
}

impl Drop for Waits<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[tokio::test]
    async fn two_that_fit_have_it_at_once_and_a_third_waits_for_its_turn() {
        let share = Arc::new(MemoryShare::new(100 * UNIT));
        let study = share.take(60 * UNIT).await.expect("is free");
        let fit = share.try_take(40 * UNIT).expect("is free");
        assert!(share.try_take(UNIT).is_none() && !share.is_awaited());
        let third = tokio::spawn({
            let share = share.clone();
            // More than there is: it has all of it.
            async move { share.take(u64::MAX).await.map(drop) }
        });
        while !share.is_awaited() {
            tokio::time::sleep(Duration::from_millis(1)).await;
        }
        drop(study);
        assert!(!third.is_finished() && share.is_awaited());
        drop(fit);
        assert!(third.await.expect("ends").is_some());
        assert!(!share.is_awaited() && share.try_take(100 * UNIT).is_some());
    }
}
