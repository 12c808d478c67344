//! The search for the hyperparameters of greatest likelihood.
//!
//! Starts are drawn at random and followed a little way on few rows, where a step takes a millisecond. The best of them is then followed to its
//! end on all rows. Starts that lead to different places differ there, on few rows, too.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::kernel::Kernel;
use super::likelihood::log_likelihood;
use super::point_rows::PointRows;
use super::row_pairs::RowPairs;
use crate::model::box_search::{Least, Patience, least};
use crate::model::even_subset::even_subset;

/// Rows on which starts are compared.
pub(crate) const SCREENED_ROWS: usize = 150;
/// Limits to which a start is followed there.
const SCREENED: Patience = Patience {
    iterations: 20,
    gradient: 1e-2,
    change: 1e-4,
};
/// Limits to which the best is followed on all rows.
const FOLLOWED: Patience = Patience {
    iterations: 100,
    gradient: 1e-5,
    change: 1e-9,
};
/// Starts whose likelihoods on few rows differ by less lead to one place.
const SAME_PLACE: f64 = 0.1;
/// Places that are followed to their ends.
const MOST_FOLLOWED: usize = 3;

/// Ranges of the hyperparameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Signal variance, of forces with variance 1.
    pub variance: (f64, f64),
    /// Length scales, of scaled features.
    pub length: (f64, f64),
    /// Noise variance.
    pub noise: (f64, f64),
    /// Variance of the line.
    pub line: (f64, f64),
}

impl Default for Bounds {
    fn default() -> Self {
        Self {
            variance: (1e-3, 1e4),
            length: (1e-2, 1e4),
            noise: (1e-6, 1e1),
            line: (1e-6, 1e4),
        }
    }
}

/// Scope of the search, and how it is done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Search {
    /// Whether each feature has a length of its own.
    pub each: bool,
    /// Whether there is a line.
    pub line: bool,
    /// Starts.
    pub restarts: usize,
    /// Seed of the starts that are drawn.
    pub seed: u64,
    /// Ranges.
    pub bounds: Bounds,
}

/// The kernel of greatest likelihood; None where no covariance has a Cholesky factor.
pub fn search(rows: &PointRows, values: &[f64], wanted: &Search) -> Option<Kernel> {
    let few = even_subset(rows.len(), SCREENED_ROWS);
    let few_values: Vec<f64> = few.iter().map(|row| values[*row]).collect();
    let few_rows = rows.select(&few);
    let screened = Hill::new(&few_rows, &few_values, wanted);
    let starts = starts(screened.lengths, rows.features(), wanted);
    let mut places: Vec<Least> = starts
        .iter()
        .filter_map(|start| screened.climb(start, SCREENED))
        .collect();
    places.sort_by(|a, b| a.value.total_cmp(&b.value));
    places.dedup_by(|next, kept| next.value - kept.value < SAME_PLACE);

    let whole = Hill::new(rows, values, wanted);
    let ends = places
        .iter()
        .take(MOST_FOLLOWED)
        .filter_map(|place| whole.climb(&place.point, FOLLOWED));
    let best = ends.min_by(|a, b| a.value.total_cmp(&b.value))?;
    Some(Kernel::from_logs(&best.point, wanted.line))
}

/// The likelihood of rows over the logarithms of the hyperparameters, within their bounds.
struct Hill<'r> {
    pairs: RowPairs<'r>,
    values: &'r [f64],
    line: bool,
    lengths: usize,
    bounds: Vec<(f64, f64)>,
}

impl<'r> Hill<'r> {
    fn new(rows: &'r PointRows, values: &'r [f64], wanted: &Search) -> Self {
        let lengths = if wanted.each { rows.features() } else { 1 };
        let log = |(low, high): (f64, f64)| (low.ln(), high.ln());
        let mut bounds = vec![log(wanted.bounds.variance)];
        bounds.extend(std::iter::repeat_n(log(wanted.bounds.length), lengths));
        bounds.push(log(wanted.bounds.noise));
        bounds.extend(wanted.line.then(|| log(wanted.bounds.line)));
        Self {
            pairs: RowPairs::new(rows),
            values,
            line: wanted.line,
            lengths,
            bounds,
        }
    }

    /// Climbs from a start: the negative log likelihood made small.
    fn climb(&self, start: &[f64], patience: Patience) -> Option<Least> {
        let negative = |logs: &[f64]| {
            let found = log_likelihood(
                &Kernel::from_logs(logs, self.line),
                &self.pairs,
                self.values,
            )?;
            Some((-found.value, found.gradient.iter().map(|g| -g).collect()))
        };
        least(&negative, Some(&self.bounds), start, patience)
    }
}

/// The first start is what scaled features suggest; the others are drawn about it, evenly by their logarithms.
fn starts(lengths: usize, features: usize, wanted: &Search) -> Vec<Vec<f64>> {
    let usual = (features as f64).sqrt().ln();
    let start = |variance: f64, lengths: Vec<f64>, noise: f64, line: f64| {
        let mut logs = vec![variance];
        logs.extend(lengths);
        logs.push(noise);
        logs.extend(wanted.line.then_some(line));
        logs
    };
    let mut generator = ChaCha8Rng::seed_from_u64(wanted.seed);
    let mut found = vec![start(0.0, vec![usual; lengths], 0.01f64.ln(), 0.0)];
    while found.len() < wanted.restarts {
        let variance = generator.random_range(-1.0..4.0);
        let common = usual + generator.random_range(-2.5..3.0);
        let mut length = || {
            if lengths == 1 {
                common
            } else {
                common + generator.random_range(-1.0..1.0)
            }
        };
        let of_features = (0..lengths).map(|_| length()).collect();
        let noise = generator.random_range(-12.0..0.0);
        found.push(start(
            variance,
            of_features,
            noise,
            generator.random_range(-4.0..2.0),
        ));
    }
    found
}
