//! Instruments of another session: one run says nothing of how they read, so its left-out rows are moved as they may be.

use ndarray::ArrayView1;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::features::{GROUPS, VALUES, move_signals};
use crate::rows::{LabelledRows, range_of_sound};

/// Standard deviation of the offsets by which signals of left-out rows are moved where one run was recorded, as a share of their ranges: another
/// session's instruments read so far off at the best of times, and a force that hangs on small differences of large signals must show it.
pub const ANOTHER_SESSION: f64 = 0.005;

/// Session of other instruments: what they may add to signals.
pub(super) struct Session {
    /// Range of each signal.
    ranges: Vec<f64>,
    seed: u64,
}

impl Session {
    pub(super) fn new(rows: &LabelledRows, seed: u64) -> Self {
        let signals = rows.features.ncols() / GROUPS;
        let range = |column: ArrayView1<'_, f64>| {
            let (low, high) = range_of_sound(&column, &rows.suspect, VALUES);
            high - low
        };
        let columns = rows.features.columns();
        Self {
            ranges: columns.into_iter().take(signals).map(range).collect(),
            seed,
        }
    }

    /// Moves a row's signals. Each row meets a session of its own: an error over all rows is then that over as many sessions.
    pub(super) fn disturb(&self, row: usize, features: &mut [f64]) {
        let mut generator = ChaCha8Rng::seed_from_u64(self.seed);
        generator.set_stream(row as u64);
        // Drawn evenly from -root 3 to root 3: a variance of 1.
        let offset = |range: &f64| {
            ANOTHER_SESSION * range * generator.random_range(-3f64.sqrt()..3f64.sqrt())
        };
        move_signals(features, self.ranges.iter().map(offset));
    }
}

#[cfg(test)]
mod tests {
    use ndarray::Array2;

    use super::*;
    use crate::rows::suspect_rows::SuspectRow;
    use crate::split::Place;

    #[test]
    fn another_session_moves_values_and_means_alike() {
        // Two signals with ranges of 2 and 400.
        let ends = [[-1.0, 100.0], [1.0, 500.0]];
        let rows = LabelledRows {
            features: Array2::from_shape_fn((2, 2 * GROUPS), |(row, k)| ends[row][k % 2]),
            forces: vec![0.0, 1.0],
            places: vec![
                Place {
                    run: 0,
                    row: 0,
                    cycle: 0,
                    time_s: 0.0
                };
                2
            ],
            suspect: vec![SuspectRow::default(); 2],
        };
        let session = Session::new(&rows, 1);
        let moved = |row: usize| {
            let mut features = vec![0.0; 2 * GROUPS];
            session.disturb(row, &mut features);
            features
        };
        let [a, b, ..] = moved(7)[..] else {
            panic!("two signals")
        };
        assert_eq!(moved(7), [a, b, 0.0, 0.0, a, b, 0.0, 0.0, 0.0, 0.0]);
        assert_ne!(moved(8)[0], a);
        // Squares of evenly drawn numbers with variance 1 have a variance of 9/5 - 1: the mean of 4000 is known to 0.014, four of which are allowed.
        let square = |(moved, range): (f64, f64)| (moved / (0.005 * range)).powi(2);
        let squares: f64 = (0..2000)
            .map(moved)
            .map(|moved| square((moved[0], 2.0)) + square((moved[1], 400.0)))
            .sum();
        assert!((squares / 4000.0 - 1.0).abs() < 0.057, "{squares}");
    }
}
