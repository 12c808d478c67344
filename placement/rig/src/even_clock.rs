//! Instants of a clock.

/// A clock of even intervals: instant k is at first + k / rate, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvenClock {
    first_s: f64,
    rate_hz: f64,
}

impl EvenClock {
    /// A clock with its first instant, s, and its rate, Hz.
    pub fn new(first_s: f64, rate_hz: f64) -> Self {
        Self { first_s, rate_hz }
    }

    /// Returns the time between two instants, s.
    pub fn interval_s(&self) -> f64 {
        self.rate_hz.recip()
    }

    /// All instants, s, without an end.
    pub(crate) fn times_s(self) -> impl Iterator<Item = f64> {
        // Divided, not multiplied: the instants of two clocks of one rate are the same to the bit.
        (0u64..).map(move |k| self.first_s + k as f64 / self.rate_hz)
    }

    /// Counts the instants before an end, s.
    pub(crate) fn instants_before(&self, end_s: f64) -> usize {
        let instants = ((end_s - self.first_s) * self.rate_hz).ceil();
        if instants > 0.0 { instants as usize } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instants_are_even() {
        let clock = EvenClock::new(0.5, 4.0);
        let times: Vec<f64> = clock.times_s().take(4).collect();
        assert_eq!(times, [0.5, 0.75, 1.0, 1.25]);
        assert_eq!(clock.instants_before(1.25), 3);
        assert_eq!(clock.instants_before(1.3), 4);
        assert_eq!(clock.instants_before(0.1), 0);
    }
}
