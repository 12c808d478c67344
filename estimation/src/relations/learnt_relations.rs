//! Relations of the signals of unfaulty runs to each other, learnt from runs that were left out.
//!
//! A residual may be as large as its noise and what gains that differ between runs leave of the signals: scale^2 = a^2 + (t g)^2, with a of each signal and t of all.
//! Limits are the largest 99.5 % quantiles of residuals over their scale among left-out runs, with room for runs that weren't seen.

use ndarray::{Array2, ArrayView2};
use serde::{Deserialize, Serialize};
use statrs::distribution::{ContinuousCDF, Normal};

use super::left_out_residuals::{Lines, Residuals, left_out, spreads, thinned};
use super::still_stretch::StillStretch;
use crate::error_metrics::order_statistics::interpolated_quantile;
use crate::model::contract::check_numbers;

/// More signals would have more pairs than are worth their memory.
const MOST_SIGNALS: usize = 256;
/// Fewer rows tell nothing.
const FEWEST_ROWS: usize = 20;
/// Rows of a run that lines and limits are learnt from.
const MOST_ROWS: usize = 5000;
/// Median of the square of a standard normal number.
const MEDIAN_SQUARE: f64 = 0.455;
/// Gains differ between runs by this at least, as is expected before it is seen, and by the second at most: beyond, relations would tell nothing.
const GAINS: (f64, f64) = (0.05, 0.12);
/// Quantile of clean residuals that limits are.
const QUANTILE: f64 = 0.995;
/// Least limit; with many signals that which one of 2000 clean rows exceeds.
const LEAST_LIMIT: f64 = 2.8;
const CLEAN_ROWS: f64 = 0.0005;
/// Steps beyond the largest one learnt, as a factor of it, are spikes.
const JUMP: f64 = 2.0;
/// Least number of still rows that is told.
const FEWEST_STILL: usize = 3;
/// Least deviation of a residual and least step: over smaller ones nothing stays finite.
const LEAST: f64 = 1e-9;

/// Relations of signals to each other. Residuals are in spreads of the signals.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Relations {
    /// Spread of each signal within runs, in its own unit.
    pub(super) spreads: Vec<f64>,
    /// Residual of signal i: the sum of z_j w_ji, row by row; empty of one signal.
    pub(super) weights: Vec<f64>,
    /// Factor of each residual by which faulty signals are named.
    pub(super) blame: Vec<f64>,
    /// Deviation of each residual without a load.
    pub(super) noise: Vec<f64>,
    /// Share by which gains may differ.
    pub(super) gains: f64,
    /// Limit of each residual over its scale.
    pub(super) limits: Vec<f64>,
    /// Longest stretch of still rows, while others move, that a signal may have.
    pub(super) still: Vec<usize>,
    /// Largest step of each signal from row to row, in its own unit.
    pub(super) steps: Vec<f64>,
}

impl Relations {
    /// Learns them from the signals of runs, rows x signals. None of too many signals, or too few rows.
    pub fn learn(runs: &[&Array2<f64>]) -> Option<Self> {
        let signals = runs.first()?.ncols();
        let is_short = |run: &&Array2<f64>| run.nrows() < FEWEST_ROWS;
        if !(1..=MOST_SIGNALS).contains(&signals) || runs.iter().any(is_short) {
            return None;
        }
        let (still, steps) = still_and_steps(runs, signals);
        let thin: Vec<Array2<f64>> = runs.iter().map(|run| thinned(run, MOST_ROWS)).collect();
        let thin: Vec<ArrayView2<'_, f64>> = thin.iter().map(|run| run.view()).collect();
        let spreads = spreads(&thin);
        let mut found = Self {
            spreads,
            weights: Vec::new(),
            blame: Vec::new(),
            noise: Vec::new(),
            gains: 0.0,
            limits: Vec::new(),
            still,
            steps,
        };
        if signals > 1 {
            found.learn_lines(&thin)?;
        }
        found.check(signals).is_ok().then_some(found)
    }

