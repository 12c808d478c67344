//! Recordings: signals, and forces where they were measured, over time.
//!
//! - [`csv_line`]: the cells of a line
//! - [`named_columns`]: which columns of a file are meant
//! - [`csv_recording`]: a recording from its text
//! - [`recording_fault`]: what can be wrong with it

pub mod csv_line;
pub mod csv_recording;
pub mod named_columns;
pub mod recording_fault;

use ndarray::Array2;

/// One run: rows in the order of time.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// Its file, for people.
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
    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.time_s.len()
    }

    /// Median interval between rows, s; none with fewer than two rows.
    pub fn interval_s(&self) -> Option<f64> {
        median(self.time_s.windows(2).map(|pair| pair[1] - pair[0]))
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

/// The median of finite numbers, the upper of two in the middle; none of none.
pub fn median(numbers: impl Iterator<Item = f64>) -> Option<f64> {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied()
}
