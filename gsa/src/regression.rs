//! Sparse least squares: a few of many candidate columns that explain a handful of values.
//!
//! Orthogonal least squares (S. Chen, S. A. Billings, W. Luo, "Orthogonal least squares methods and their application to
//! non-linear system identification", International Journal of Control 50 (1989) 1873-1896) takes one column after the
//! other: the one that, made orthogonal to those taken, lowers the misfit most. How many is decided by the leave-one-out
//! residuals, which for least squares follow from the leverages without refitting,
//!
//! ```text
//! e_k = (y_k - fit_k) / (1 - l_k),   l_k = sum_p q_kp^2
//! ```
//!
//! with orthonormal columns q_p (D. M. Allen's PRESS, Technometrics 16 (1974) 125-127). Since the columns were chosen with
//! all values in sight, these flatter the fit; [`cross_validate`] repeats the choice without the points it predicts.

/// Of K points at most this share becomes unknowns: beyond, leverages near one make leave-one-out residuals noise.
const MOST_UNKNOWNS: f64 = 0.5;
/// A column is spent when this little of its square is left beside those taken.
const SPENT: f64 = 1e-10;
/// Steps without a better leave-one-out misfit before the search ends.
const PATIENCE: usize = 4;
/// Groups of cross validation.
const FOLDS: usize = 8;

/// Candidate columns, and how much each is preferred: a cheap simple one to an equally good intricate one.
pub(crate) struct Candidates {
    pub(crate) columns: Vec<Vec<f64>>,
    pub(crate) preference: Vec<f64>,
}

/// Which columns, with which coefficients.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fit {
    pub(crate) terms: Vec<(usize, f64)>,
    /// The terms' columns are Q R with orthonormal Q: the columns of R, each down to its diagonal.
    triangles: Vec<Vec<f64>>,
}

impl Fit {
    /// Standard deviation of a number with this gradient to the coefficients, for values that scatter by one each:
    /// sqrt(g^T (R^T R)^-1 g).
    pub(crate) fn deviation(&self, gradient: &[f64]) -> f64 {
        let mut y: Vec<f64> = Vec::with_capacity(gradient.len());
        for (g, column) in gradient.iter().zip(&self.triangles) {
            let (above, diagonal) = column.split_at(y.len());
            y.push((g - dot(above, &y)) / diagonal[0]);
        }
        dot(&y, &y).sqrt()
    }
}

/// One step of the search: the column taken, its unit vector, and its coefficients on those before.
struct Step {
    column: usize,
    unit: Vec<f64>,
    /// products of the unit vectors so far, this one last, with the column as given
    triangle: Vec<f64>,
    /// of this unit vector with the values
    coefficient: f64,
}

/// Fits the values at `rows`; a misfit of `noise` in the mean is exact.
pub(crate) fn fit(candidates: &Candidates, values: &[f64], rows: &[usize], noise: f64) -> Fit {
    let mut residual: Vec<f64> = rows.iter().map(|&k| values[k]).collect();
    let mut left: Vec<Vec<f64>> = candidates
        .columns
        .iter()
        .map(|column| rows.iter().map(|&k| column[k]).collect())
        .collect();
    let norms: Vec<f64> = left.iter().map(|column| dot(column, column)).collect();
    let mut leverage = vec![0.0; rows.len()];
    let mut steps: Vec<Step> = Vec::new();
    let (mut best, mut best_score) = (0, dot(&residual, &residual));
    let most = (rows.len() as f64 * MOST_UNKNOWNS) as usize;
    let exact = noise * noise * rows.len() as f64;
    while steps.len() < most && best_score > exact && steps.len() < best + PATIENCE {
        let Some(column) = next(&left, &norms, &candidates.preference, &residual) else {
            break;
        };
        let step = take(candidates, rows, &mut left, &mut residual, &steps, column);
        for (l, q) in leverage.iter_mut().zip(&step.unit) {
            *l += q * q;
        }
        steps.push(step);
        let score = left_out(&residual, &leverage);
        if score < best_score {
            (best, best_score) = (steps.len(), score);
        }
    }
    steps.truncate(best);
    Fit {
        terms: solve(&steps),
        triangles: steps.into_iter().map(|step| step.triangle).collect(),
    }
}

/// The column that lowers the misfit most.
fn next(left: &[Vec<f64>], norms: &[f64], preference: &[f64], residual: &[f64]) -> Option<usize> {
    let gain = |index: usize| {
        let square = dot(&left[index], &left[index]);
        if square <= SPENT * norms[index] {
            return 0.0;
        }
        preference[index] * dot(&left[index], residual).powi(2) / square
    };
    let gains = (0..left.len()).map(|index| (index, gain(index)));
    gains
        .filter(|(_, gain)| *gain > 0.0)
        .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
        .map(|(index, _)| index)
}

