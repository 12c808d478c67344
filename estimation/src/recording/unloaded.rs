//! Readings without a force: a run's zero, and what its first reading is worth as one.

use ndarray::ArrayView1;

use crate::error_metrics::order_statistics::upper_median;
use crate::recording::Recording;

/// A force that is a smaller share of the run's largest is none.
const UNLOADED: f64 = 0.05;
/// A sensor that is lifted has less than this share of it, where it ever has: loads that come and go slowly are below the other for seconds.
const LIFTED: f64 = 0.01;
/// Share of their own deviation by which signals without a force may be away from a run's first reading where that is their zero. Beyond, taking it
/// off moves signals of another run by more than their offsets are likely to differ: an offset as large would be half of what they say.
const ZERO_SHARE: f64 = 0.5;
/// First readings that are taken off: that of the run which is learnt from and that of the one which is estimated.
const FIRST_READINGS: f64 = 2.0;

/// Whether every force is measured as none, or not measured, in a run's first rows, so many of them.
pub(crate) fn begins_unloaded(run: &Recording, start_rows: usize) -> bool {
    let most = largest_forces(run);
    run.forces
        .columns()
        .into_iter()
        .zip(most)
        .all(|(forces, most)| {
            let Some(first) = forces.iter().position(|force| force.is_finite()) else {
                return true;
            };
            // Of a force that isn't measured then, the first measurement.
            let begin = forces.iter().take(start_rows.max(first + 1));
            begin
                .filter(|force| force.is_finite())
                .all(|force| force.abs() <= UNLOADED * most)
        })
}

/// The signals without a force: their medians over rows whose forces are measured as none, or over all rows of a run without forces. `None` where no row is unloaded,
/// or a signal wasn't measured then.
pub fn zero(run: &Recording) -> Option<Vec<f64>> {
    let rows = unloaded_rows(run);
    let median = |signal: ArrayView1<'_, f64>| {
        let known = rows.iter().map(|row| signal[*row]);
        upper_median(known.filter(|x| x.is_finite()))
    };
    run.signals.columns().into_iter().map(median).collect()
}

/// Whether one run's first reading is its zero, and worth taking off: the signals come back to it without a force, as a motor's position doesn't, and it is nearer to
/// what they are then than that is to 0. A logger that has zeroed its signals leaves nothing to take off, and a noisy first sample would add its own error twice.
pub(crate) fn is_first_a_zero(run: &Recording, start_rows: usize) -> bool {
    let first = reading_at(run, 0, start_rows);
    begins_unloaded(run, start_rows) && comes_back(run, &first) && gains(run, &first)
}

/// The medians of so many readings of a run from a row on, one a signal.
pub(crate) fn reading_at(run: &Recording, row: usize, rows: usize) -> Vec<f64> {
    let readings = run.signals.rows().into_iter().skip(row).take(rows);
    let readings: Vec<Vec<f64>> = readings.map(|reading| reading.to_vec()).collect();
    median_reading(run.signals.ncols(), &readings)
}

/// The medians of readings, one a signal; of an even number the upper one.
pub(crate) fn median_reading(signals: usize, readings: &[Vec<f64>]) -> Vec<f64> {
    let median = |signal: usize| {
        let values = readings.iter().map(|reading| reading[signal]);
        upper_median(values.filter(|x| x.is_finite())).unwrap_or(f64::NAN)
    };
    (0..signals).map(median).collect()
}

pub(super) fn unloaded_rows(run: &Recording) -> Vec<usize> {
    let most = largest_forces(run);
    (0..run.rows())
        .filter(|row| is_unloaded(run, *row, &most))
        .collect()
}

/// The largest size of each force, N.
pub(crate) fn largest_forces(run: &Recording) -> Vec<f64> {
    let largest = |forces: ArrayView1<'_, f64>| {
        let known = forces.iter().filter(|force| force.is_finite());
        known.fold(0.0, |most: f64, force| most.max(force.abs()))
    };
    run.forces.columns().into_iter().map(largest).collect()
}

/// Whether every force of a row is measured as none beside the largest ones.
pub(crate) fn is_unloaded(run: &Recording, row: usize, most: &[f64]) -> bool {
    is_below(run, row, most, UNLOADED)
}

fn is_below(run: &Recording, row: usize, most: &[f64], share: f64) -> bool {
    let mut forces = run.forces.row(row).into_iter().zip(most);
    // A force that wasn't measured may be any.
    forces.all(|(force, most)| force.abs() <= share * most)
}

/// Stretches without a force after one with it: their first and last rows.
pub(crate) fn liftings(run: &Recording) -> Vec<(usize, usize)> {
    let lifted = liftings_below(run, LIFTED);
    // A noisy force sensor never reads as little.
    match lifted.is_empty() {
        true => liftings_below(run, UNLOADED),
        false => lifted,
    }
}

