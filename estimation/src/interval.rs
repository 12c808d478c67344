//! How wide intervals must be to hold what they promise, learnt from what models said of rows they hadn't seen.
//!
//! A model's deviation is right in shape at best: new runs differ by more than rows of one run do. A left-out row's residual over its deviation
//! tells by how much. Rows of one cycle or run aren't independent, so the factor is taken group by group (conformal prediction
//! with groups exchangeable: Dunn, Wasserman and Ramdas 2022): each group's factor holds its share of the group's rows, and the interval's factor is one
//! that most groups don't exceed.

use std::collections::BTreeMap;

use crate::metrics::{PROMISE, interval_score, quantile};

/// What a model said of a row that it hadn't learnt from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOut {
    /// The row's number among all labelled rows.
    pub row: usize,
    /// What was left out with it: the number of its run or cycle.
    pub group: usize,
    /// The measured force, N.
    pub truth: f64,
    /// The estimate, N.
    pub mean: f64,
    /// The model's standard deviation, N.
    pub deviation: f64,
}

/// Groups from which a share of them can be told.
const MANY_GROUPS: usize = 6;
/// Share of many groups whose factors the interval's doesn't fall below.
const GROUP_SHARE: f64 = 0.8;

/// Factor on the deviation so that an interval holds [`PROMISE`] of a new group's rows; none of no rows.
pub fn factor(left_out: &[LeftOut]) -> Option<f64> {
    let mut groups: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for row in left_out {
        groups
            .entry(row.group)
            .or_default()
            .push((row.truth - row.mean).abs() / row.deviation);
    }
    let of_rows = |mut ratios: Vec<f64>| {
        ratios.sort_by(f64::total_cmp);
        quantile(&ratios, PROMISE)
    };
    let pooled = of_rows(groups.values().flatten().copied().collect());
    let mut factors: Vec<f64> = groups.into_values().map(of_rows).collect();
    factors.sort_by(f64::total_cmp);
    let found = match factors.len() {
        0 => return None,
        // Models of folds learnt from fewer groups than the one that is kept: half-way between all rows and the worst group.
        few if few < MANY_GROUPS => 0.5 * (pooled + factors.last()?),
        _ => quantile(&factors, GROUP_SHARE).max(pooled),
    };
    found.is_finite().then_some(found.max(f64::MIN_POSITIVE))
}

/// How intervals fared on groups whose residuals their factor wasn't learnt from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fared {
    /// Share of the rows within their intervals.
    pub coverage: f64,
    /// Mean width, N.
    pub width: f64,
    /// Mean interval score, N.
    pub score: f64,
}

/// Takes each group's factor from the others. None with one group.
pub fn fared(left_out: &[LeftOut]) -> Option<Fared> {
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
        }
    }

    #[test]
    fn a_factor_lies_between_all_rows_and_the_worst_of_few_groups() {
        // Residuals of 1 to 20 deviations, and others twice as large: 95 % of the latter are up to 38, of all 40 up to 36.
        let rows: Vec<LeftOut> = (0..40)
            .map(|k| row(k, k / 20, (k % 20 + 1) as f64 * (1 + k / 20) as f64, 1.0))
            .collect();
        assert_eq!(factor(&rows), Some(37.0));
        assert_eq!(factor(&[]), None);
        let fared = fared(&rows).expect("two groups");
        // The small group lies within the large one's factor, the large one half outside of the small one's, 19.
        assert!(
            (fared.coverage - (20.0 + 9.0) / 40.0).abs() < 1e-12,
            "{}",
            fared.coverage
        );
    }

    #[test]
    fn deviations_that_are_right_in_shape_are_scaled() {
        let rows: Vec<LeftOut> = (0..200)
            .map(|k| row(k, k / 10, 3.0 * (1 + k % 7) as f64, (1 + k % 7) as f64))
            .collect();
        assert!((factor(&rows).expect("a factor") - 3.0).abs() < 1e-12);
        assert_eq!(fared(&rows).expect("groups").coverage, 1.0);
    }
}
