//! Factors in both precisions on random matrices.

use std::sync::Arc;

use faer::Mat;
use faer::linalg::solvers::Solve;
use fem::linear::factor::{Factor, Workspace};
use fem::linear::sparsity::Pattern;
use fem::linear::symbolic::Symbolic;

/// Solves in place, the border by its Schur complement.
fn solve(factor: &Factor, schur: &Mat<f64>, x: &mut [f64], workspace: &mut Workspace) {
    factor.eliminate(x, workspace);
    let interior = x.len() - schur.nrows();
    let border = faer::ColMut::from_slice_mut(&mut x[interior..]);
    schur.partial_piv_lu().solve_in_place(border);
    factor.complete(x, workspace);
}

/// Pattern and entries of a symmetric matrix that dominates its diagonal, from its off-diagonal entries by columns of
/// the upper triangle; those beyond +-1 are left out.
fn dominant(size: usize, offdiagonal: &[f64]) -> (Pattern, Vec<f64>, Mat<f64>) {
    let mut matrix = Mat::<f64>::zeros(size, size);
    let mut pattern = Pattern {
        column_starts: vec![0],
        rows: Vec::new(),
    };
    let mut values = offdiagonal.iter();
    for column in 0..size {
        for (row, &value) in (0..column).zip(values.by_ref()) {
            if value.abs() <= 1.0 {
                pattern.rows.push(row);
                matrix[(row, column)] = value;
                matrix[(column, row)] = value;
                matrix[(row, row)] += value.abs();
                matrix[(column, column)] += value.abs();
            }
        }
        matrix[(column, column)] += 0.1;
        pattern.rows.push(column);
        pattern.column_starts.push(pattern.rows.len());
    }
    let columns = pattern.column_starts.windows(2).enumerate();
    let entries = columns.flat_map(|(column, ends)| {
        let rows = &pattern.rows[ends[0]..ends[1]];
        let matrix = &matrix;
        rows.iter().map(move |&row| matrix[(row, column)])
    });
    let entries = entries.collect();
    (pattern, entries, matrix)
}

proptest::proptest! {
    /// N. Higham, Accuracy and Stability of Numerical Algorithms, theorem 10.4: the computed solution belongs to a matrix
    /// that is off by (3 n + 1) u |L| |D| |L^T|, whose norm is at most n times the matrix's; rounding L, D and L^T
    /// adds three roundings of their own.
    #[test]
    fn the_residual_is_that_of_the_precision(
        size in 1usize..48,
        border in 0usize..8,
        offdiagonal in proptest::collection::vec(-2.0..2.0, 48 * 47 / 2),
        rhs in proptest::collection::vec(-1.0..1.0, 48),
    ) {
        let (pattern, entries, matrix) = dominant(size, &offdiagonal);
        let symbolic = Symbolic::new(pattern, size.saturating_sub(border)).expect("little memory");
        let symbolic = Arc::new(symbolic);
        let mut workspace = Workspace::new(&symbolic).expect("little memory");
        let mut double = Factor::new(symbolic).expect("little memory");
        double.factorise(&entries, &mut workspace).expect("no zero pivot");
        let schur = double.schur_complement();
        let single = double.clone().rounded();
        let n = size as f64;
        let roundings = (3.0 * n + 1.0) * f64::EPSILON / 2.0;
        let single_roundings = 3.0 * f64::from(f32::EPSILON) / 2.0;
        for (factor, share) in [(&double, roundings), (&single, roundings + single_roundings)] {
            let rhs = faer::ColRef::from_slice(&rhs[..size]);
            let mut x: Vec<f64> = rhs.iter().copied().collect();
            solve(factor, &schur, &mut x, &mut workspace);
            let x = faer::ColRef::from_slice(&x);
            let residual = (rhs - &matrix * x).norm_l2();
            let bound = share * n * matrix.norm_l2() * x.norm_l2();
            assert!(residual <= bound, "{residual} beyond {bound}");
        }
    }
}