fn liftings_below(run: &Recording, share: f64) -> Vec<(usize, usize)> {
    let most = largest_forces(run);
    let mut found: Vec<(usize, usize)> = Vec::new();
    let mut was_loaded = false;
    let mut is_open = false;
    let measured = |row: &usize| run.forces.row(*row).iter().all(|force| force.is_finite());
    for row in (0..run.rows()).filter(measured) {
        let unloaded = is_below(run, row, &most, share);
        match found.last_mut() {
            Some((_, last)) if unloaded && is_open => *last = row,
            _ if unloaded && was_loaded => found.push((row, row)),
            _ => {}
        }
        is_open = unloaded && was_loaded;
        was_loaded |= !unloaded;
    }
    found
}

/// Whether most signals are near their first reading wherever no force acts.
fn comes_back(run: &Recording, first: &[f64]) -> bool {
    let unloaded = unloaded_rows(run);
    let share = |(signal, first): (ArrayView1<'_, f64>, &f64)| {
        let away = unloaded.iter().map(|row| (signal[*row] - first).powi(2));
        let away = (away.sum::<f64>() / unloaded.len().max(1) as f64).sqrt();
        // One that doesn't vary is at its first reading: 0 / 0 tells nothing.
        Some(away / signal.std(0.0)).filter(|share| share.is_finite())
    };
    let shares = run.signals.columns().into_iter().zip(first);
    let shares = shares.filter_map(share);
    upper_median(shares).is_none_or(|share| share <= ZERO_SHARE)
}

/// Whether the zero is further from 0, as another run's may be, than first readings are from the zero: median of the signals, each over its deviation, squared.
fn gains(run: &Recording, first: &[f64]) -> bool {
    let Some(zero) = zero(run) else {
        return true;
    };
    let square = |off: &dyn Fn(f64, f64) -> f64| {
        let columns = run
            .signals
            .columns()
            .into_iter()
            .zip(first.iter().zip(&zero));
        let squares = columns.filter_map(|(signal, (first, zero))| {
            let share = off(*first, *zero) / signal.std(0.0);
            Some(share * share).filter(|square| square.is_finite())
        });
        upper_median(squares).unwrap_or(0.0)
    };
    FIRST_READINGS * square(&|first, zero| first - zero) <= square(&|_, zero| zero)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::{Array2, array};

    fn run(signals: Array2<f64>, forces: Array2<f64>) -> Recording {
        Recording {
            name: "r".to_owned(),
            time_s: (0..signals.nrows()).map(|row| row as f64).collect(),
            signals,
            forces,
            cycle: None,
        }
    }

    #[test]
    fn the_zero_is_the_median_of_what_is_measured_without_a_force() {
        let nan = f64::NAN;
        let signals = array![[1.0, 5.0], [9.0, 9.0], [3.0, nan], [2.0, 7.0], [8.0, 8.0]];
        let forces = array![[0.0], [10.0], [0.4], [-0.5], [nan]];
        assert_eq!(zero(&run(signals.clone(), forces)), Some(vec![2.0, 7.0]));
        // Without forces it is that of all rows, and where all are loaded there is none.
        let without = run(signals.clone(), Array2::zeros((5, 0)));
        assert_eq!(zero(&without), Some(vec![3.0, 8.0]));
        let loaded = array![[10.0], [10.0], [9.0], [10.0], [9.0]];
        assert_eq!(zero(&run(signals, loaded)), None);
    }

    #[test]
    fn liftings_are_stretches_without_a_force_after_a_load() {
        let nan = f64::NAN;
        let forces = array![
            [0.0],
            [9.0],
            [0.1],
            [nan],
            [0.1],
            [0.4],
            [10.0],
            [nan],
            [8.0],
            [0.0]
        ];
        let made = run(Array2::zeros((10, 1)), forces);
        assert_eq!(liftings(&made), [(2, 4), (9, 9)]);
        // Never below a hundredth, but below a twentieth.
        let noisy = run(Array2::zeros((3, 1)), array![[9.0], [0.2], [0.3]]);
        assert_eq!(liftings(&noisy), [(1, 2)]);
        assert_eq!(
            liftings(&run(Array2::zeros((2, 1)), array![[0.0], [0.0]])),
            []
        );
    }

    #[test]
    fn a_first_reading_is_taken_off_where_the_zero_is_further_from_0() {
        // Loaded in every second row by a signal of 1; the first reading is off the zero by so much.
        let made = |zero: f64, off: f64| {
            let signals = Array2::from_shape_fn((41, 1), |(row, _)| match row {
                0 => zero + off,
                row => zero + (row % 2) as f64,
            });
            let forces = Array2::from_shape_fn((41, 1), |(row, _)| (row % 2) as f64 * 10.0);
            is_first_a_zero(&run(signals, forces), 1)
        };
        // 2 off^2 <= zero^2.
        assert!(made(0.2, 0.14) && !made(0.2, 0.15));
        // Zeroed by the logger.
        assert!(!made(0.0, 0.02) && made(0.3, 0.0));
    }
}
