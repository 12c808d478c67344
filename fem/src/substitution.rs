//! Substitutions with the interior columns of a supernodal factor L D L^T.
//!
//! A single right-hand side is bound by reading the factor once each way, so columns are taken four at a time: one pass
//! over the right-hand side's rows serves four columns of L.

use faer::Mat;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLdltRef;

use crate::linear::Inertia;

/// Columns that one pass over the rows serves.
const BLOCK: usize = 4;

/// One supernode: unit lower columns with D on their diagonal.
struct Supernode<'a> {
    start: usize,
    /// Columns that belong to the interior.
    interior: usize,
    columns: usize,
    pattern: &'a [usize],
    values: &'a [f64],
    rows: usize,
}

impl<'a> Supernode<'a> {
    fn new(factor: SupernodalLdltRef<'a, usize, f64>, index: usize, interior: usize) -> Self {
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

    fn column(&self, j: usize) -> &'a [f64] {
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
                work[row] -= column[row] * value;
            }
        }
        let rows = &mut work[j..];
        let (unknowns, rest) = rows.split_at_mut(end - j);
        if let [a, b, c, d] = *unknowns {
            let [ca, cb, cc, cd] = [j, j + 1, j + 2, j + 3].map(|k| &self.column(k)[end..]);
            for ((((r, la), lb), lc), ld) in rest.iter_mut().zip(ca).zip(cb).zip(cc).zip(cd) {
                *r -= la * a + lb * b + lc * c + ld * d;
            }
        } else {
            for (k, value) in (j..end).zip(&*unknowns) {
                for (r, l) in rest.iter_mut().zip(&self.column(k)[end..]) {
                    *r -= l * value;
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
            let near: f64 = (k + 1..end).map(|row| column[row] * work[row]).sum();
            work[k] = work[k] / column[k] - near - sums[k - j];
        }
    }
}

/// Lanes of a sum that the compiler may keep in one vector register.
const LANES: usize = 4;

fn four_products(columns: [&[f64]; 4], x: &[f64]) -> [f64; 4] {
    let mut lanes = [[0.0; LANES]; 4];
    let whole = x.len() / LANES * LANES;
    let [a, b, c, d] = columns.map(|column| column[..whole].chunks_exact(LANES));
    for ((((x, a), b), c), d) in x[..whole].chunks_exact(LANES).zip(a).zip(b).zip(c).zip(d) {
        for lane in 0..LANES {
            lanes[0][lane] += a[lane] * x[lane];
            lanes[1][lane] += b[lane] * x[lane];
            lanes[2][lane] += c[lane] * x[lane];
            lanes[3][lane] += d[lane] * x[lane];
        }
    }
    [0, 1, 2, 3].map(|k| {
        lanes[k].iter().sum::<f64>()
            + (whole..x.len())
                .map(|row| columns[k][row] * x[row])
                .sum::<f64>()
    })
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Eliminates the interior columns from `x`.
pub(crate) fn forward(
    factor: SupernodalLdltRef<'_, usize, f64>,
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
pub(crate) fn backward(
    factor: SupernodalLdltRef<'_, usize, f64>,
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

/// Negative pivots among the interior columns.
pub(crate) fn inertia(factor: SupernodalLdltRef<'_, usize, f64>, interior: usize) -> Inertia {
    let negative = (0..factor.symbolic().n_supernodes())
        .map(|index| {
            let node = Supernode::new(factor, index, interior);
            (0..node.interior)
                .filter(|&j| node.column(j)[j] < 0.0)
                .count()
        })
        .sum();
    Inertia { negative }
}

/// What the elimination of the interior leaves of the border: L_b D_b L_b^T.
pub(crate) fn schur_complement(
    factor: SupernodalLdltRef<'_, usize, f64>,
    interior: usize,
) -> Mat<f64> {
    let border = factor.symbolic().nrows() - interior;
    let mut lower = Mat::<f64>::zeros(border, border);
    let mut scaled = Mat::<f64>::zeros(border, border);
    for index in 0..factor.symbolic().n_supernodes() {
        let node = Supernode::new(factor, index, interior);
        for j in node.interior..node.columns {
            let (column, target) = (node.column(j), node.start + j - interior);
            let pivot = column[j];
            lower[(target, target)] = 1.0;
            scaled[(target, target)] = pivot;
            for row in j + 1..node.rows {
                let equation = node.equation(row) - interior;
                lower[(equation, target)] = column[row];
                scaled[(equation, target)] = column[row] * pivot;
            }
        }
    }
    scaled * lower.transpose()
}
