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
/// A point that decides its own value alone has no residual: it counts as if this share of it were left.
const LEAST_FREEDOM: f64 = 1e-6;
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

/// The search among the columns. All vectors are as long as the columns, zero where a value is left out, and the columns stay
/// as they are: what is left of one beside those taken has the same product with the residual, which is orthogonal to all
/// of those, and a square less by that of its product with the newest unit vector.
struct Search<'a> {
    candidates: &'a Candidates,
    residual: Vec<f64>,
    /// by column, its square, and what is left of it beside those taken
    norms: Vec<f64>,
    left: Vec<f64>,
    /// by column, its product with the residual
    products: Vec<f64>,
    steps: Vec<Step>,
}

impl<'a> Search<'a> {
    fn new(candidates: &'a Candidates, residual: Vec<f64>, kept: &[f64]) -> Self {
        let squares = |column: &Vec<f64>| -> f64 {
            let kept: Vec<f64> = column.iter().zip(kept).map(|(x, k)| x * k).collect();
            dot(&kept, &kept)
        };
        let norms: Vec<f64> = candidates.columns.iter().map(squares).collect();
        let columns = candidates.columns.iter();
        Self {
            products: columns.map(|column| dot(column, &residual)).collect(),
            left: norms.clone(),
            norms,
            candidates,
            residual,
            steps: Vec::new(),
        }
    }

    /// The column that lowers the misfit most.
    fn next(&self) -> Option<usize> {
        let gain = |index: usize| {
            if self.left[index] <= SPENT * self.norms[index] {
                return 0.0;
            }
            self.candidates.preference[index] * self.products[index].powi(2) / self.left[index]
        };
        let gains = (0..self.left.len()).map(|index| (index, gain(index)));
        gains
            .filter(|(_, gain)| *gain > 0.0)
            .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
            .map(|(index, _)| index)
    }

    fn take(&mut self, column: usize, kept: &[f64]) {
        let whole = &self.candidates.columns[column];
        let mut unit: Vec<f64> = whole.iter().zip(kept).map(|(x, k)| x * k).collect();
        // Twice, because the first time leaves the rounding of what it takes away.
        for _ in 0..2 {
            for step in &self.steps {
                let share = dot(&step.unit, &unit);
                subtract(&mut unit, &step.unit, share);
            }
        }
        let length = dot(&unit, &unit).sqrt();
        unit.iter_mut().for_each(|x| *x /= length);
        let coefficient = dot(&self.residual, &unit);
        subtract(&mut self.residual, &unit, coefficient);
        for (index, other) in self.candidates.columns.iter().enumerate() {
            self.left[index] -= dot(other, &unit).powi(2);
            self.products[index] = dot(other, &self.residual);
        }
        let units = self.steps.iter().map(|step| &step.unit);
        let triangle = units.chain([&unit]).map(|q| dot(q, whole)).collect();
        self.steps.push(Step {
            column,
            unit,
            triangle,
            coefficient,
        });
    }
}

/// Fits the values whose row is `kept` (1, else 0); a misfit of `noise` in the mean is exact.
pub(crate) fn fit(candidates: &Candidates, values: &[f64], kept: &[f64], noise: f64) -> Fit {
    let rows: f64 = kept.iter().sum();
    let residual = values.iter().zip(kept).map(|(y, k)| y * k).collect();
    let mut search = Search::new(candidates, residual, kept);
    let mut leverage = vec![0.0; kept.len()];
    let (mut best, mut best_score) = (0, dot(&search.residual, &search.residual));
    let most = (rows * MOST_UNKNOWNS) as usize;
    let exact = noise * noise * rows;
    while search.steps.len() < most && best_score > exact && search.steps.len() < best + PATIENCE {
        let Some(column) = search.next() else {
            break;
        };
        search.take(column, kept);
        let unit = search.steps.last().map_or(&[][..], |step| &step.unit);
        for (l, q) in leverage.iter_mut().zip(unit) {
            *l += q * q;
        }
        let score = left_out(&search.residual, &leverage, rows);
        if score < best_score {
            (best, best_score) = (search.steps.len(), score);
        }
    }
    let mut steps = search.steps;
    steps.truncate(best);
    let coefficients = steps.iter().map(|step| step.coefficient).collect();
    Fit {
        terms: solve(&steps, coefficients),
        triangles: steps.into_iter().map(|step| step.triangle).collect(),
    }
}

