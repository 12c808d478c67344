//! Widths that intervals must have to hold what they promise, learnt from what models said of rows they hadn't seen.
//!
//! A model's deviation is right in shape at best: new runs differ by more than rows of one run do. A left-out row's residual over its deviation
//! tells by how much. Rows of one cycle or run aren't independent, so the factor is taken group by group (conformal prediction
//! with groups exchangeable: Dunn, Wasserman and Ramdas 2022): each group's factor holds its share of the group's rows, and the interval's factor is one
//! that most groups don't exceed.

use std::collections::BTreeMap;

use crate::error_metrics::left_out::LeftOut;
use crate::error_metrics::order_statistics::covering_quantile;
use crate::error_metrics::run_spread::{next_run, residuals_of_runs};
use crate::error_metrics::{PROMISE, interval_score};
use crate::recipe::SplitKind;

/// Share of groups whose factors the interval's doesn't fall below.
const GROUP_SHARE: f64 = 0.8;
/// Quantiles of Student's t at [`GROUP_SHARE`], for two degrees of freedom to six: of fewer groups than six a share can't be counted.
const STUDENT: [f64; 5] = [1.061, 0.978, 0.941, 0.920, 0.906];
/// Standard deviation of the logarithms of runs' factors that is expected before any is seen. Of virtual sensors of four kinds it was 0.13 to 0.23.
const USUAL_SPREAD: f64 = 0.2;
/// Degrees of freedom that this expectation is worth: two runs that happen to agree don't say that a third will.
const USUAL_WEIGHT: usize = 2;

/// Factor on the deviation by what was left out, suspect rows apart: they are outside, where nothing is promised; none of no rows. Runs differ, and few are
/// seen; cycles are many, and a run has all sorts of them.
pub(crate) fn factor_by(kind: SplitKind, left_out: &[LeftOut]) -> Option<f64> {
    let is_sound = |row: &&LeftOut| !row.is_suspect;
    let sound: Vec<LeftOut> = left_out.iter().filter(is_sound).copied().collect();
    match kind {
        SplitKind::Run => factor_of_runs(&sound),
        _ => factor_of_rows(&sound),
    }
}

/// Factor on the deviation so that an interval holds `PROMISE` of a new group's rows; none of no rows.
pub fn factor(left_out: &[LeftOut]) -> Option<f64> {
    let mut groups: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for row in left_out {
        groups.entry(row.group).or_default().push(ratio(row));
    }
    let mut factors: Vec<f64> = groups.into_values().map(of_ratios).collect();
    factors.sort_by(f64::total_cmp);
    let of_groups = match STUDENT.get(factors.len().checked_sub(1)?) {
        Some(student) => expected(&factors, *student),
        None => covering_quantile(&factors, GROUP_SHARE),
    };
    // Groups of few rows have small factors by chance; all rows together don't.
    let found = of_groups.max(factor_of_rows(left_out)?);
    found.is_finite().then_some(found)
}

/// Factor by runs, which may differ by their zeros and gains: then they tell less of another than their factors' spread does.
fn factor_of_runs(left_out: &[LeftOut]) -> Option<f64> {
    let of_absolutes = |residuals: &[f64]| of_ratios(residuals.iter().map(|x| x.abs()).collect());
    let sizes: Vec<(f64, f64)> = residuals_of_runs(left_out, |row| row.deviation)
        .iter()
        .map(|run| (of_absolutes(&run.whole), of_absolutes(&run.within)))
        .collect();
    let by_spread = factor(left_out)?;
    Some(next_run(&sizes, GROUP_SHARE)?.max(by_spread))
}

/// Factor on the deviation that holds [`PROMISE`] of all rows, whichever groups they are of; none of no rows.
fn factor_of_rows(left_out: &[LeftOut]) -> Option<f64> {
    let found = of_ratios(left_out.iter().map(ratio).collect());
    found.is_finite().then_some(found.max(f64::MIN_POSITIVE))
}

fn ratio(row: &LeftOut) -> f64 {
    (row.truth - row.mean).abs() / row.deviation
}

fn of_ratios(mut ratios: Vec<f64>) -> f64 {
    ratios.sort_by(f64::total_cmp);
    covering_quantile(&ratios, PROMISE)
}

/// The factor of another group, where the logarithms of factors are normal: mean + t s root(1 + 1/k) of k factors. Their variance is s0^2 before any is seen,
/// worth n0 degrees of freedom: s^2 = (n0 s0^2 + sum (x - mean)^2) / (n0 + k - 1), which t has, too (a scaled inverse chi-squared prior of the variance,
/// a flat one of the mean: Gelman et al. 2013, section 3.3).
fn expected(factors: &[f64], student: f64) -> f64 {
    let count = factors.len() as f64;
    let logs = || {
        factors
            .iter()
            .map(|factor| factor.max(f64::MIN_POSITIVE).ln())
    };
    let mean = logs().sum::<f64>() / count;
    let squares: f64 = logs().map(|x| (x - mean) * (x - mean)).sum();
    let weight = USUAL_WEIGHT as f64;
    let variance = (weight * USUAL_SPREAD * USUAL_SPREAD + squares) / (weight + count - 1.0);
    (mean + student * (variance * (1.0 + 1.0 / count)).sqrt()).exp()
}

