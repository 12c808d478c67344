//! Errors that another run may have, from what left-out runs were.
//!
//! A left-out run's error has two parts: what is left once its own zero and gain are known, which its rows tell, and what its zero and gain add. Of the second a run is
//! one draw, however many rows it has: gains that differ between runs make all its rows too large, or too small. With draws that are normal, the square of a new one
//! over the mean of n earlier squares is distributed as Student's t squared, of n - 1 degrees of freedom: leaving out one of n runs compares it with the n - 1 others.

use std::collections::BTreeMap;

use statrs::distribution::{ContinuousCDF, StudentsT};

use crate::error_metrics::left_out::LeftOut;

/// Residuals of one run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RunResiduals {
    /// Measured less estimated forces, over each row's unit.
    pub whole: Vec<f64>,
    /// Residuals once the run's own zero and gain are taken from its rows, by least squares.
    pub within: Vec<f64>,
}

/// Residuals of each left-out run, each row's over its unit, in the order of the runs' numbers.
pub(crate) fn residuals_of_runs(
    left_out: &[LeftOut],
    unit: impl Fn(&LeftOut) -> f64,
) -> Vec<RunResiduals> {
    let mut runs: BTreeMap<usize, Vec<&LeftOut>> = BTreeMap::new();
    for row in left_out {
        runs.entry(row.group).or_default().push(row);
    }
    let of_run = |rows: Vec<&LeftOut>| {
        let (zero, gain) = line(&rows);
        let residual = |of: &dyn Fn(&LeftOut) -> f64| -> Vec<f64> {
            rows.iter()
                .map(|row| (row.truth - of(row)) / unit(row))
                .collect()
        };
        RunResiduals {
            whole: residual(&|row| row.mean),
            within: residual(&|row| zero + gain * row.mean),
        }
    };
    runs.into_values().map(of_run).collect()
}

/// Zero and gain of the truth over the estimates, by least squares; the gain is 1 where estimates stand still.
fn line(rows: &[&LeftOut]) -> (f64, f64) {
    let count = rows.len().max(1) as f64;
    let mean = |of: fn(&LeftOut) -> f64| rows.iter().map(|row| of(row)).sum::<f64>() / count;
    let (estimate, truth) = (mean(|row| row.mean), mean(|row| row.truth));
    let products = |of: fn(&LeftOut) -> f64, about: f64| -> f64 {
        let product = |row: &&LeftOut| (of(row) - about) * (row.mean - estimate);
        rows.iter().map(product).sum()
    };
    let squares = products(|row| row.mean, estimate);
    let gain = match products(|row| row.truth, truth) / squares {
        gain if gain.is_finite() => gain,
        _ => 1.0,
    };
    (truth - gain * estimate, gain)
}

/// Size that `share` of new runs stay below, of sizes of the left-out runs: `(whole, within)` of each. None of no run.
///
/// A new run is learnt from one run more than each left-out one, which its part between runs gains by: (1 + 1/n) over (1 + 1/(n - 1)).
pub(crate) fn next_run(sizes: &[(f64, f64)], share: f64) -> Option<f64> {
    let count = sizes.len();
    let freedom = count.checked_sub(1)?.max(1) as f64;
    let student = StudentsT::new(0.0, 1.0, freedom).ok()?;
    let quantile = student.inverse_cdf(0.5 + 0.5 * share).powi(2);
    let n = count as f64;
    let gained = if count > 1 {
        (1.0 + 1.0 / n) / (1.0 + 1.0 / (n - 1.0))
    } else {
        1.0
    };
    let mean = |of: &dyn Fn(f64, f64) -> f64| {
        sizes
            .iter()
            .map(|(whole, within)| of(*whole, *within))
            .sum::<f64>()
            / n
    };
    let within = mean(&|_, within| within * within);
    let between = mean(&|whole, within| (whole * whole - within * within).max(0.0));
    let found = (within + quantile * gained * between).sqrt();
    found.is_finite().then_some(found)
}

/// Share of new runs that a stated range holds. With two runs a claim of 95 % would say nothing: its end is twice as far.
fn held(runs: usize) -> f64 {
    if runs > 2 { 0.95 } else { 0.9 }
}

