//! Errors of estimates against the truth, and the [`order_statistics`] that bounds are made of.
//!
//! | symbol | meaning |
//! |---|---|
//! | RMSE | root of the mean squared error, N |
//! | NRMSE | RMSE over the range of the true forces that were tested, % |
//! | R2 | 1 - squared errors over squared deviations from the tested forces' mean |
//! | interval score | width + 2/a times what a truth lies outside of the interval that promises 1 - a (Gneiting and Raftery 2007, eq. 43) |

pub(crate) mod interval;
pub(crate) mod left_out;
pub mod order_statistics;
pub(crate) mod run_spread;

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::error_metrics::order_statistics::covering_quantile;

/// Share of the rows that intervals promise to hold.
pub(crate) const PROMISE: f64 = 0.95;
/// Samples of the bootstrap.
const DRAWS: usize = 1000;

/// RMSE; 0 of nothing.
pub fn rmse(truth: &[f64], estimate: &[f64]) -> f64 {
    let squares = truth.iter().zip(estimate).map(|(t, e)| (t - e) * (t - e));
    (squares.sum::<f64>() / truth.len().max(1) as f64).sqrt()
}

/// RMSE over the range of the truth, %; none where the truth doesn't vary.
pub fn nrmse_percent(truth: &[f64], rmse: f64) -> Option<f64> {
    let low = truth.iter().copied().fold(f64::INFINITY, f64::min);
    let high = truth.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    (high > low).then(|| 100.0 * rmse / (high - low))
}

/// Coefficient of determination; none where the truth doesn't vary.
pub fn r2(truth: &[f64], estimate: &[f64]) -> Option<f64> {
    let mean = truth.iter().sum::<f64>() / truth.len().max(1) as f64;
    let total: f64 = truth.iter().map(|t| (t - mean) * (t - mean)).sum();
    let squares: f64 = truth
        .iter()
        .zip(estimate)
        .map(|(t, e)| (t - e) * (t - e))
        .sum();
    (total > 0.0).then(|| 1.0 - squares / total)
}

/// The interval score of one truth.
pub(crate) fn interval_score(truth: f64, low: f64, high: f64) -> f64 {
    let outside = (low - truth).max(truth - high).max(0.0);
    high - low + 2.0 / (1.0 - PROMISE) * outside
}

/// The range that holds 95 % of the RMSEs of samples of whole cycles (percentile bootstrap). `cycle` numbers the cycle of each row. None with fewer than two cycles.
pub fn rmse_interval(
    truth: &[f64],
    estimate: &[f64],
    cycle: &[usize],
    seed: u64,
) -> Option<(f64, f64)> {
    let mut sums: std::collections::BTreeMap<usize, (f64, f64)> = std::collections::BTreeMap::new();
    for ((t, e), cycle) in truth.iter().zip(estimate).zip(cycle) {
        let (squares, rows) = sums.entry(*cycle).or_default();
        *squares += (t - e) * (t - e);
        *rows += 1.0;
    }
    let sums: Vec<(f64, f64)> = sums.into_values().collect();
    if sums.len() < 2 {
        return None;
    }
    let mut generator = ChaCha8Rng::seed_from_u64(seed);
    let mut found: Vec<f64> = (0..DRAWS)
        .map(|_| {
            let (mut squares, mut rows) = (0.0, 0.0);
            for _ in 0..sums.len() {
                let (s, n) = sums[generator.random_range(0..sums.len())];
                squares += s;
                rows += n;
            }
            (squares / rows).sqrt()
        })
        .collect();
    found.sort_by(f64::total_cmp);
    let tail = (1.0 - PROMISE) / 2.0;
    Some((
        covering_quantile(&found, tail),
        covering_quantile(&found, 1.0 - tail),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_those_of_their_formulas() {
        let (truth, estimate) = ([1.0, 2.0, 3.0, 6.0], [1.0, 2.0, 5.0, 6.0]);
        assert_eq!(rmse(&truth, &estimate), 1.0);
        assert_eq!(nrmse_percent(&truth, 1.0), Some(20.0));
        // The mean is 3, the squared deviations from it 4 + 1 + 0 + 9.
        assert_eq!(r2(&truth, &estimate), Some(1.0 - 4.0 / 14.0));
        assert_eq!(r2(&[2.0, 2.0], &[2.0, 1.0]), None);
        assert_eq!(nrmse_percent(&[2.0, 2.0], 1.0), None);
        assert_eq!(interval_score(0.0, -1.0, 1.0), 2.0);
        assert!((interval_score(1.5, -1.0, 1.0) - 22.0).abs() < 1e-12);
    }

    #[test]
    fn the_bootstrap_holds_the_deviation_of_a_mean_of_cycles() {
        // 100 cycles of one row whose squared errors are 0 or 2 in turn: their mean is 1 with a standard deviation of 0.1.
        let truth: Vec<f64> = (0..100)
            .map(|k| if k % 2 == 0 { 0.0 } else { 2f64.sqrt() })
            .collect();
        let cycle: Vec<usize> = (0..100).collect();
        let (low, high) = rmse_interval(&truth, &vec![0.0; 100], &cycle, 1).expect("cycles");
        // 1.96 deviations about 1, of 1000 draws, whose percentiles are known to 0.2 deviations.
        assert!(
            (low * low - 0.804).abs() < 0.03 && (high * high - 1.196).abs() < 0.03,
            "{low} {high}"
        );
        assert_eq!(rmse_interval(&truth, &truth, &[0; 100], 1), None);
    }
}
