//! How wide intervals must be to hold what they promise, learnt from what models said of rows they hadn't seen.
//!
//! A model's deviation is right in shape at best: new runs differ by more than rows of one run do. A left-out row's residual over its deviation
//! tells by how much. Rows of one cycle or run aren't independent, so the factor is taken group by group (conformal prediction
//! with groups exchangeable: Dunn, Wasserman and Ramdas 2022): each group's factor holds its share of the group's rows, and the interval's factor is one
//! that most groups don't exceed.

use std::collections::BTreeMap;

use crate::error_metrics::{PROMISE, interval_score, quantile};

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

/// Share of groups whose factors the interval's doesn't fall below.
const GROUP_SHARE: f64 = 0.8;
/// Quantiles of Student's t at [`GROUP_SHARE`], for one degree of freedom to four: of fewer groups than six a share can't be counted.
const STUDENT: [f64; 4] = [1.376, 1.061, 0.978, 0.941];
/// What few groups let expect is believed up to so many times the worst of them.
const MOST_BEYOND: f64 = 1.5;

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
    let of_groups = match factors.len() {
        0 => return None,
        1 => pooled,
        few if few - 2 < STUDENT.len() => expected(&factors, STUDENT[few - 2]),
        _ => quantile(&factors, GROUP_SHARE),
    };
    // Groups of few rows have small factors by chance; all rows together don't.
    let found = of_groups.max(pooled);
    found.is_finite().then_some(found.max(f64::MIN_POSITIVE))
}

/// The factor of another group, where the logarithms of factors are normal: mean + t s root(1 + 1/k) of k sorted factors.
fn expected(factors: &[f64], student: f64) -> f64 {
    let count = factors.len() as f64;
    let logs = || {
        factors
            .iter()
            .map(|factor| factor.max(f64::MIN_POSITIVE).ln())
    };
    let mean = logs().sum::<f64>() / count;
    let deviation = (logs().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (count - 1.0)).sqrt();
    let worst = factors.iter().copied().fold(0.0, f64::max);
    (mean + student * deviation * (1.0 + 1.0 / count).sqrt())
        .exp()
        .min(MOST_BEYOND * worst)
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
    fn few_groups_let_expect_a_worse_one() {
        // Residuals of 1 to 20 deviations, and others twice as large: 95 % of them are up to 19 and 38.
        let rows: Vec<LeftOut> = (0..40)
            .map(|k| row(k, k / 20, (k % 20 + 1) as f64 * (1 + k / 20) as f64, 1.0))
            .collect();
        // ln 19 and ln 38 have the mean ln 26.87 and the deviation ln 2 / root 2; times 1.376 root 1.5 it is 0.826.
        let expected =
            (19.0 * 38.0f64).sqrt() * (1.376 * 1.5f64.sqrt() * 2f64.ln() / 2f64.sqrt()).exp();
        let found = factor(&rows).expect("groups");
        assert!((found - expected.min(1.5 * 38.0)).abs() < 1e-9, "{found}");
        assert_eq!(factor(&[]), None);
        // The small group lies within the large one's factor, the large one half outside of the small one's, 19.
        let fared = fared(&rows).expect("two groups");
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