/// Range of the RMSE of a new run, N: from the least that a left-out run was off by within itself. None of fewer than two runs.
pub(crate) fn rmse_range(left_out: &[LeftOut]) -> Option<(f64, f64)> {
    let runs = residuals_of_runs(left_out, |_| 1.0);
    let size = |residuals: &[f64]| {
        let squares: f64 = residuals.iter().map(|residual| residual * residual).sum();
        (squares / residuals.len() as f64).sqrt()
    };
    let sizes: Vec<(f64, f64)> = runs
        .iter()
        .map(|run| (size(&run.whole), size(&run.within)))
        .collect();
    if sizes.len() < 2 {
        return None;
    }
    let low = sizes
        .iter()
        .map(|(_, within)| *within)
        .fold(f64::INFINITY, f64::min);
    Some((low, next_run(&sizes, held(sizes.len()))?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// Rows of a run whose estimates are off by a gain, and by noise of 0.1 N in turn up and down.
    fn run(group: usize, gain: f64) -> impl Iterator<Item = LeftOut> {
        (0..40).map(move |row| {
            let truth = f64::from(row % 10);
            let noise = if row % 4 < 2 { 0.1 } else { -0.1 };
            LeftOut {
                row: row as usize,
                group,
                truth,
                mean: gain * truth + noise,
                deviation: 1.0,
                is_suspect: false,
            }
        })
    }

    #[test]
    fn a_run_s_own_zero_and_gain_are_taken_apart() {
        let rows: Vec<LeftOut> = run(0, 1.25).collect();
        let found = &residuals_of_runs(&rows, |_| 1.0)[0];
        let rms = |of: &[f64]| (of.iter().map(|x| x * x).sum::<f64>() / of.len() as f64).sqrt();
        // 0.25 of forces whose squares are 28.5 in the mean; then the noise over the gain.
        assert!((rms(&found.whole) - (0.0625f64 * 28.5 + 0.01).sqrt()).abs() < 0.02);
        assert!((rms(&found.within) - 0.08).abs() < 0.001);
    }

    #[test]
    fn a_new_run_may_be_off_as_student_says() {
        // t at 0.95 two-sided: 12.706 of one degree of freedom, 3.182 of three.
        let end = |count: usize, share| next_run(&vec![(1.0, 0.0); count], share).expect("runs");
        assert!((end(2, 0.95) - 12.706 * 0.75f64.sqrt()).abs() < 1e-3);
        assert!((end(4, 0.95) - 3.182 * (1.25f64 / (4.0 / 3.0)).sqrt()).abs() < 1e-3);
        // What runs don't differ by stays as it is.
        assert_eq!(next_run(&[(2.0, 2.0); 3], 0.95), Some(2.0));
        assert_eq!(next_run(&[], 0.95), None);
    }

    #[test]
    fn the_stated_range_holds_new_runs_whose_gains_differ() {
        // The mean of the learnt gains is taken as theirs, as by least squares. Binomial: of 2000 new runs 0.9 +- 0.02.
        let mut generator = ChaCha8Rng::seed_from_u64(1);
        let mut normal = || {
            let draws: f64 = (0..12).map(|_| generator.random_range(0.0..1.0)).sum();
            draws - 6.0
        };
        for (count, share) in [(2, 0.9), (4, 0.95)] {
            let mut held = 0;
            for _ in 0..2000 {
                let gains: Vec<f64> = (0..count).map(|_| 1.0 + 0.05 * normal()).collect();
                let sum: f64 = gains.iter().sum();
                let rows: Vec<LeftOut> = gains
                    .iter()
                    .enumerate()
                    .flat_map(|(group, gain)| run(group, gain * (count - 1) as f64 / (sum - gain)))
                    .collect();
                let (low, high) = rmse_range(&rows).expect("runs");
                let new = (1.0 + 0.05 * normal()) * count as f64 / sum;
                let squares: f64 = run(0, new).map(|row| (row.truth - row.mean).powi(2)).sum();
                let error = (squares / 40.0).sqrt();
                held += usize::from((low..=high).contains(&error));
            }
            let found = held as f64 / 2000.0;
            assert!((found - share).abs() < 0.02, "{count}: {found}");
        }
    }
}
