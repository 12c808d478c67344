//! Memory that a fit may take, before it begins.

use estimation::recipe::{Recipe, SplitKind};
use estimation::validation::{MOST_TESTED, candidates};

/// Numbers a row has for each signal: it, its slope, its rolling mean and variance.
const PER_SIGNAL: u64 = 4;
/// Copies of all rows that a model makes while it is judged: the rows that it learns from, on their scale, and once more for what it works on.
const COPIES: u64 = 3;
/// Matrices of a process that are there at once: a covariance, its factor, and one of its derivatives.
const MATRICES: u64 = 3;
const NUMBER: u64 = 8;
/// Numbers that are kept of a row that a candidate was tested on: its place and group, truth, estimate, deviation and the training mean.
const PER_TESTED: u64 = 6;

/// Counts of what all recordings have.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RowSizes {
    /// Count of the rows, with a force or without.
    pub rows: usize,
    /// Count of the signals.
    pub signals: usize,
    /// Count of the forces.
    pub forces: usize,
}

/// An upper bound of the memory, bytes, but for what doesn't grow with the rows.
pub(crate) fn fit_memory_bytes(sizes: &RowSizes, recipe: &Recipe, threads: usize) -> u64 {
    let wide = |count: usize| count as u64;
    let [rows, signals, forces] = [sizes.rows, sizes.signals, sizes.forces].map(wide);
    let features = rows * signals * PER_SIGNAL * NUMBER;
    // Whether first readings are taken off is tried both ways: each has the features and the rows of every force.
    let held = features * (1 + 2 * forces);
    // A process is tried of whatever kinds the recipe has, to tell whether first readings are taken off.
    let gpr = &recipe.models.gpr;
    let most = wide(gpr.most_rows.max(gpr.search_rows)).min(rows);
    let each = MATRICES * most * most * NUMBER;
    let candidates = wide(candidates(recipe).len()) * forces;
    let splits = wide(SplitKind::ALL.len());
    let tested = candidates * splits * rows.min(wide(MOST_TESTED)) * PER_TESTED * NUMBER;
    held + tested + wide(threads.max(1)) * (features * COPIES + each)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_grows_with_rows_threads_and_processes() {
        let sizes = |rows| RowSizes {
            rows,
            signals: 1,
            forces: 1,
        };
        let usual = Recipe::default();
        let bytes = |rows, threads| fit_memory_bytes(&sizes(rows), &usual, threads);
        // 12 models and the mean, on five splits.
        let tested = |rows: u64| 13 * 5 * rows * 6 * 8;
        assert_eq!(
            bytes(100, 1),
            100 * 32 * 6 + tested(100) + 3 * 100 * 100 * 8
        );
        assert!(bytes(200, 1) > 2 * bytes(100, 1));
        assert!(bytes(100, 4) > bytes(100, 1) + 2 * 3 * 100 * 100 * 8);
        // A process of all defaults has 3000 rows at most, whatever comes.
        assert!(bytes(20_000, 1) < 20_000 * 32 * 6 + tested(10_000) + 3 * 3001 * 3001 * 8);
    }
}
