//! Rows that suspect samples are in, themselves or by a window of their features.

use ndarray::Array2;

use crate::features::{GROUPS, StreamSettings, features};
use crate::recording::Recording;
use crate::recording::look::suspect_samples::{MeasuredColumn, SuspectSample};

/// Places of suspect samples in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SuspectRow {
    /// Whether one of its readings is.
    pub reading: bool,
    /// Whether the windows of its features hold one, group by group.
    pub groups: [bool; GROUPS],
    /// Whether its force is.
    pub force: bool,
}

impl SuspectRow {
    /// Whether the row itself is suspect, by a reading or its force.
    pub(crate) fn is_suspect(&self) -> bool {
        self.reading || self.force
    }
}

/// Marks the rows of a run, as recorded or on a clock, whose readings are suspect, or interpolated from suspect ones; and each force's rows, rows x forces.
pub(crate) fn suspect_rows(
    run: &Recording,
    samples: &[SuspectSample],
    settings: &StreamSettings,
) -> (Vec<SuspectRow>, Array2<bool>) {
    let mut forces = Array2::from_elem(run.forces.raw_dim(), false);
    let mut readings = vec![false; run.rows()];
    for sample in samples {
        let (before, after) = sample.between_s;
        let first = run.time_s.partition_point(|time| *time <= before);
        let end = run.time_s.partition_point(|time| *time < after);
        for row in first..end {
            let mark = match sample.column {
                MeasuredColumn::Signal(_) => readings.get_mut(row),
                MeasuredColumn::Force(force) => forces.get_mut((row, force)),
            };
            if let Some(mark) = mark {
                *mark = true;
            }
        }
    }
    if !readings.contains(&true) {
        return (vec![SuspectRow::default(); run.rows()], forces);
    }
    // Features of a signal that is 1 where a reading is suspect and else 0: those that aren't 0 have one in their window.
    let mut signals = Array2::zeros((run.rows(), 1));
    for (place, reading) in signals.iter_mut().zip(&readings) {
        *place = f64::from(u8::from(*reading));
    }
    let indicator = Recording {
        name: String::new(),
        time_s: run.time_s.clone(),
        signals,
        forces: Array2::zeros((run.rows(), 0)),
        cycle: run.cycle.clone(),
    };
    let settings = StreamSettings {
        subtract_start: false,
        ..settings.clone()
    };
    let held = features(&indicator, &settings, None);
    let rows = readings.iter().zip(held.rows()).map(|(reading, held)| {
        let mut groups = [false; GROUPS];
        for (group, held) in groups.iter_mut().zip(held) {
            *group = *held != 0.0;
        }
        SuspectRow {
            reading: *reading,
            groups,
            force: false,
        }
    });
    (rows.collect(), forces)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(row: usize, column: MeasuredColumn, between_s: (f64, f64)) -> SuspectSample {
        SuspectSample {
            row,
            column,
            value: 9.0,
            between_s,
        }
    }

    #[test]
    fn windows_hold_a_suspect_reading_until_they_have_moved_on() {
        let run = Recording {
            name: "r".to_owned(),
            time_s: (0..20).map(f64::from).collect(),
            signals: Array2::zeros((20, 1)),
            forces: Array2::zeros((20, 2)),
            cycle: None,
        };
        let settings = StreamSettings {
            subtract_start: true,
            start_rows: 1,
            turn_sign: true,
            smooth_rows: 2,
            window_rows: 3,
            baseline_s: Some(3.0),
            pause_s: 5.0,
        };
        let samples = [
            sample(4, MeasuredColumn::Signal(0), (3.0, 5.0)),
            sample(8, MeasuredColumn::Force(1), (6.0, 10.0)),
        ];
        let (rows, forces) = suspect_rows(&run, &samples, &settings);
        let of_group = |group: usize| -> Vec<usize> {
            (0..20).filter(|row| rows[*row].groups[group]).collect()
        };
        // The value of the last two readings; the slope of two values; the mean of the last three.
        assert_eq!(of_group(0), [4, 5]);
        // Values 1/2, 1/2: the slope between them is 0, and the spike is in neither difference.
        assert_eq!(of_group(1), [4, 6]);
        assert_eq!(of_group(2), [4, 5, 6, 7]);
        // The median of four values isn't moved by two of them.
        assert_eq!(of_group(4), [4, 5]);
        let readings: Vec<usize> = (0..20).filter(|row| rows[*row].reading).collect();
        assert_eq!(readings, [4]);
        let labels: Vec<usize> = (0..20).filter(|row| forces[[*row, 1]]).collect();
        assert_eq!(labels, [7, 8, 9]);
        assert!(!forces.column(0).iter().any(|force| *force));
    }
}
