//! Samples of a recording that are hardly measurements: those that stand alone, and those far beyond all others of their column.

use super::column_figures::measured;
use super::lone_samples::lone_samples;
use crate::recording::Recording;

/// Ranges of a column's other samples by which a far one is beyond them: few rows say nothing of a load so far from all others.
const FAR_RANGES: f64 = 5.0;
/// Samples at either end that may be far, at least, and as one of so many.
const FEWEST_FAR: usize = 2;
const ONE_FAR_OF: usize = 1000;
/// Fewer samples tell no range.
const FEWEST_SAMPLES: usize = 20;

/// Column that is measured, by its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum MeasuredColumn {
    /// A signal.
    Signal(usize),
    /// A force.
    Force(usize),
}

/// Sample that is hardly a measurement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SuspectSample {
    /// Row of the recording.
    pub row: usize,
    /// Column of the sample.
    pub column: MeasuredColumn,
    /// Value, in the column's unit.
    pub value: f64,
    /// Times of the measured samples before and after it in its column, s: what is interpolated between them holds it. Infinite at the ends.
    pub between_s: (f64, f64),
}

/// Suspect samples of a run, in the order of rows. What signals and forces show in one row has happened, and isn't suspect.
pub fn suspect_samples(run: &Recording) -> Vec<SuspectSample> {
    let signals = run.signals.columns().into_iter().enumerate();
    let signals = signals.map(|(number, values)| (MeasuredColumn::Signal(number), values));
    let forces = run.forces.columns().into_iter().enumerate();
    let forces = forces.map(|(number, values)| (MeasuredColumn::Force(number), values));
    let of_columns = signals.chain(forces).flat_map(|(column, values)| {
        let values = values.to_vec();
        let rows = suspects_of(&values);
        let sample = |row: usize| sample(run, column, &values, row);
        rows.into_iter().filter_map(sample).collect::<Vec<_>>()
    });
    let mut found: Vec<SuspectSample> = of_columns.collect();
    found.sort_by_key(|sample| (sample.row, sample.column));
    let rows = found.chunk_by(|a, b| a.row == b.row);
    let is_seen_by_both = |samples: &&[SuspectSample]| {
        let is_force = |sample: &SuspectSample| matches!(sample.column, MeasuredColumn::Force(_));
        samples.iter().any(is_force) && !samples.iter().all(is_force)
    };
    let suspect = rows.filter(|samples| !is_seen_by_both(samples));
    suspect.flatten().copied().collect()
}

fn sample(
    run: &Recording,
    column: MeasuredColumn,
    values: &[f64],
    row: usize,
) -> Option<SuspectSample> {
    let time_of = |(row, _): (usize, &f64)| run.time_s.get(row).copied();
    let is_measured = |(_, value): &(usize, &f64)| value.is_finite();
    let (before, after) = values.split_at_checked(row)?;
    let mut before = before.iter().enumerate().rev().filter(is_measured);
    let after = after.iter().enumerate().skip(1).filter(is_measured);
    let mut after = after.map(|(later, value)| (row + later, value));
    Some(SuspectSample {
        row,
        column,
        value: values.get(row).copied()?,
        between_s: (
            before.next().and_then(time_of).unwrap_or(f64::NEG_INFINITY),
            after.next().and_then(time_of).unwrap_or(f64::INFINITY),
        ),
    })
}

/// Rows of a column whose samples are suspect, rising.
fn suspects_of(values: &[f64]) -> Vec<usize> {
    let mut found = [lone_samples(values), far_samples(values)].concat();
    found.sort_unstable();
    found.dedup();
    found
}

/// Rows whose samples are far beyond all others, which are all but a few at either end. None of a column that rests but for these few.
fn far_samples(values: &[f64]) -> Vec<usize> {
    let mut numbers: Vec<f64> = measured(values).map(|(_, value)| value).collect();
    let few = FEWEST_FAR.max(numbers.len() / ONE_FAR_OF);
    if numbers.len() < FEWEST_SAMPLES {
        return Vec::new();
    }
    let last = numbers.len() - 1 - few;
    let low = *numbers.select_nth_unstable_by(few, f64::total_cmp).1;
    let high = *numbers.select_nth_unstable_by(last, f64::total_cmp).1;
    let reach = FAR_RANGES * (high - low);
    let is_far =
        |(_, value): &(usize, f64)| reach > 0.0 && !(low - reach..=high + reach).contains(value);
    let far = measured(values).filter(is_far);
    far.map(|(row, _)| row).collect()
}

#[cfg(test)]
mod tests {
    use ndarray::Array2;

    use super::*;

    /// Runs of 200 rows: two signals and a force, all waves from -1 to 1.
    fn run() -> Recording {
        let wave = |row: usize| (0.1 * row as f64).sin();
        Recording {
            name: "r".to_owned(),
            time_s: (0..200).map(f64::from).collect(),
            signals: Array2::from_shape_fn((200, 2), |(row, _)| wave(row)),
            forces: Array2::from_shape_fn((200, 1), |(row, _)| wave(row)),
            cycle: None,
        }
    }

    fn found(run: &Recording) -> Vec<(usize, MeasuredColumn)> {
        let samples = suspect_samples(run).into_iter();
        samples.map(|sample| (sample.row, sample.column)).collect()
    }

    #[test]
    fn spikes_of_one_row_and_far_ones_of_two_are_suspect() {
        use MeasuredColumn::{Force, Signal};
        let mut run = run();
        assert!(suspect_samples(&run).is_empty());
        // Away by less than the range, but alone.
        run.signals[[30, 1]] += 4.0;
        // Two rows, and the first and the last, which nothing stands before or after.
        for (row, x) in [(60, 50.0), (61, 40.0), (0, -30.0), (199, -40.0)] {
            run.signals[[row, 0]] = x;
        }
        run.forces[[90, 0]] = -1000.0;
        let expected = [
            (0, Signal(0)),
            (30, Signal(1)),
            (60, Signal(0)),
            (61, Signal(0)),
            (90, Force(0)),
            (199, Signal(0)),
        ];
        assert_eq!(found(&run), expected);
        let samples = suspect_samples(&run);
        assert_eq!(samples[0].between_s, (f64::NEG_INFINITY, 1.0));
        assert_eq!(
            (samples[1].value, samples[1].between_s),
            (run.signals[[30, 1]], (29.0, 31.0))
        );
    }

    #[test]
    fn what_signals_and_forces_show_together_has_happened() {
        let mut run = run();
        run.signals[[30, 0]] = 80.0;
        run.forces[[30, 0]] = 900.0;
        assert!(suspect_samples(&run).is_empty());
        run.forces[[30, 0]] = 0.0;
        assert_eq!(found(&run), [(30, MeasuredColumn::Signal(0))]);
    }

    #[test]
    fn what_is_five_ranges_away_at_most_or_lasts_is_not_far() {
        let line = |far: &[(usize, f64)]| {
            let mut values: Vec<f64> = (0..101).map(|row| f64::from(row) / 100.0).collect();
            far.iter().for_each(|(row, x)| values[*row] = *x);
            far_samples(&values)
        };
        // Without two at either end the others go from 0.02 to 0.98: the reach is 4.8.
        assert_eq!(line(&[(100, 5.79)]), [100]);
        assert!(line(&[(100, 5.77)]).is_empty());
        assert!(line(&[(100, 99.0), (99, 99.0), (98, 99.0)]).is_empty());
        // A column that rests but for two rows.
        let mut rests = vec![0.0; 100];
        rests[50] = 9.0;
        assert!(far_samples(&rests).is_empty());
    }
}
