//! Residuals of each signal from a line of the others, of rows that the lines weren't learnt from.

use faer::linalg::solvers::{DenseSolveCore, Llt};
use faer::{Mat, Side};
use ndarray::{Array2, ArrayView2, Axis};

use crate::model::even_subset::even_subset;

/// Share of each signal's variance that is taken for unexplained: gains of some 3 %.
const UNEXPLAINED: f64 = 1e-3;
/// Blocks of one run, each left out in turn.
const BLOCKS: usize = 5;
/// Least spread of a signal: over a smaller one nothing stays finite.
const LEAST_SPREAD: f64 = 1e-100;

/// Each signal by a line of the others, all in spreads within runs and less the run's first reading.
#[derive(Debug, Clone)]
pub(super) struct Lines {
    /// Spread of each signal within runs, in its own unit.
    pub spreads: Vec<f64>,
    /// Residual of signal i: the sum of z_j w_ji.
    pub weights: Array2<f64>,
    /// Factor of each residual that makes them comparable: whose is the largest names the faulty signal (reconstruction-based contribution; Alcala and Qin 2009).
    pub blame: Vec<f64>,
}

/// Residuals of a run's rows x signals.
#[derive(Debug, Clone)]
pub(super) struct Residuals {
    /// Residual of each signal.
    pub residual: Array2<f64>,
    /// Value that the others make each signal have.
    pub expected: Array2<f64>,
    /// Residual that gains of all signals off by one part, one by one, would leave together.
    pub of_gains: Array2<f64>,
}

/// Root of the mean square about each run's mean.
pub(super) fn spreads(runs: &[ArrayView2<'_, f64>]) -> Vec<f64> {
    let signals = runs.first().map_or(0, |run| run.ncols());
    let of_signal = |signal: usize| {
        let (mut squares, mut count) = (0.0, 0.0);
        for run in runs {
            let column = run.column(signal);
            let mean = column.mean().unwrap_or(0.0);
            squares += column.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>();
            count += column.len() as f64;
        }
        (squares / f64::max(count, 1.0)).sqrt().max(LEAST_SPREAD)
    };
    (0..signals).map(of_signal).collect()
}

impl Lines {
    /// Learns them from runs: with P = (Z'Z / n + 0.001 I)^-1 of rows about their runs' means, the residual of signal i is z P_i / P_ii. None without a Cholesky factor.
    pub(super) fn learn(runs: &[ArrayView2<'_, f64>], spreads: &[f64]) -> Option<Self> {
        let signals = spreads.len();
        let mut products = Array2::<f64>::zeros((signals, signals));
        let mut rows = 0.0;
        for run in runs {
            let mean = run.mean_axis(Axis(0))?;
            let z = (run - &mean) / ndarray::aview1(spreads);
            products += &z.t().dot(&z);
            rows += run.nrows() as f64;
        }
        let covariance = Mat::from_fn(signals, signals, |i, j| {
            products[[i, j]] / rows + if i == j { UNEXPLAINED } else { 0.0 }
        });
        let inverse = Llt::new(covariance.as_ref(), Side::Lower).ok()?.inverse();
        let weights = Array2::from_shape_fn((signals, signals), |(j, i)| {
            inverse[(j, i)] / inverse[(i, i)]
        });
        let blame: Vec<f64> = (0..signals).map(|i| inverse[(i, i)].sqrt()).collect();
        let is_finite = weights.iter().chain(&blame).all(|x| x.is_finite());
        is_finite.then(|| Self {
            spreads: spreads.to_vec(),
            weights,
            blame,
        })
    }

    /// Residuals of a run, whose first row is its start.
    pub(super) fn residuals(&self, run: &ArrayView2<'_, f64>) -> Residuals {
        let z = (run - &run.row(0)) / ndarray::aview1(&self.spreads);
        let residual = z.dot(&self.weights);
        let squares = |x: &Array2<f64>| x.mapv(|x| x * x);
        Residuals {
            expected: &z - &residual,
            of_gains: squares(&z).dot(&squares(&self.weights)).mapv(f64::sqrt),
            residual,
        }
    }
}

/// Residuals of each run by lines of the others; of one run those of its blocks, each begun by the run's first row.
pub(super) fn left_out(runs: &[ArrayView2<'_, f64>], spreads: &[f64]) -> Option<Vec<Residuals>> {
    if let [one] = runs {
        let rows = one.nrows();
        let block = |number: usize| number * rows / BLOCKS..(number + 1) * rows / BLOCKS;
        let of_rows = |meant: &dyn Fn(usize) -> bool| {
            let places: Vec<usize> = (1..rows).filter(|row| meant(*row)).collect();
            one.select(Axis(0), &[vec![0], places].concat())
        };
        let of_block = |number: usize| {
            let these = block(number);
            let train = of_rows(&|row| !these.contains(&row));
            let lines = Lines::learn(&[train.view()], spreads)?;
            Some(lines.residuals(&of_rows(&|row| these.contains(&row)).view()))
        };
        return (0..BLOCKS).map(of_block).collect();
    }
    let of_run = |number: usize| {
        let others: Vec<ArrayView2<'_, f64>> = runs
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != number)
            .map(|(_, run)| *run)
            .collect();
        Some(Lines::learn(&others, spreads)?.residuals(&runs[number]))
    };
    (0..runs.len()).map(of_run).collect()
}

/// Rows of a run, at most so many, its first among them.
pub(super) fn thinned(run: &Array2<f64>, most: usize) -> Array2<f64> {
    run.select(Axis(0), &even_subset(run.nrows(), most))
}
