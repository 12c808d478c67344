//! Hears how far a point's solve is, and tells it now and then.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Instant;

use fem_client::solver::{SolveProgress, Watch};

use crate::points::run_event::{Event, Observer};

/// A solve is told of when it has taken so long, and as often, ms: what ends before is told when it has.
const EVERY_MS: u64 = 200;

/// Watches the solve of one point.
pub(super) struct PointWatch<'r> {
    stop: &'r AtomicBool,
    observer: Observer<'r>,
    ordinal: usize,
    begun: Instant,
    next_ms: AtomicU64,
}

impl<'r> PointWatch<'r> {
    /// Watches the point with this ordinal, whose solve begins now.
    pub(super) fn new(stop: &'r AtomicBool, observer: Observer<'r>, ordinal: usize) -> Self {
        Self {
            stop,
            observer,
            ordinal,
            begun: Instant::now(),
            next_ms: AtomicU64::new(EVERY_MS),
        }
    }
}

impl Watch for PointWatch<'_> {
    fn is_stopped(&self) -> bool {
        self.stop.is_stopped()
    }

    fn tell(&self, progress: SolveProgress) {
        let now_ms = u64::try_from(self.begun.elapsed().as_millis()).unwrap_or(u64::MAX);
        if now_ms < self.next_ms.load(Ordering::Relaxed) {
            return;
        }
        self.next_ms
            .store(now_ms.saturating_add(EVERY_MS), Ordering::Relaxed);
        (self.observer)(Event::Solving {
            ordinal: self.ordinal,
            progress,
        });
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;
    use std::time::Duration;

    use fem_client::solver::Stage;

    use super::*;

    #[test]
    fn a_solve_is_told_of_after_a_while_and_not_at_every_iteration() {
        let (stop, told) = (AtomicBool::new(false), Mutex::new(Vec::new()));
        let observer = |event| told.lock().expect("no panic").push(event);
        let watch = PointWatch::new(&stop, &observer, 7);
        let count = || told.lock().expect("no panic").len();
        while count() < 2 {
            watch.tell(SolveProgress {
                stage: Stage::Pressing,
                share: 0.5,
                iterations: 3,
                residual: Some(1e-3),
            });
        }
        assert!(watch.begun.elapsed() >= Duration::from_millis(2 * EVERY_MS));
        let told = told.lock().expect("no panic");
        assert!(matches!(told[0], Event::Solving { ordinal: 7, .. }));
        stop.store(true, Ordering::Relaxed);
        assert!(watch.is_stopped());
    }
}
