//! Columns made orthogonal, one after the other, and what is left of the others beside them.

use ndarray::{Array1, ArrayView1};

/// A column is spent when this little of its square is left beside those taken.
const SPENT: f64 = 1e-10;

/// Columns taken so far, made orthogonal. Vectors are as long as the columns, zero where a value is left out.
pub(super) struct Taken {
    pub(super) steps: Vec<Step>,
    /// sum of the unit vectors' squares, by value
    pub(super) leverage: Array1<f64>,
}

/// A column taken, and its unit vector.
pub(super) struct Step {
    pub(super) column: usize,
    pub(super) unit: Array1<f64>,
    /// products of the unit vectors so far, this one last, with the column as given
    pub(super) triangle: Vec<f64>,
}

impl Taken {
    pub(super) fn none(rows: usize) -> Self {
        Self {
            steps: Vec::new(),
            leverage: Array1::zeros(rows),
        }
    }

    /// Takes one more, and gives its unit vector.
    pub(super) fn take(
        &mut self,
        column: usize,
        whole: ArrayView1<'_, f64>,
        kept: &Array1<f64>,
    ) -> Array1<f64> {
        let mut unit = &whole * kept;
        // Twice, because the first time leaves the rounding of what it takes away.
        for _ in 0..2 {
            for step in &self.steps {
                let share = step.unit.dot(&unit);
                unit.scaled_add(-share, &step.unit);
            }
        }
        unit /= unit.dot(&unit).sqrt();
        self.leverage += &(&unit * &unit);
        let units = self.steps.iter().map(|step| &step.unit);
        let triangle = units.chain([&unit]).map(|q| q.dot(&whole)).collect();
        self.steps.push(Step {
            column,
            unit: unit.clone(),
            triangle,
        });
        unit
    }
}

/// Remainders of the columns beside those taken, as squares.
pub(super) struct Left {
    whole: Array1<f64>,
    pub(super) left: Array1<f64>,
}

impl Left {
    /// Begins with columns whose kept values have these squares.
    pub(super) fn of(whole: Array1<f64>) -> Self {
        Self {
            left: whole.clone(),
            whole,
        }
    }

    pub(super) fn is_spent(&self, column: usize) -> bool {
        self.left[column] <= SPENT * self.whole[column]
    }

    /// `products`: of the columns with the newest unit vector.
    pub(super) fn without(&mut self, products: ArrayView1<'_, f64>) {
        self.left
            .zip_mut_with(&products, |left, product| *left -= product * product);
    }
}