/// All columns in their order, but those that are combinations of earlier ones, made ready to fit many lists of values.
pub(crate) struct Basis {
    steps: Vec<Step>,
    leverage: Vec<f64>,
}

impl Basis {
    pub(crate) fn of(candidates: &Candidates) -> Self {
        let rows = candidates.columns.first().map_or(0, Vec::len);
        let kept = vec![1.0; rows];
        let mut search = Search::new(candidates, vec![0.0; rows], &kept);
        for column in 0..candidates.columns.len() {
            if search.left[column] > SPENT * search.norms[column] {
                search.take(column, &kept);
            }
        }
        let mut leverage = vec![0.0; rows];
        for step in &search.steps {
            for (l, q) in leverage.iter_mut().zip(&step.unit) {
                *l += q * q;
            }
        }
        Self {
            steps: search.steps,
            leverage,
        }
    }

    /// The least squares fit of values, and what a fit without point k is off by there.
    pub(crate) fn fit(&self, values: &[f64]) -> (Fit, Vec<f64>) {
        let mut residual = values.to_vec();
        let mut coefficients = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            let coefficient = dot(&residual, &step.unit);
            subtract(&mut residual, &step.unit, coefficient);
            coefficients.push(coefficient);
        }
        let triangles = self.steps.iter().map(|step| step.triangle.clone());
        let fit = Fit {
            terms: solve(&self.steps, coefficients),
            triangles: triangles.collect(),
        };
        let without = |(r, l): (&f64, &f64)| r / (1.0 - l).max(LEAST_FREEDOM);
        let unseen = residual.iter().zip(&self.leverage).map(without).collect();
        (fit, unseen)
    }
}

/// Squared leave-one-out residuals, raised for the unknowns spent: with P unknowns of K values the misfit to new ones is
/// some K/(K - P) times as large.
fn left_out(residual: &[f64], leverage: &[f64], count: f64) -> f64 {
    let unknowns: f64 = leverage.iter().sum();
    let squares = residual.iter().zip(leverage);
    let sum: f64 = squares
        .map(|(r, l)| (r / (1.0 - l).max(LEAST_FREEDOM)).powi(2))
        .sum();
    sum * count / (count - unknowns)
}

/// Coefficients of the columns as given from those of the unit vectors, by back substitution.
fn solve(steps: &[Step], mut coefficients: Vec<f64>) -> Vec<(usize, f64)> {
    for p in (0..steps.len()).rev() {
        coefficients[p] /= steps[p].triangle[p];
        for q in 0..p {
            coefficients[q] -= steps[p].triangle[q] * coefficients[p];
        }
    }
    let columns = steps.iter().map(|step| step.column);
    columns.zip(coefficients).collect()
}

/// What a fit without point k, chosen without it too, is off by there. A point's mirror image is left out with it, where there are
/// `images`.
pub(crate) fn cross_validate(
    candidates: &Candidates,
    values: &[f64],
    noise: f64,
    images: &[usize],
) -> Vec<f64> {
    let groups = with_images(&groups(values.len()), images);
    let mut residuals = values.to_vec();
    for group in 0..FOLDS.min(values.len()) {
        let kept: Vec<f64> = groups
            .iter()
            .map(|g| if *g == group { 0.0 } else { 1.0 })
            .collect();
        let fit = fit(candidates, values, &kept, noise);
        for (k, residual) in residuals.iter_mut().enumerate() {
            if groups[k] == group {
                let terms = fit.terms.iter();
                *residual -= terms
                    .map(|(column, c)| c * candidates.columns[*column][k])
                    .sum::<f64>();
            }
        }
    }
    residuals
}

/// The groups, with the second of two mirror images in the first one's.
fn with_images(groups: &[usize], images: &[usize]) -> Vec<usize> {
    let first = |k: usize| images.get(k).map_or(k, |&image| image.min(k));
    (0..groups.len()).map(|k| groups[first(k)]).collect()
}

