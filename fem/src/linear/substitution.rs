//! Substitutions with the interior columns of a supernodal factor L D L^T.
//!
//! A single right-hand side is bound by reading the factor once each way, so columns are taken four at a time: one pass
//! over the right-hand side's rows serves four columns of L. The factor's entries may be stored in single precision, which
//! halves what is read; products and sums are always formed in double precision.

use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::sparse::linalg::cholesky::supernodal::SupernodalLdltRef;
use faer::{Accum, Mat, Par};

/// Columns that one pass over the rows serves.
const BLOCK: usize = 4;

/// A supernode: unit lower columns with D on their diagonal.
struct Supernode<'a, T> {
    start: usize,
    /// Columns that belong to the interior.
    interior: usize,
    columns: usize,
    pattern: &'a [usize],
    values: &'a [T],
    rows: usize,
}

impl<'a, T: Copy + Into<f64>> Supernode<'a, T> {
    fn new(factor: SupernodalLdltRef<'a, usize, T>, index: usize, interior: usize) -> Self {
        let symbolic = factor.symbolic();
        let start = symbolic.supernode_begin()[index];
        let columns = symbolic.supernode_end()[index] - start;
        let first = symbolic.col_ptr_for_row_idx()[index];
        let pattern = &symbolic.row_idx()[first..first + symbolic.nnz_per_super()[index]];
        let values = symbolic.col_ptr_for_val();
        Self {
            start,
            interior: interior.saturating_sub(start).min(columns),
            columns,
            pattern,
            values: &factor.values()[values[index]..values[index + 1]],
            rows: columns + pattern.len(),
        }
    }

    fn column(&self, j: usize) -> &'a [T] {
        &self.values[j * self.rows..(j + 1) * self.rows]
    }

    /// Equation of a row of this supernode.
    fn equation(&self, row: usize) -> usize {
        if row < self.columns {
            self.start + row
        } else {
            self.pattern[row - self.columns]
        }
    }

    fn gather(&self, x: &[f64], work: &mut Vec<f64>) {
        work.clear();
        work.extend_from_slice(&x[self.start..self.start + self.columns]);
        work.extend(self.pattern.iter().map(|&i| x[i]));
    }

    fn scatter(&self, work: &[f64], x: &mut [f64]) {
        let (own, below) = work.split_at(self.columns);
        x[self.start..self.start + self.columns].copy_from_slice(own);
        for (&i, value) in self.pattern.iter().zip(below) {
            x[i] = *value;
        }
    }

    /// Subtracts the columns `j..end` of L, times their unknowns, from the rows below each.
    fn eliminate(&self, j: usize, end: usize, work: &mut [f64]) {
        for k in j..end {
            let value = work[k];
            let column = self.column(k);
            for row in k + 1..end {
                work[row] -= column[row].into() * value;
            }
        }
        let rows = &mut work[j..];
        let (unknowns, rest) = rows.split_at_mut(end - j);
        if let [a, b, c, d] = *unknowns {
            let [ca, cb, cc, cd] = [j, j + 1, j + 2, j + 3].map(|k| &self.column(k)[end..]);
            for ((((r, la), lb), lc), ld) in rest.iter_mut().zip(ca).zip(cb).zip(cc).zip(cd) {
                let [la, lb, lc, ld] = [*la, *lb, *lc, *ld].map(Into::into);
                *r -= la * a + lb * b + lc * c + ld * d;
            }
        } else {
            for (k, value) in (j..end).zip(&*unknowns) {
                for (r, l) in rest.iter_mut().zip(&self.column(k)[end..]) {
                    *r -= (*l).into() * value;
                }
            }
        }
    }

    /// Solves the transposed columns `j..end` against the rows below.
    fn back_substitute(&self, j: usize, end: usize, work: &mut [f64]) {
        let mut sums = [0.0; BLOCK];
        let rest = &work[end..];
        if end - j == BLOCK {
            let columns = [j, j + 1, j + 2, j + 3].map(|k| &self.column(k)[end..]);
            sums = four_products(columns, rest);
        } else {
            for (sum, k) in sums.iter_mut().zip(j..end) {
                *sum = product(&self.column(k)[end..], rest);
            }
        }
        for k in (j..end).rev() {
            let column = self.column(k);
            let near: f64 = (k + 1..end).map(|row| column[row].into() * work[row]).sum();
            work[k] = work[k] / column[k].into() - near - sums[k - j];
        }
    }
}

/// Partial sums that a product is gathered in, so that the compiler may keep them in vector registers.
const LANES: usize = 4;