/// Figures of intervals on groups whose residuals their factor wasn't learnt from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fared {
    /// Share of the rows within their intervals.
    pub coverage: f64,
    /// Mean width, N.
    pub width: f64,
    /// Mean interval score, N.
    pub score: f64,
}

/// Takes each group's factor from the others, by whichever rule gives a factor. None with one group.
pub fn fared(left_out: &[LeftOut], factor: impl Fn(&[LeftOut]) -> Option<f64>) -> Option<Fared> {
    let mut groups: Vec<usize> = left_out.iter().map(|row| row.group).collect();
    groups.sort_unstable();
    groups.dedup();
    let (mut inside, mut width, mut score) = (0.0, 0.0, 0.0);
    for group in groups {
        let (these, others): (Vec<LeftOut>, Vec<LeftOut>) =
            left_out.iter().partition(|row| row.group == group);
        let factor = factor(&others)?;
        for row in these {
            let half = factor * row.deviation;
            inside += f64::from((row.truth - row.mean).abs() <= half);
            width += 2.0 * half;
            score += interval_score(row.truth, row.mean - half, row.mean + half);
        }
    }
    let rows = left_out.len() as f64;
    Some(Fared {
        coverage: inside / rows,
        width: width / rows,
        score: score / rows,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(number: usize, group: usize, residual: f64, deviation: f64) -> LeftOut {
        LeftOut {
            row: number,
            group,
            truth: residual,
            mean: 0.0,
            deviation,
            is_suspect: false,
        }
    }

    /// Residuals of 1 to 20 deviations, times 1, 2, .. in one group after another: 95 % of them are up to 19, 38, ..
    fn scaled_groups(count: usize) -> Vec<LeftOut> {
        let residual = |k: usize| ((k % 20 + 1) * (1 + k / 20)) as f64;
        (0..20 * count)
            .map(|k| row(k, k / 20, residual(k), 1.0))
            .collect()
    }

    #[test]
    fn few_groups_let_expect_a_worse_one() {
        let rows = scaled_groups(2);
        // ln 19 and ln 38 have a squared deviation of (ln 2)^2 / 2 from their mean, ln 26.87; with 2 x 0.2^2 before, of three degrees of freedom.
        let variance = (2.0 * 0.04 + 2f64.ln().powi(2) / 2.0) / 3.0;
        let expected = (19.0 * 38.0f64).sqrt() * (0.978 * (1.5 * variance).sqrt()).exp();
        let found = factor(&rows).expect("groups");
        assert!((found - expected).abs() < 1e-9, "{found}");
        // Of all 40 rows 38 are up to 36 deviations.
        assert_eq!(factor_of_rows(&rows), Some(36.0));
        // One group tells nothing of the spread: what is usual is expected.
        let alone = factor(&rows[..20]).expect("a group");
        let usual = 19.0 * (1.061 * 0.2 * 2f64.sqrt()).exp();
        assert!((alone - usual).abs() < 1e-9, "{alone}");
        assert_eq!((factor(&[]), factor_of_rows(&[])), (None, None));
    }

    #[test]
    fn groups_that_agree_are_worth_more_the_more_they_are() {
        let equal = |count: usize| -> Vec<LeftOut> {
            (0..20 * count).map(|k| row(k, k / 20, 1.0, 1.0)).collect()
        };
        let found: Vec<f64> = (1..=6).filter_map(|count| factor(&equal(count))).collect();
        assert!(found.windows(2).all(|pair| pair[0] > pair[1]), "{found:?}");
        // Six are counted: none has another factor.
        assert_eq!(found.last(), Some(&1.0));
    }

    #[test]
    fn a_group_is_held_by_what_the_others_ask_for() {
        // By rows the small group lies within the large one's 38, the large one half outside of the small one's 19.
        let fared = fared(&scaled_groups(2), factor_of_rows).expect("two groups");
        assert!(
            (fared.coverage - (20.0 + 9.0) / 40.0).abs() < 1e-12,
            "{}",
            fared.coverage
        );
        assert!((fared.width - (2.0 * 38.0 + 2.0 * 19.0) / 2.0).abs() < 1e-12);
        assert_eq!(super::fared(&scaled_groups(1), factor), None);
    }

    #[test]
    fn deviations_that_are_right_in_shape_are_scaled() {
        let rows: Vec<LeftOut> = (0..200)
            .map(|k| row(k, k / 10, 3.0 * (1 + k % 7) as f64, (1 + k % 7) as f64))
            .collect();
        assert!((factor(&rows).expect("a factor") - 3.0).abs() < 1e-12);
        assert_eq!(fared(&rows, factor).expect("groups").coverage, 1.0);
    }
}
