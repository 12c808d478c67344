//! Recordings: signals, and forces where they were measured, over time.
//!
//! - `csv_line`: the cells of a line; [`row_reader`]: the rows of lines
//! - [`dialect`]: files as loggers write them, in the form that is read
//! - [`named_columns`]: which columns of a file are meant
//! - [`csv_recording`]: a recording from its text
//! - [`recording_fault`]: what can be wrong with it
//! - [`repeated_rows`]: rows that stand in two of them; [`suspect_signals`]: columns that are no sensors
//! - [`time_column`]: times that are no seconds, `time_text`: dates and clocks; `force_unit`: forces that are no newtons; `unit_of_name`: what a name says of it
//! - [`unloaded`]: readings without a force; [`look`]: what stands in the columns

mod csv_line;
pub mod csv_recording;
pub mod dialect;
mod force_unit;
pub mod look;
pub mod named_columns;
pub mod recording_fault;
pub mod repeated_rows;
pub mod row_reader;
pub mod suspect_signals;
pub mod time_column;
mod time_text;
mod unit_of_name;
pub mod unloaded;

use ndarray::Array2;

use crate::error_metrics::order_statistics::upper_median;

/// A run: rows in the order of time.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// File of the recording, for people.
    pub name: String,
    /// Times of the rows, s, rising.
    pub time_s: Vec<f64>,
    /// Rows x signals; NaN where a signal wasn't measured.
    pub signals: Array2<f64>,
    /// Rows x forces, N; NaN where a force wasn't measured.
    pub forces: Array2<f64>,
    /// Number of each row's cycle, where the file has a column of them: 0 first, one more with each change.
    pub cycle: Option<Vec<usize>>,
}

impl Recording {
    /// Counts the rows.
    pub fn rows(&self) -> usize {
        self.time_s.len()
    }

    /// Typical interval between rows, s; none with fewer than two rows.
    pub fn interval_s(&self) -> Option<f64> {
        let intervals: Vec<f64> = self
            .time_s
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .collect();
        typical_interval(&intervals)
    }

    /// Rows with at least one force.
    pub fn labelled(&self) -> usize {
        let measured = |row: ndarray::ArrayView1<'_, f64>| row.iter().any(|x| x.is_finite());
        self.forces
            .rows()
            .into_iter()
            .filter(|row| measured(*row))
            .count()
    }
}

/// Intervals longer than so many medians are pauses.
pub const PAUSE_INTERVALS: f64 = 10.0;

/// The mean of intervals, pauses apart. A clock that jitters between two intervals has a median that is now the one, now the other; its mean stays. None of
/// none.
pub fn typical_interval(intervals: &[f64]) -> Option<f64> {
    let longest = PAUSE_INTERVALS * upper_median(intervals.iter().copied())?;
    let regular = || intervals.iter().filter(|interval| **interval <= longest);
    Some(regular().sum::<f64>() / regular().count() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rate_is_steady_though_its_clock_jitters() {
        let jitter: Vec<f64> = (0..99)
            .map(|k| if k % 2 == 0 { 0.07 } else { 0.14 })
            .collect();
        let mut with_pause = jitter.clone();
        with_pause.extend([0.14, 0.14, 30.0]);
        let (first, second) = (typical_interval(&jitter), typical_interval(&with_pause));
        assert!((first.expect("intervals") - 0.105).abs() < 0.001);
        assert!((second.expect("intervals") - 0.105).abs() < 0.002);
        // Their medians are 0.07 and 0.14.
        assert_eq!(upper_median(jitter), Some(0.07));
        assert_eq!(upper_median(with_pause), Some(0.14));
        assert_eq!(typical_interval(&[]), None);
    }
}
