//! Watch over the times of a stream's rows.

use std::collections::VecDeque;

use crate::estimator::Estimator;
use crate::live::row_state::RowState;
use crate::recording::csv_recording::SHORTEST_S;
use crate::recording::typical_interval;
use crate::rows::RATE_FACTOR;

/// Rows whose typical interval tells a stream's rate.
pub const RATE_ROWS: usize = 50;
/// A row nearer to the one before than this share of the typical interval is no row of its own: ten times the rate that was learnt.
const SOONEST: f64 = 0.1;
/// Most ticks of a clock between two rows: ten minutes of a fast rig. Rows further apart are apart, whatever the pause.
pub const MOST_TICKS: f64 = 1e6;
/// Late rows in rising order after which it is the clock that was set back.
const LATE_ROWS: usize = 3;

/// Watch over the times of a stream's rows.
#[derive(Debug, Clone)]
pub struct RowWatch {
    pause_s: f64,
    /// Typical intervals that were learnt from, s: least and greatest; none where a clock makes all rates one.
    learnt_s: Option<(f64, f64)>,
    last_s: Option<f64>,
    /// Late rows in rising order since the last one in time: how many, and the time of the last one, s.
    late: (usize, f64),
    /// The last intervals, s.
    intervals: VecDeque<f64>,
}

impl RowWatch {
    /// Begins before the first row.
    pub fn new(estimator: &Estimator) -> Self {
        let stream = &estimator.stream;
        Self {
            pause_s: stream.rate_hz.map_or(stream.pause_s, |rate_hz| {
                stream.pause_s.min(MOST_TICKS / rate_hz)
            }),
            learnt_s: stream.rate_hz.is_none().then_some(estimator.interval_s),
            last_s: None,
            late: (0, f64::NEG_INFINITY),
            intervals: VecDeque::new(),
        }
    }

    /// A longer time between rows is a pause, s.
    pub fn pause_s(&self) -> f64 {
        self.pause_s
    }

    /// Returns the state of the next row by its time, s. A row that isn't estimated from leaves no trace but that of late ones.
    pub fn state(&mut self, time_s: f64) -> RowState {
        let step = match self.last_s {
            None => return self.begun(time_s, RowState::Ok),
            Some(last) => time_s - last,
        };
        if step > self.pause_s {
            return self.begun(time_s, RowState::Gap);
        }
        if step <= -SHORTEST_S {
            let (rows, before) = self.late;
            let rows = if time_s > before { rows + 1 } else { 1 };
            self.late = (rows, time_s);
            return match rows >= LATE_ROWS || -step > self.pause_s {
                true => self.begun(time_s, RowState::ClockReset),
                false => RowState::Late,
            };
        }
        if step < SHORTEST_S {
            return RowState::Duplicate;
        }
        if self
            .learnt_s
            .is_some_and(|(least, _)| step < SOONEST * least)
        {
            return RowState::Early;
        }
        self.late = (0, f64::NEG_INFINITY);
        self.last_s = Some(time_s);
        self.intervals.push_back(step);
        if self.intervals.len() > RATE_ROWS {
            self.intervals.pop_front();
        }
        match self.has_other_rate() {
            true => RowState::Rate,
            false => RowState::Ok,
        }
    }

    fn begun(&mut self, time_s: f64, state: RowState) -> RowState {
        self.late = (0, f64::NEG_INFINITY);
        self.last_s = Some(time_s);
        self.intervals.clear();
        state
    }

    fn has_other_rate(&mut self) -> bool {
        let Some((least, greatest)) = self.learnt_s.filter(|_| self.intervals.len() == RATE_ROWS)
        else {
            return false;
        };
        let found = typical_interval(self.intervals.make_contiguous());
        found.is_some_and(|found| is_other_rate(found, (least, greatest)))
    }
}

/// Whether a typical interval is that of another rate than those which were learnt, s: least and greatest.
pub fn is_other_rate(interval_s: f64, (least, greatest): (f64, f64)) -> bool {
    interval_s * RATE_FACTOR < least || interval_s > greatest * RATE_FACTOR
}

#[cfg(test)]
mod tests {
    use super::*;

    fn watch() -> RowWatch {
        RowWatch {
            pause_s: 1.0,
            learnt_s: Some((0.1, 0.1)),
            last_s: None,
            late: (0, f64::NEG_INFINITY),
            intervals: VecDeque::new(),
        }
    }

    fn states(times: &[f64]) -> Vec<&'static str> {
        let mut watch = watch();
        times.iter().map(|t| watch.state(*t).as_str()).collect()
    }

    #[test]
    fn times_that_do_not_go_on_are_named() {
        assert_eq!(
            states(&[0.0, 0.1, 0.1, 0.2, 0.15, 0.3, 0.301, 0.4, 2.0, 2.1]),
            [
                "ok",
                "ok",
                "duplicate",
                "ok",
                "late",
                "ok",
                "early",
                "ok",
                "gap",
                "ok"
            ]
        );
    }

    #[test]
    fn a_clock_that_was_set_back_is_followed() {
        assert_eq!(
            states(&[100.0, 100.1, 0.0, 0.1]),
            ["ok", "ok", "clock-reset", "ok"]
        );
        // By less than a pause it takes three rows that rise; two that were exchanged don't.
        assert_eq!(
            states(&[0.5, 0.6, 0.7, 0.2, 0.3, 0.4, 0.5]),
            ["ok", "ok", "ok", "late", "late", "clock-reset", "ok"]
        );
        assert_eq!(
            states(&[0.0, 0.1, 0.4, 0.2, 0.3, 0.5]),
            ["ok", "ok", "ok", "late", "late", "ok"]
        );
        // One wrong time ahead costs no more than two begins.
        assert_eq!(
            states(&[0.0, 0.1, 1e9, 0.2, 0.3]),
            ["ok", "ok", "gap", "clock-reset", "ok"]
        );
    }

    #[test]
    fn another_rate_is_named_once_fifty_rows_tell_it_and_as_long_as_it_lasts() {
        let mut watch = watch();
        let slow = (0..80).map(|k| watch.state(0.2 * f64::from(k)));
        let slow: Vec<bool> = slow.map(|state| state == RowState::Rate).collect();
        assert_eq!(slow.iter().position(|is| *is), Some(50));
        assert!(slow[50..].iter().all(|is| *is));
        let right = (1..100).map(|k| watch.state(15.8 + 0.1 * f64::from(k)));
        let right: Vec<bool> = right.map(|state| state == RowState::Rate).collect();
        assert!(right[0] && right[50..].iter().all(|is| !*is));
        // A clock of its own makes all rates one.
        watch.learnt_s = None;
        assert!((1..100).all(|k| watch.state(40.0 + 0.3 * f64::from(k)) != RowState::Rate));
    }
}
