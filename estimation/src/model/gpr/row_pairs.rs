//! Sums over the features of each pair of rows, made once for all hyperparameters that are tried.

use faer::Mat;

use super::point_rows::PointRows;

/// Lower triangles of rows x rows.
#[derive(Debug, Clone)]
pub struct RowPairs<'r> {
    rows: &'r PointRows,
    /// sum_j (x_j - x'_j)^2
    squares: Mat<f64>,
    /// sum_j x_j x'_j / d
    products: Mat<f64>,
}

impl<'r> RowPairs<'r> {
    /// Pairs all rows.
    pub fn new(rows: &'r PointRows) -> Self {
        let n = rows.len();
        let (mut squares, mut products) = (Mat::zeros(n, n), Mat::zeros(n, n));
        let share = 1.0 / rows.features().max(1) as f64;
        for j in 0..n {
            for column in rows.columns() {
                add_squares(
                    &mut squares.col_as_slice_mut(j)[j..],
                    &column[j..],
                    column[j],
                    1.0,
                );
                add_products(
                    &mut products.col_as_slice_mut(j)[j..],
                    &column[j..],
                    share * column[j],
                );
            }
        }
        Self {
            rows,
            squares,
            products,
        }
    }

    /// The rows.
    pub fn rows(&self) -> &'r PointRows {
        self.rows
    }

    /// sum_j (x_j - x'_j)^2 between row j and those from it on.
    pub(crate) fn squares_from(&self, j: usize) -> &[f64] {
        &self.squares.col_as_slice(j)[j..]
    }

    /// sum_j x_j x'_j / d between row j and those from it on.
    pub(crate) fn products_from(&self, j: usize) -> &[f64] {
        &self.products.col_as_slice(j)[j..]
    }
}

/// Adds ((column - x) / length)^2 to each entry.
pub(crate) fn add_squares(squares: &mut [f64], column: &[f64], x: f64, inverse_length: f64) {
    for (s, y) in squares.iter_mut().zip(column) {
        let d = (y - x) * inverse_length;
        *s += d * d;
    }
}

/// Adds column * x to each entry.
pub fn add_products(sums: &mut [f64], column: &[f64], x: f64) {
    for (sum, y) in sums.iter_mut().zip(column) {
        *sum += y * x;
    }
}
