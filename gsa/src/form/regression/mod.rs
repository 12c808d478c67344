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
//! all values in sight, these flatter the fit; [`fit`] repeats the choice without the points it predicts.

mod orthogonal_columns;
mod validation_groups;

use ndarray::{Array1, Array2, ArrayView1, Axis};

use orthogonal_columns::{Left, Step, Taken};
use validation_groups::{FOLDS, groups, with_images};

/// Share of the points that becomes unknowns at most: beyond, leverages near one make leave-one-out residuals noise.
const MOST_UNKNOWNS: f64 = 0.5;
/// Steps without a better leave-one-out misfit before the search ends.
const PATIENCE: usize = 4;
/// A point that decides its own value alone has no residual: it counts as if this share of it were left.
const LEAST_FREEDOM: f64 = 1e-6;

/// Candidate columns, and how much each is preferred: a cheap simple one to an equally good intricate one.
pub(crate) struct Candidates {
    /// candidates x values: one after the other, so that their products with several vectors are one product of matrices
    columns: Array2<f64>,
    preference: Vec<f64>,
}

impl Candidates {
    /// `value(candidate, k)`: of the candidate's column at value k of `rows`.
    pub(crate) fn new(
        preference: Vec<f64>,
        rows: usize,
        mut value: impl FnMut(usize, usize) -> f64,
    ) -> Self {
        let columns = Array2::from_shape_fn((preference.len(), rows), |(candidate, k)| {
            value(candidate, k)
        });
        Self {
            columns,
            preference,
        }
    }

    /// Counts the candidates.
    pub(crate) fn count(&self) -> usize {
        self.preference.len()
    }

    /// The sum of so many times the columns, at value k.
    pub(crate) fn combined(&self, terms: &[(usize, f64)], k: usize) -> f64 {
        let terms = terms.iter();
        terms.map(|&(i, c)| c * self.columns[[i, k]]).sum()
    }

    fn rows(&self) -> usize {
        self.columns.ncols()
    }

    /// Products of every column with each vector: candidates x vectors.
    fn products(&self, vectors: &[ArrayView1<'_, f64>]) -> Array2<f64> {
        let mut side_by_side = Array2::zeros((self.rows(), vectors.len()));
        for (mut place, vector) in side_by_side.columns_mut().into_iter().zip(vectors) {
            place.assign(vector);
        }
        self.columns.dot(&side_by_side)
    }
}

/// Columns of a fit with their coefficients.
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
        let y = self.on_units(gradient);
        y.iter().map(|y| y * y).sum::<f64>().sqrt()
    }

    /// The sum of so many times the terms' columns that says how much each value counts in such a number: (R^T R)^-1 g.
    pub(crate) fn weights(&self, gradient: &[f64]) -> Vec<(usize, f64)> {
        let columns = self.terms.iter().map(|(column, _)| *column);
        columns
            .zip(back(&self.triangles, self.on_units(gradient)))
            .collect()
    }

    /// R^-T g
    fn on_units(&self, gradient: &[f64]) -> Vec<f64> {
        let mut y: Vec<f64> = Vec::with_capacity(gradient.len());
        for (g, column) in gradient.iter().zip(&self.triangles) {
            let (above, diagonal) = column.split_at(y.len());
            let before: f64 = above.iter().zip(&y).map(|(a, b)| a * b).sum();
            y.push((g - before) / diagonal[0]);
        }
        y
    }
}

/// The search among the columns for one list of values. The columns stay as they are: what is left of one beside those taken has the same product with the
/// residual, which is orthogonal to all of those, and a square less by that of its product with the newest unit vector.
struct Search<'a> {
    candidates: &'a Candidates,
    /// 1 for values that count, else 0
    kept: &'a Array1<f64>,
    noise: f64,
    residual: Array1<f64>,
    left: Left,
    /// product of each column with the residual
    products: Array1<f64>,
    taken: Taken,
    /// coefficients of the values on the unit vectors
    coefficients: Vec<f64>,
    /// number of columns that gave the least leave-one-out misfit so far, and that misfit
    best: usize,
    best_score: f64,
}

