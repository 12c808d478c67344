//! Estimates of rows beside their true forces, and what is said of them together.

use estimation::estimator::{Estimate, is_outside};
use estimation::features::GROUPS;
use results::film::force_error::{TrialError, WorstContact};

use crate::force_error::learnt_force::LearntForce;
use crate::force_error::thinned_run::ThinnedRun;

/// Width of the parts of the wheel whose contacts are told apart, degrees.
const CONTACT_DEG: f64 = 5.0;
/// Errors of fewer rows of a part say little of it.
const FEWEST_ROWS: usize = 20;

/// A true force with its estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TriedRow {
    truth: f64,
    estimate: Estimate,
    /// Whether a signal is beyond what was learnt from.
    outside: bool,
}

impl TriedRow {
    /// A row of a run, estimated.
    pub fn of(learnt: &LearntForce, run: &ThinnedRun, axis: usize, row: usize) -> Self {
        let features = run.features.row(row);
        let films = features.len() / GROUPS;
        let features = features.to_vec();
        Self {
            truth: run.true_force_n[[row, axis]],
            estimate: learnt.model.estimate(&features),
            outside: is_outside(&features[..films], &learnt.ranges),
        }
    }

    /// The estimate's error, squared, N^2.
    pub fn square(&self) -> f64 {
        let error = self.estimate.force - self.truth;
        error * error
    }

    fn is_covered(&self) -> bool {
        (self.estimate.low..=self.estimate.high).contains(&self.truth)
    }
}

/// Every row of these runs, estimated.
pub fn tried(learnt: &LearntForce, runs: &[ThinnedRun], axis: usize) -> Vec<TriedRow> {
    let rows = rows_of(runs);
    rows.map(|(run, row)| TriedRow::of(learnt, run, axis, row))
        .collect()
}

/// The error of these rows together.
pub fn error_of(rows: &[TriedRow]) -> TrialError {
    if rows.is_empty() {
        return TrialError::default();
    }
    let (truth, estimates): (Vec<f64>, Vec<f64>) = rows
        .iter()
        .map(|row| (row.truth, row.estimate.force))
        .unzip();
    let share = |is: fn(&TriedRow) -> bool| {
        let count = rows.iter().filter(|row| is(row)).count();
        count as f64 / rows.len() as f64
    };
    TrialError::of(
        &truth,
        &estimates,
        share(TriedRow::is_covered),
        share(|row| row.outside),
    )
}

/// Returns the rows of these runs, in order, where the ground is touched.
pub fn in_contact(runs: &[ThinnedRun], rows: &[TriedRow]) -> Vec<TriedRow> {
    let touching = rows_of(runs).zip(rows);
    let touching = touching.filter(|((run, row), _)| run.touches(*row));
    touching.map(|(_, tried)| *tried).collect()
}

/// The part of the wheel between two angles whose contacts are known worst, of these runs and their rows, in order.
pub fn worst_contact(
    runs: &[ThinnedRun],
    rows: &[TriedRow],
    [from, to]: [f64; 2],
) -> Option<WorstContact> {
    let parts = (((to - from) / CONTACT_DEG).ceil() as usize).max(1);
    let mut squares = vec![(0.0, 0usize); parts];
    for ((run, row), tried) in rows_of(runs).zip(rows) {
        if run.touches(row) {
            let part = ((run.contact_deg[row] - from) / CONTACT_DEG) as usize;
            let (sum, count) = &mut squares[part.min(parts - 1)];
            *sum += tried.square();
            *count += 1;
        }
    }
    let known = squares
        .iter()
        .enumerate()
        .filter(|(_, (_, count))| *count >= FEWEST_ROWS);
    let errors = known.map(|(part, (sum, count))| {
        let begin = from + part as f64 * CONTACT_DEG;
        WorstContact {
            deg: 0.5 * (begin + (begin + CONTACT_DEG).min(to)),
            rmse_n: (sum / *count as f64).sqrt(),
        }
    });
    let worst = errors.max_by(|a, b| a.rmse_n.total_cmp(&b.rmse_n));
    worst.filter(|worst| worst.rmse_n.is_finite())
}

fn rows_of(runs: &[ThinnedRun]) -> impl Iterator<Item = (&ThinnedRun, usize)> {
    runs.iter()
        .flat_map(|run| (0..run.time_s.len()).map(move |row| (run, row)))
}