fn four_products<T: Copy + Into<f64>>(columns: [&[T]; 4], x: &[f64]) -> [f64; 4] {
    let [mut sa, mut sb, mut sc, mut sd] = [[0.0; LANES]; 4];
    let [(a, ta), (b, tb), (c, tc), (d, td)] = columns.map(|column| column.as_chunks::<LANES>());
    let (chunks, tail) = x.as_chunks::<LANES>();
    for ((((x, a), b), c), d) in chunks.iter().zip(a).zip(b).zip(c).zip(d) {
        add_products(&mut sa, a, x);
        add_products(&mut sb, b, x);
        add_products(&mut sc, c, x);
        add_products(&mut sd, d, x);
    }
    let sums = [sa, sb, sc, sd].map(|lanes| lanes.iter().sum::<f64>());
    let tails = [ta, tb, tc, td].map(|column| product(column, tail));
    [0, 1, 2, 3].map(|k| sums[k] + tails[k])
}

fn add_products<T: Copy + Into<f64>>(sums: &mut [f64; LANES], a: &[T; LANES], x: &[f64; LANES]) {
    let products = std::array::from_fn::<f64, LANES, _>(|lane| a[lane].into() * x[lane]);
    *sums = std::array::from_fn(|lane| sums[lane] + products[lane]);
}

fn product<T: Copy + Into<f64>>(a: &[T], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (*a).into() * b).sum()
}

/// Eliminates the interior columns from `x`.
pub(crate) fn forward<T: Copy + Into<f64>>(
    factor: SupernodalLdltRef<'_, usize, T>,
    interior: usize,
    x: &mut [f64],
    work: &mut Vec<f64>,
) {
    for index in 0..factor.symbolic().n_supernodes() {
        let node = Supernode::new(factor, index, interior);
        if node.interior == 0 {
            break;
        }
        node.gather(x, work);
        for j in (0..node.interior).step_by(BLOCK) {
            node.eliminate(j, (j + BLOCK).min(node.interior), work);
        }
        node.scatter(work, x);
    }
}

/// Divides by D and substitutes back through the interior columns, the border of `x` being known.
pub(crate) fn backward<T: Copy + Into<f64>>(
    factor: SupernodalLdltRef<'_, usize, T>,
    interior: usize,
    x: &mut [f64],
    work: &mut Vec<f64>,
) {
    for index in (0..factor.symbolic().n_supernodes()).rev() {
        let node = Supernode::new(factor, index, interior);
        if node.interior == 0 {
            continue;
        }
        node.gather(x, work);
        for j in (0..node.interior).step_by(BLOCK).rev() {
            node.back_substitute(j, (j + BLOCK).min(node.interior), work);
        }
        x[node.start..node.start + node.interior].copy_from_slice(&work[..node.interior]);
    }
}

/// Pivots of the interior columns.
pub(crate) fn pivots<T: Copy + Into<f64>>(
    factor: SupernodalLdltRef<'_, usize, T>,
    interior: usize,
) -> impl Iterator<Item = T> {
    (0..factor.symbolic().n_supernodes()).flat_map(move |index| {
        let node = Supernode::new(factor, index, interior);
        (0..node.interior).map(move |j| node.column(j)[j])
    })
}

/// Number of negative pivots among the interior columns.
pub(crate) fn negative_pivots<T: Copy + Into<f64>>(
    factor: SupernodalLdltRef<'_, usize, T>,
    interior: usize,
) -> usize {
    pivots(factor, interior)
        .filter(|&pivot| pivot.into() < 0.0)
        .count()
}

/// Returns L_b D_b L_b^T, which the elimination of the interior leaves of the border.
pub(crate) fn schur_complement<T: Copy + Into<f64>>(
    factor: SupernodalLdltRef<'_, usize, T>,
    interior: usize,
) -> Mat<f64> {
    let border = factor.symbolic().nrows() - interior;
    let mut lower = Mat::<f64>::zeros(border, border);
    let mut scaled = Mat::<f64>::zeros(border, border);
    for index in 0..factor.symbolic().n_supernodes() {
        let node = Supernode::new(factor, index, interior);
        for j in node.interior..node.columns {
            let (column, target) = (node.column(j), node.start + j - interior);
            let pivot = column[j].into();
            scaled[(target, target)] = pivot;
            for row in j + 1..node.rows {
                let equation = node.equation(row) - interior;
                let entry = column[row].into();
                lower[(equation, target)] = entry;
                scaled[(equation, target)] = entry * pivot;
            }
        }
    }
    let mut product = Mat::<f64>::zeros(border, border);
    matmul(
        product.as_mut(),
        BlockStructure::TriangularLower,
        Accum::Replace,
        scaled.as_ref(),
        BlockStructure::TriangularLower,
        lower.transpose(),
        BlockStructure::UnitTriangularUpper,
        1.0,
        Par::Seq,
    );
    for column in 0..border {
        for row in column + 1..border {
            product[(column, row)] = product[(row, column)];
        }
    }
    product
}