impl Search<'_> {
    /// The column to take next: that which lowers the misfit most; none when the search is over.
    fn next(&self) -> Option<usize> {
        let rows = self.kept.sum();
        let taken = self.taken.steps.len();
        let exact = self.noise * self.noise * rows;
        if taken >= (rows * MOST_UNKNOWNS) as usize
            || self.best_score <= exact
            || taken >= self.best + PATIENCE
        {
            return None;
        }
        let gain = |index: usize| {
            if self.left.is_spent(index) {
                return 0.0;
            }
            self.candidates.preference[index] * self.products[index].powi(2) / self.left.left[index]
        };
        let gains = (0..self.candidates.count()).map(|index| (index, gain(index)));
        gains
            .filter(|(_, gain)| *gain > 0.0)
            .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
            .map(|(index, _)| index)
    }

    /// Takes the next column; whether there was one. What the columns' products with its unit vector and with the new residual are, is told by [`Self::learn`].
    fn step(&mut self) -> bool {
        let Some(column) = self.next() else {
            return false;
        };
        let whole = self.candidates.columns.row(column);
        let unit = self.taken.take(column, whole, self.kept);
        let coefficient = self.residual.dot(&unit);
        self.residual.scaled_add(-coefficient, &unit);
        self.coefficients.push(coefficient);
        let score = left_out(&self.residual, &self.taken.leverage, self.kept.sum());
        if score < self.best_score {
            (self.best, self.best_score) = (self.coefficients.len(), score);
        }
        true
    }

    /// The newest unit vector, and the residual.
    fn asked(&self) -> [ArrayView1<'_, f64>; 2] {
        let newest = self.taken.steps.last();
        let newest = newest.map_or(self.residual.view(), |step| step.unit.view());
        [newest, self.residual.view()]
    }

    /// The columns' products with what was [`Self::asked`].
    fn learn(&mut self, with_unit: ArrayView1<'_, f64>, with_residual: ArrayView1<'_, f64>) {
        self.left.without(with_unit);
        self.products.assign(&with_residual);
    }

    fn fit(mut self) -> Fit {
        self.taken.steps.truncate(self.best);
        self.coefficients.truncate(self.best);
        Fit {
            terms: solve(&self.taken.steps, self.coefficients),
            triangles: self
                .taken
                .steps
                .into_iter()
                .map(|step| step.triangle)
                .collect(),
        }
    }
}

/// Fits the values, once for each list of those `kept` (1, else 0); a misfit of `noise` in the mean is exact. The searches take their steps side by side: then the
/// columns' products with all of their vectors are one product of matrices, which takes a fraction of the time of as many products with vectors.
fn fits(
    candidates: &Candidates,
    values: &Array1<f64>,
    kept: &[Array1<f64>],
    noise: f64,
) -> Vec<Fit> {
    let mut searches = searches(candidates, values, kept, noise);
    loop {
        let mut moved: Vec<&mut Search<'_>> = searches
            .iter_mut()
            .filter_map(|search| search.step().then_some(search))
            .collect();
        if moved.is_empty() {
            break;
        }
        let asked: Vec<ArrayView1<'_, f64>> =
            moved.iter().flat_map(|search| search.asked()).collect();
        let products = candidates.products(&asked);
        for (k, search) in moved.iter_mut().enumerate() {
            search.learn(products.column(2 * k), products.column(2 * k + 1));
        }
    }
    searches.into_iter().map(Search::fit).collect()
}