    fn learn_lines(&mut self, runs: &[ArrayView2<'_, f64>]) -> Option<()> {
        let lines = Lines::learn(runs, &self.spreads)?;
        let left_out = left_out(runs, &self.spreads)?;
        let (count, signals) = (runs.len() as f64, self.spreads.len());
        // A run's gains are drawn once, and those of the runs learnt from once each.
        self.gains = gains(&left_out, runs.len()) * (1.0 + 1.0 / count).sqrt();
        // One run says nothing of how runs differ.
        let room = if runs.len() == 1 {
            1.75
        } else {
            1.25 + 0.25 / count
        };
        let normal = Normal::standard();
        let of_chance = normal.inverse_cdf(1.0 - CLEAN_ROWS / signals as f64);
        for signal in 0..signals {
            let noise = noise(&left_out, signal, runs.len());
            let limits = left_out.iter().map(|run| {
                let rows = run.residual.column(signal).to_vec();
                let gains = run.of_gains.column(signal).to_vec();
                let over: Vec<f64> = rows
                    .iter()
                    .zip(gains)
                    .map(|(row, gain)| row.abs() / noise.hypot(self.gains * gain))
                    .collect();
                quantile(over, QUANTILE)
            });
            let seen = limits.fold(0.0, f64::max).max(LEAST_LIMIT);
            self.limits.push((room * seen).max(of_chance));
            self.noise.push(noise);
        }
        self.weights = lines.weights.iter().copied().collect();
        self.blame = lines.blame;
        Some(())
    }

    /// Whether these are relations of so many signals.
    ///
    /// # Errors
    /// A sentence, when they aren't.
    pub fn check(&self, signals: usize) -> Result<(), String> {
        let pairs = if signals > 1 { signals } else { 0 };
        check_numbers("the signals' spreads", &self.spreads, signals)?;
        check_numbers("the signals' steps", &self.steps, signals)?;
        check_numbers("the relations' weights", &self.weights, pairs * pairs)?;
        for (what, numbers) in [
            ("the relations' blame", &self.blame),
            ("the relations' noise", &self.noise),
            ("the relations' limits", &self.limits),
        ] {
            check_numbers(what, numbers, pairs)?;
        }
        let positive = [&self.spreads, &self.steps, &self.noise, &self.limits];
        let is_positive = positive.into_iter().flatten().all(|x| *x > 0.0);
        if !is_positive || !self.gains.is_finite() || self.still.len() != signals {
            return Err("spreads, steps, noise and limits of signals must be positive".to_owned());
        }
        Ok(())
    }
}

/// Longest still stretch that a signal may have, and the largest step.
fn still_and_steps(runs: &[&Array2<f64>], signals: usize) -> (Vec<usize>, Vec<f64>) {
    let (mut longest, mut largest) = (vec![0; signals], vec![LEAST; signals]);
    for run in runs {
        let mut stretch = StillStretch::new(signals);
        for row in run.rows() {
            let row = row.to_vec();
            for (most, step) in largest.iter_mut().zip(stretch.steps(&row)) {
                *most = f64::max(*most, step.abs());
            }
            for (most, count) in longest.iter_mut().zip(stretch.push(&row)) {
                *most = (*most).max(*count);
            }
        }
    }
    // Where one of n rows begins a stretch of m by chance, one of n^2 begins one of 2 m.
    let still = longest
        .into_iter()
        .map(|most| (2 * most + 1).max(FEWEST_STILL));
    (
        still.collect(),
        largest.into_iter().map(|most| JUMP * most).collect(),
    )
}

/// Share by which gains differ between runs: from the slopes of left-out residuals on what they are residuals of.
fn gains(left_out: &[Residuals], runs: usize) -> f64 {
    if runs == 1 {
        return GAINS.0;
    }
    let slopes = left_out.iter().flat_map(|run| {
        (0..run.residual.ncols()).filter_map(|signal| {
            let expected = run.expected.column(signal);
            let square = |x: f64| x * x;
            let squares: f64 = expected.iter().map(|x| square(*x)).sum();
            let of_gains: f64 = run.of_gains.column(signal).iter().map(|x| square(*x)).sum();
            let slope = run.residual.column(signal).dot(&expected);
            let found = square(slope) / (squares * of_gains);
            found.is_finite().then_some(found)
        })
    });
    let slopes: Vec<f64> = slopes.collect();
    let mean = slopes.iter().sum::<f64>() / slopes.len().max(1) as f64;
    // A left-out run is held against the others' mean.
    let others = (runs - 1) as f64;
    (mean / (1.0 + 1.0 / others)).sqrt().clamp(GAINS.0, GAINS.1)
}

/// Deviation of a signal's residual: the largest of the left-out runs, by the median of squares. The first reading's own noise stands in a whole run.
fn noise(left_out: &[Residuals], signal: usize, runs: usize) -> f64 {
    let by_median = |rows: Vec<f64>, about: f64| {
        let squares = rows.iter().map(|row| (row - about) * (row - about));
        quantile(squares.collect(), 0.5) / MEDIAN_SQUARE
    };
    let of_run = |run: &Residuals| {
        let rows = run.residual.column(signal).to_vec();
        let median = quantile(rows.clone(), 0.5);
        let whole = by_median(rows.clone(), 0.0);
        if runs > 1 {
            whole.max(2.0 * by_median(rows, median))
        } else {
            whole
        }
    };
    let largest = left_out.iter().map(of_run).fold(0.0, f64::max);
    largest.sqrt().max(LEAST)
}

fn quantile(mut numbers: Vec<f64>, share: f64) -> f64 {
    numbers.sort_by(f64::total_cmp);
    interpolated_quantile(&numbers, share)
}