/// Which group each point belongs to. Groups are equally large and follow the order of the multiples of the golden ratio modulo 1:
/// points of Sobol's sequence at equal strides lie in one slab of each input, to which all others would have to extrapolate.
fn groups(count: usize) -> Vec<usize> {
    let place = |k: usize| (k as f64 * std::f64::consts::GOLDEN_RATIO).fract();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| place(*a).total_cmp(&place(*b)));
    let mut groups = vec![0; count];
    for (rank, k) in order.into_iter().enumerate() {
        groups[k] = rank * FOLDS.min(count) / count;
    }
    groups
}

/// In several sums at once, which a processor adds side by side.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
    let (a, last_of_a) = a.as_chunks::<LANES>();
    let (b, last_of_b) = b.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let last = last_of_a.iter().zip(last_of_b).map(|(a, b)| a * b);
    sums.iter().sum::<f64>() + last.sum::<f64>()
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
        let mut found = fit(&candidates, &values, &[1.0; 20], 1e-13).terms;
        found.sort_by_key(|(column, _)| *column);
        assert_eq!(found.len(), 3);
        for ((i, c), (j, expected)) in found.iter().zip(terms) {
            assert!(*i == j && (c - expected).abs() < 1e-13, "{found:?}");
        }
    }

    #[test]
    fn a_basis_says_what_fits_without_each_point_in_turn_say() {
        let candidates = candidates_of(6, 20);
        let values = candidates_of(7, 20).columns[6].clone();
        let (found, unseen) = Basis::of(&candidates).fit(&values);
        assert_eq!(found.terms.len(), 6);
        for k in 0..values.len() {
            let without = |list: &Vec<f64>| -> Vec<f64> {
                let others = list.iter().enumerate().filter(|(row, _)| *row != k);
                others.map(|(_, x)| *x).collect()
            };
            let others = Candidates {
                columns: candidates.columns.iter().map(without).collect(),
                preference: vec![1.0; 6],
            };
            let (fit, _) = Basis::of(&others).fit(&without(&values));
            let terms = fit.terms.iter();
            let predicted: f64 = terms.map(|(i, c)| c * candidates.columns[*i][k]).sum();
            assert!((values[k] - predicted - unseen[k]).abs() < 1e-12, "{k}");
        }
    }

    #[test]
    fn values_are_predicted_by_what_the_others_have_found() {
        let candidates = candidates_of(200, 40);
        let values = combination(&candidates, &[(17, 3.0), (90, -1.5), (151, 2.0)]);
        let unseen = cross_validate(&candidates, &values, 1e-13, &[]);
        assert!(unseen.iter().all(|r| r.abs() < 1e-12), "{unseen:?}");
    }

    #[test]
    fn groups_are_equal_and_no_slab_of_sobols_points() {
        for count in [5, 8, 20, 101] {
            let groups = groups(count);
            for group in 0..FOLDS.min(count) {
                let size = groups.iter().filter(|g| **g == group).count();
                assert!(size == count / FOLDS || size == count.div_ceil(FOLDS));
            }
        }
        // one remainder by eight would be a slab
        let groups = groups(64);
        for group in 0..FOLDS {
            let members = (0..64usize).filter(|k| groups[*k] == group);
            let remainders: std::collections::HashSet<usize> = members.map(|k| k % 8).collect();
            assert!(remainders.len() > 2, "{remainders:?}");
        }
    }

    #[test]
    fn noise_is_not_explained() {
        // values that have nothing to do with the columns
        let candidates = candidates_of(200, 30);
        let values = candidates_of(231, 30).columns[230].clone();
        let rms = |r: &[f64]| (dot(r, r) / r.len() as f64).sqrt();
        let unseen = cross_validate(&candidates, &values, 1e-13, &[]);
        // honest residuals are no smaller than the values themselves
        assert!(
            rms(&unseen) > 0.8 * rms(&values),
            "{} {}",
            rms(&unseen),
            rms(&values)
        );
    }
}