fn searches<'a>(
    candidates: &'a Candidates,
    values: &Array1<f64>,
    kept: &'a [Array1<f64>],
    noise: f64,
) -> Vec<Search<'a>> {
    let residuals: Vec<Array1<f64>> = kept.iter().map(|kept| values * kept).collect();
    let views: Vec<_> = residuals.iter().map(|residual| residual.view()).collect();
    let products = candidates.products(&views);
    let squares = Candidates {
        columns: &candidates.columns * &candidates.columns,
        preference: Vec::new(),
    };
    let views: Vec<_> = kept.iter().map(|kept| kept.view()).collect();
    let squares = squares.products(&views);
    let search = |(k, residual): (usize, Array1<f64>)| Search {
        candidates,
        kept: &kept[k],
        noise,
        left: Left::of(squares.column(k).to_owned()),
        products: products.column(k).to_owned(),
        taken: Taken::none(candidates.rows()),
        coefficients: Vec::new(),
        best: 0,
        best_score: residual.dot(&residual),
        residual,
    };
    residuals.into_iter().enumerate().map(search).collect()
}

/// All columns in their order, but those that are combinations of earlier ones, made ready to fit many lists of values.
pub(crate) struct Basis {
    taken: Taken,
}

impl Basis {
    pub(crate) fn of(candidates: &Candidates) -> Self {
        let rows = candidates.rows();
        let all = Array1::ones(rows);
        let whole = candidates
            .columns
            .map_axis(Axis(1), |column| column.dot(&column));
        let mut left = Left::of(whole);
        let mut taken = Taken::none(rows);
        for column in 0..candidates.count() {
            if !left.is_spent(column) {
                let unit = taken.take(column, candidates.columns.row(column), &all);
                left.without(candidates.columns.dot(&unit).view());
            }
        }
        Self { taken }
    }

    /// The least squares fit of values, and what a fit without point k is off by there.
    pub(crate) fn fit(&self, values: &[f64]) -> (Fit, Vec<f64>) {
        let Taken { steps, leverage } = &self.taken;
        let mut residual = Array1::from(values.to_vec());
        let mut coefficients = Vec::with_capacity(steps.len());
        for step in steps {
            let coefficient = residual.dot(&step.unit);
            residual.scaled_add(-coefficient, &step.unit);
            coefficients.push(coefficient);
        }
        let fit = Fit {
            terms: solve(steps, coefficients),
            triangles: steps.iter().map(|step| step.triangle.clone()).collect(),
        };
        let without = |(r, l): (&f64, &f64)| r / (1.0 - l).max(LEAST_FREEDOM);
        let unseen = residual.iter().zip(leverage).map(without).collect();
        (fit, unseen)
    }
}

/// Squared leave-one-out residuals, raised for the unknowns spent: with P unknowns of K values the misfit to new ones is
/// some K/(K - P) times as large.
fn left_out(residual: &Array1<f64>, leverage: &Array1<f64>, count: f64) -> f64 {
    let unknowns = leverage.sum();
    let squares = residual.iter().zip(leverage);
    let sum: f64 = squares
        .map(|(r, l)| (r / (1.0 - l).max(LEAST_FREEDOM)).powi(2))
        .sum();
    sum * count / (count - unknowns)
}

/// Coefficients of the columns as given from those of the unit vectors, by back substitution.
fn solve(steps: &[Step], coefficients: Vec<f64>) -> Vec<(usize, f64)> {
    let triangles: Vec<&[f64]> = steps.iter().map(|step| &step.triangle[..]).collect();
    let columns = steps.iter().map(|step| step.column);
    columns.zip(back(&triangles, coefficients)).collect()
}

/// R^-1 times some numbers.
fn back(triangles: &[impl AsRef<[f64]>], mut numbers: Vec<f64>) -> Vec<f64> {
    for p in (0..triangles.len()).rev() {
        let triangle = triangles[p].as_ref();
        numbers[p] /= triangle[p];
        for q in 0..p {
            numbers[q] -= triangle[q] * numbers[p];
        }
    }
    numbers
}

