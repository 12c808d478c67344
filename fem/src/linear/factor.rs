//! Sparse symmetric factorisation L D L^T: one symbolic phase per pattern, many numeric ones.
//!
//! The last equations may form a *border*: the factor then eliminates the others, the interior, and hands over what
//! is left, the dense Schur complement of the border. There nonlinear terms that act on the border alone - contact -
//! can be solved to the end without touching the sparse factor again.

use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::{LdltError, LdltRegularization};
use faer::sparse::SparseColMatRef;
use faer::{Mat, Par, Side};

use crate::linear::rounding::all_single;
use crate::linear::substitution;
use crate::linear::symbolic::{LinearError, Symbolic, view};

/// Signs of the pivots, which are those of the eigenvalues (Sylvester's law of inertia).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Inertia {
    /// Number of negative eigenvalues: 0 in a stable equilibrium.
    pub negative: usize,
}

impl Inertia {
    /// Whether no eigenvalue is negative.
    pub fn is_positive(self) -> bool {
        self.negative == 0
    }
}

/// Numeric factor; its memory can be used again.
#[derive(Debug, Clone)]
pub struct Factor {
    symbolic: Arc<Symbolic>,
    values: Values,
}

/// Entries of L, with D on its diagonal.
#[derive(Debug, Clone)]
enum Values {
    Double(Vec<f64>),
    /// A factor that is only read any more.
    Single(Vec<f32>),
}

impl Factor {
    /// Allocates the memory of a factor.
    ///
    /// # Errors
    /// [`LinearError::OutOfMemory`].
    pub fn new(symbolic: Arc<Symbolic>) -> Result<Self, LinearError> {
        let values = Values::Double(symbolic.zeros()?);
        Ok(Self { symbolic, values })
    }

    /// Factorises the matrix with these entries (upper triangle in the pattern's order). There is no pivoting: a
    /// matrix that isn't positive definite loses digits where pivots are small.
    ///
    /// # Errors
    /// [`LinearError`].
    pub fn factorise(
        &mut self,
        entries: &[f64],
        workspace: &mut Workspace,
    ) -> Result<(), LinearError> {
        let symbolic = &self.symbolic;
        if let Values::Single(_) = self.values {
            self.values = Values::Double(symbolic.zeros()?);
        }
        let Values::Double(values) = &mut self.values else {
            unreachable!("the values have just been made double");
        };
        let matrix = SparseColMatRef::new(view(symbolic.pattern()), entries);
        symbolic
            .cholesky
            .factorize_numeric_ldlt(
                values,
                matrix,
                Side::Upper,
                LdltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut workspace.memory),
                Default::default(),
            )
            .map(|_| ())
            .map_err(|LdltError::ZeroPivot { index }| LinearError::ZeroPivot { index })
    }

    /// Rounds the entries to single precision, for solves that correct their own errors: half the memory, and half of it to read in a substitution. A
    /// factor that single precision can't hold stays as it is.
    #[must_use]
    pub fn rounded(mut self) -> Self {
        self.values = match self.values {
            Values::Double(values) if self.symbolic.fits_single(&values) => {
                all_single(values).map_or_else(Values::Double, Values::Single)
            }
            values => values,
        };
        self
    }

    /// Signs of the interior's pivots.
    pub(crate) fn interior_inertia(&self) -> Inertia {
        let interior = self.symbolic.interior;
        let negative = match &self.values {
            Values::Double(v) => substitution::negative_pivots(self.symbolic.ldlt(v), interior),
            Values::Single(v) => substitution::negative_pivots(self.symbolic.ldlt(v), interior),
        };
        Inertia { negative }
    }

    /// Schur complement of the border, in the unit of the matrix.
    pub fn schur_complement(&self) -> Mat<f64> {
        let interior = self.symbolic.interior;
        match &self.values {
            Values::Double(v) => substitution::schur_complement(self.symbolic.ldlt(v), interior),
            Values::Single(v) => substitution::schur_complement(self.symbolic.ldlt(v), interior),
        }
    }

    /// Eliminates the interior from a right-hand side: its border then belongs to the Schur complement.
    pub fn eliminate(&self, rhs: &mut [f64], workspace: &mut Workspace) {
        let (interior, work) = (self.symbolic.interior, &mut workspace.column);
        match &self.values {
            Values::Double(v) => substitution::forward(self.symbolic.ldlt(v), interior, rhs, work),
            Values::Single(v) => substitution::forward(self.symbolic.ldlt(v), interior, rhs, work),
        }
    }

    /// Completes a solution whose border is known, in what [`Factor::eliminate`] left.
    pub fn complete(&self, solution: &mut [f64], workspace: &mut Workspace) {
        let (interior, work) = (self.symbolic.interior, &mut workspace.column);
        let x = solution;
        match &self.values {
            Values::Double(v) => substitution::backward(self.symbolic.ldlt(v), interior, x, work),
            Values::Single(v) => substitution::backward(self.symbolic.ldlt(v), interior, x, work),
        }
    }
}