fn take(
    candidates: &Candidates,
    rows: &[usize],
    left: &mut [Vec<f64>],
    residual: &mut [f64],
    before: &[Step],
    column: usize,
) -> Step {
    let length = dot(&left[column], &left[column]).sqrt();
    let unit: Vec<f64> = left[column].iter().map(|x| x / length).collect();
    for other in left.iter_mut() {
        let share = dot(other, &unit);
        subtract(other, &unit, share);
    }
    let coefficient = dot(residual, &unit);
    subtract(residual, &unit, coefficient);
    let whole: Vec<f64> = rows
        .iter()
        .map(|&k| candidates.columns[column][k])
        .collect();
    let units = before.iter().map(|step| &step.unit);
    let triangle = units.chain([&unit]).map(|q| dot(q, &whole)).collect();
    Step {
        column,
        unit,
        triangle,
        coefficient,
    }
}

/// Squared leave-one-out residuals, raised for the unknowns spent: with P unknowns of K values the misfit to new ones is
/// some K/(K - P) times as large.
fn left_out(residual: &[f64], leverage: &[f64]) -> f64 {
    let unknowns: f64 = leverage.iter().sum();
    let count = residual.len() as f64;
    let squares = residual.iter().zip(leverage);
    let sum: f64 = squares
        .map(|(r, l)| (r / (1.0 - l).max(1e-6)).powi(2))
        .sum();
    sum * count / (count - unknowns)
}

/// Coefficients of the columns as given, by back substitution.
fn solve(steps: &[Step]) -> Vec<(usize, f64)> {
    let mut coefficients: Vec<f64> = steps.iter().map(|step| step.coefficient).collect();
    for p in (0..steps.len()).rev() {
        coefficients[p] /= steps[p].triangle[p];
        for q in 0..p {
            coefficients[q] -= steps[p].triangle[q] * coefficients[p];
        }
    }
    let columns = steps.iter().map(|step| step.column);
    columns.zip(coefficients).collect()
}

/// What a fit without point k, chosen without it too, is off by there.
pub(crate) fn cross_validate(candidates: &Candidates, values: &[f64], noise: f64) -> Vec<f64> {
    let count = values.len();
    let folds = FOLDS.min(count);
    let mut residuals = values.to_vec();
    for fold in 0..folds {
        let kept: Vec<usize> = (0..count).filter(|k| k % folds != fold).collect();
        let fit = fit(candidates, values, &kept, noise);
        for k in (fold..count).step_by(folds) {
            let terms = fit.terms.iter();
            residuals[k] -= terms
                .map(|(column, c)| c * candidates.columns[*column][k])
                .sum::<f64>();
        }
    }
    residuals
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn subtract(a: &mut [f64], b: &[f64], factor: f64) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= factor * b);
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    fn candidates_of(columns: usize, rows: usize) -> Candidates {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let mut unit = || (rng.next_u64() >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
        Candidates {
            columns: (0..columns)
                .map(|_| (0..rows).map(|_| unit()).collect())
                .collect(),
            preference: vec![1.0; columns],
        }
    }

    fn combination(candidates: &Candidates, terms: &[(usize, f64)]) -> Vec<f64> {
        let row = |k: usize| {
            let terms = terms.iter();
            terms.map(|(i, c)| c * candidates.columns[*i][k]).sum()
        };
        (0..candidates.columns[0].len()).map(row).collect()
    }

    #[test]
    fn three_of_two_hundred_columns_are_found_from_twenty_values() {
        let candidates = candidates_of(200, 20);
        let terms = [(17, 3.0), (90, -1.5), (151, 2.0)];
        let values = combination(&candidates, &terms);
        let rows: Vec<usize> = (0..20).collect();
        let mut found = fit(&candidates, &values, &rows, 1e-13).terms;
        found.sort_by_key(|(column, _)| *column);
        assert_eq!(found.len(), 3);
        for ((i, c), (j, expected)) in found.iter().zip(terms) {
            assert!(*i == j && (c - expected).abs() < 1e-13, "{found:?}");
        }
        let unseen = cross_validate(&candidates, &values, 1e-13);
        assert!(unseen.iter().all(|r| r.abs() < 1e-12), "{unseen:?}");
    }

    #[test]
    fn noise_is_not_explained() {
        // values that have nothing to do with the columns
        let candidates = candidates_of(200, 30);
        let values = candidates_of(231, 30).columns[230].clone();
        let rms = |r: &[f64]| (dot(r, r) / r.len() as f64).sqrt();
        let unseen = cross_validate(&candidates, &values, 1e-13);
        // honest residuals are no smaller than the values themselves
        assert!(
            rms(&unseen) > 0.8 * rms(&values),
            "{} {}",
            rms(&unseen),
            rms(&values)
        );
    }
}