/// Fits the values, and says what a fit without point k, chosen without it too, is off by there. A point's mirror image is left out with it, where there are
/// `images`. A misfit of `noise` in the mean is exact.
pub(crate) fn fit(
    candidates: &Candidates,
    values: &[f64],
    noise: f64,
    images: &[usize],
) -> (Fit, Vec<f64>) {
    let groups = with_images(&groups(values.len()), images);
    let left_out = 0..FOLDS.min(values.len());
    let without = |group: usize| -> Array1<f64> {
        groups
            .iter()
            .map(|&g| if g == group { 0.0 } else { 1.0 })
            .collect()
    };
    let mut kept: Vec<Array1<f64>> = left_out.map(without).collect();
    kept.push(Array1::ones(values.len()));
    let mut fits = fits(candidates, &Array1::from(values.to_vec()), &kept, noise);
    let whole = fits.swap_remove(kept.len() - 1);
    let residual =
        |(k, value): (usize, &f64)| value - candidates.combined(&fits[groups[k]].terms, k);
    (whole, values.iter().enumerate().map(residual).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    fn candidates_of(columns: usize, rows: usize) -> Candidates {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let mut unit = || (rng.next_u64() >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
        Candidates::new(vec![1.0; columns], rows, |_, _| unit())
    }

    fn combination(candidates: &Candidates, terms: &[(usize, f64)]) -> Vec<f64> {
        (0..candidates.rows())
            .map(|k| candidates.combined(terms, k))
            .collect()
    }

    #[test]
    fn three_of_two_hundred_columns_are_found_from_twenty_values() {
        let candidates = candidates_of(200, 20);
        let terms = [(17, 3.0), (90, -1.5), (151, 2.0)];
        let values = combination(&candidates, &terms);
        let mut found = fit(&candidates, &values, 1e-13, &[]).0.terms;
        found.sort_by_key(|(column, _)| *column);
        assert_eq!(found.len(), 3);
        for ((i, c), (j, expected)) in found.iter().zip(terms) {
            assert!(*i == j && (c - expected).abs() < 1e-13, "{found:?}");
        }
    }

    #[test]
    fn a_basis_says_what_fits_without_each_point_in_turn_say() {
        let candidates = candidates_of(6, 20);
        let values = candidates_of(7, 20).columns.row(6).to_vec();
        let (found, unseen) = Basis::of(&candidates).fit(&values);
        assert_eq!(found.terms.len(), 6);
        for k in 0..values.len() {
            let of_others = |row: usize| if row < k { row } else { row + 1 };
            let others = Candidates::new(vec![1.0; 6], values.len() - 1, |i, row| {
                candidates.columns[[i, of_others(row)]]
            });
            let values_of_others: Vec<f64> = (0..values.len() - 1)
                .map(|row| values[of_others(row)])
                .collect();
            let (fit, _) = Basis::of(&others).fit(&values_of_others);
            let predicted = candidates.combined(&fit.terms, k);
            assert!((values[k] - predicted - unseen[k]).abs() < 1e-12, "{k}");
        }
    }

    #[test]
    fn values_are_predicted_by_what_the_others_have_found() {
        let candidates = candidates_of(200, 40);
        let values = combination(&candidates, &[(17, 3.0), (90, -1.5), (151, 2.0)]);
        let (_, unseen) = fit(&candidates, &values, 1e-13, &[]);
        assert!(unseen.iter().all(|r| r.abs() < 1e-12), "{unseen:?}");
    }

    #[test]
    fn noise_is_not_explained() {
        // values that have nothing to do with the columns
        let candidates = candidates_of(200, 30);
        let values = candidates_of(231, 30).columns.row(230).to_vec();
        let rms = |r: &[f64]| (r.iter().map(|x| x * x).sum::<f64>() / r.len() as f64).sqrt();
        let (_, unseen) = fit(&candidates, &values, 1e-13, &[]);
        // honest residuals are no smaller than the values themselves
        assert!(
            rms(&unseen) > 0.8 * rms(&values),
            "{} {}",
            rms(&unseen),
            rms(&values)
        );
    }
}