/// Working memory of a factorisation and its substitutions.
pub struct Workspace {
    memory: MemBuffer,
    column: Vec<f64>,
}

impl std::fmt::Debug for Workspace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Workspace").finish_non_exhaustive()
    }
}

impl Workspace {
    /// Allocates what the matrices of one pattern need.
    ///
    /// # Errors
    /// [`LinearError::OutOfMemory`].
    pub fn new(symbolic: &Symbolic) -> Result<Self, LinearError> {
        let need = symbolic
            .cholesky
            .factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default());
        let memory = MemBuffer::try_new(need).map_err(|_| LinearError::OutOfMemory {
            unknowns: symbolic.cholesky.nrows(),
        })?;
        Ok(Self {
            memory,
            column: Vec::new(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linear::sparsity::Pattern;

    /// Tridiagonal 3 x 3 by columns: a00, a01 a11, a12 a22.
    fn factor(entries: &[f64], interior: usize) -> (Factor, Workspace) {
        let pattern = Pattern {
            column_starts: vec![0, 1, 3, 5],
            rows: vec![0, 0, 1, 1, 2],
        };
        let symbolic = Arc::new(Symbolic::new(pattern, interior).expect("a small pattern"));
        let mut workspace = Workspace::new(&symbolic).expect("little memory");
        let mut factor = Factor::new(symbolic).expect("little memory");
        factor
            .factorise(entries, &mut workspace)
            .expect("no zero pivot");
        (factor, workspace)
    }

    fn residual(entries: &[f64], x: &[f64]) -> f64 {
        let a = [
            [entries[0], entries[1], 0.0],
            [entries[1], entries[2], entries[3]],
            [0.0, entries[3], entries[4]],
        ];
        let b = [1.0, 2.0, 3.0];
        (0..3)
            .map(|i| (a[i].iter().zip(x).map(|(a, x)| a * x).sum::<f64>() - b[i]).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn definite_and_indefinite_matrices_are_solved_and_told_apart() {
        for (entries, negative) in [
            ([4.0, 1.0, 5.0, -1.0, 3.0], 0),
            ([4.0, 1.0, -5.0, -1.0, 3.0], 1),
            ([-4.0, 1.0, -5.0, -1.0, -3.0], 3),
        ] {
            let (factor, mut workspace) = factor(&entries, 3);
            assert_eq!(factor.interior_inertia(), Inertia { negative });
            let mut x = [1.0, 2.0, 3.0];
            factor.eliminate(&mut x, &mut workspace);
            factor.complete(&mut x, &mut workspace);
            assert!(residual(&entries, &x) < 1e-14);
        }
    }

    #[test]
    fn the_border_is_solved_apart() {
        let entries = [4.0, 1.0, 5.0, -1.0, 3.0];
        for interior in [0, 1, 2] {
            let (factor, mut workspace) = factor(&entries, interior);
            let schur = factor.schur_complement();
            assert_eq!(schur.nrows(), 3 - interior);
            let mut x = [1.0, 2.0, 3.0];
            factor.eliminate(&mut x, &mut workspace);
            let border = faer::linalg::solvers::Solve::solve(
                &schur.partial_piv_lu(),
                faer::ColRef::from_slice(&x[interior..]),
            );
            for (k, value) in border.iter().enumerate() {
                x[interior + k] = *value;
            }
            factor.complete(&mut x, &mut workspace);
            assert!(residual(&entries, &x) < 1e-14, "{interior}");
        }
    }

    #[test]
    fn a_factor_beyond_single_precision_stays_double() {
        let entries = [4.0, 1.0, 5.0, -1.0, 3.0];
        for (scale, is_single) in [(1.0, true), (1e40, false), (1e-40, false)] {
            let (factor, _) = factor(&entries.map(|entry| scale * entry), 3);
            let rounded = factor.rounded();
            assert_eq!(matches!(rounded.values, Values::Single(_)), is_single);
            assert!(rounded.interior_inertia().is_positive());
        }
    }

    #[test]
    fn a_rounded_factor_can_be_factorised_again() {
        let entries = [4.0, 1.0, 5.0, -1.0, 3.0];
        let (factor, mut workspace) = factor(&entries, 3);
        let mut again = factor.clone().rounded();
        again
            .factorise(&entries, &mut workspace)
            .expect("no zero pivot");
        let [mut x, mut y] = [[1.0, 2.0, 3.0]; 2];
        for (factor, x) in [(&factor, &mut x), (&again, &mut y)] {
            factor.eliminate(x, &mut workspace);
            factor.complete(x, &mut workspace);
        }
        assert_eq!(x, y);
    }
}
