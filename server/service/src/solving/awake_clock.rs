//! Time during which the program ran: while it is stopped, by a signal or a laptop's lid, no solve can go on.

use std::time::{Duration, Instant};

/// Longest time between two looks that counts: on a machine that is busy, many times what a look takes; what is longer was a stop.
const LONGEST: Duration = Duration::from_secs(1);

/// Clock that is looked at again and again, and counts what lies between two looks.
pub(super) struct AwakeClock {
    last: Instant,
    counted: Duration,
}

impl AwakeClock {
    /// Starts at nothing.
    pub(super) fn start() -> Self {
        Self {
            last: Instant::now(),
            counted: Duration::ZERO,
        }
    }

    /// Returns the time since its start, without the stops.
    pub(super) fn look(&mut self) -> Duration {
        self.look_at(Instant::now())
    }

    fn look_at(&mut self, now: Instant) -> Duration {
        self.counted += now.duration_since(self.last).min(LONGEST);
        self.last = now;
        self.counted
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stop_does_not_count() {
        let mut clock = AwakeClock::start();
        let begun = clock.last;
        let at = |ms: u64| begun + Duration::from_millis(ms);
        assert_eq!(clock.look_at(at(10)), Duration::from_millis(10));
        assert_eq!(clock.look_at(at(900)), Duration::from_millis(900));
        // Stopped for 18 s.
        assert_eq!(clock.look_at(at(18_900)), Duration::from_millis(1900));
        assert_eq!(clock.look_at(at(18_910)), Duration::from_millis(1910));
    }
}
