//! Sparse symmetric factorisation L D L^T: one symbolic phase per pattern, many numeric ones.
//!
//! The last equations may form a *border*: the factor then eliminates the others, the interior, and hands over what
//! is left, the dense Schur complement of the border. There nonlinear terms that act on the border alone - contact -
//! can be solved to the end without touching the sparse factor again.

use std::sync::Arc;

use faer::Mat;
use faer::Par;
use faer::Side;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::{LdltError, LdltRegularization};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::{SupernodalLdltRef, SymbolicSupernodalCholesky};
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};

use crate::sparsity::Pattern;
use crate::substitution;

/// The symbolic phase: what is common to all matrices of one pattern.
#[derive(Debug)]
pub struct Symbolic {
    pattern: Pattern,
    cholesky: SymbolicCholesky<usize>,
    interior: usize,
}

/// The linear solver failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum LinearError {
    /// The factor doesn't fit in memory.
    #[error("the factor of {unknowns} unknowns does not fit in memory")]
    OutOfMemory {
        /// Size of the system.
        unknowns: usize,
    },
    /// A pivot is zero: the tangent is singular.
    #[error("pivot {index} is zero: the tangent is singular")]
    ZeroPivot {
        /// Equation in elimination order.
        index: usize,
    },
}

impl Symbolic {
    /// Analyses a pattern whose equations are already in elimination order; those from `interior` on are the border.
    ///
    /// # Errors
    /// [`LinearError::OutOfMemory`].
    pub fn new(pattern: Pattern, interior: usize) -> Result<Self, LinearError> {
        let parameters = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        let cholesky = factorize_symbolic_cholesky(
            view(&pattern),
            Side::Upper,
            SymmetricOrdering::Identity,
            parameters,
        )
        .map_err(|_| LinearError::OutOfMemory {
            unknowns: pattern.column_starts.len() - 1,
        })?;
        Ok(Self {
            pattern,
            cholesky,
            interior,
        })
    }

    /// Pattern of the matrices.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.cholesky.len_val()
    }

    fn supernodal(&self) -> &SymbolicSupernodalCholesky<usize> {
        match self.cholesky.raw() {
            SymbolicCholeskyRaw::Supernodal(supernodal) => supernodal,
            SymbolicCholeskyRaw::Simplicial(_) => {
                unreachable!("a supernodal factor was asked for")
            }
        }
    }
}

fn view(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    let n = pattern.column_starts.len() - 1;
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.column_starts, None, &pattern.rows)
}

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
    values: Vec<f64>,
}

impl Factor {
    /// Allocates the memory of a factor.
    ///
    /// # Errors
    /// [`LinearError::OutOfMemory`].
    pub fn new(symbolic: Arc<Symbolic>) -> Result<Self, LinearError> {
        let mut values = Vec::new();
        values
            .try_reserve_exact(symbolic.factor_entries())
            .map_err(|_| LinearError::OutOfMemory {
                unknowns: symbolic.cholesky.nrows(),
            })?;
        values.resize(symbolic.factor_entries(), 0.0);
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
        let matrix = SparseColMatRef::new(view(&self.symbolic.pattern), entries);
        self.symbolic
            .cholesky
            .factorize_numeric_ldlt(
                &mut self.values,
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

    fn ldlt(&self) -> SupernodalLdltRef<'_, usize, f64> {
        SupernodalLdltRef::new(self.symbolic.supernodal(), &self.values)
    }

    /// Signs of the interior's pivots.
    pub fn interior_inertia(&self) -> Inertia {
        substitution::inertia(self.ldlt(), self.symbolic.interior)
    }

    /// Schur complement of the border.
    pub fn schur_complement(&self) -> Mat<f64> {
        substitution::schur_complement(self.ldlt(), self.symbolic.interior)
    }

    /// Eliminates the interior from a right-hand side: its border then belongs to the Schur complement.
    pub fn eliminate(&self, rhs: &mut [f64], workspace: &mut Workspace) {
        let interior = self.symbolic.interior;
        substitution::forward(self.ldlt(), interior, rhs, &mut workspace.column);
    }

    /// Completes a solution whose border is known, in what [`Factor::eliminate`] left.
    pub fn complete(&self, solution: &mut [f64], workspace: &mut Workspace) {
        let interior = self.symbolic.interior;
        substitution::backward(self.ldlt(), interior, solution, &mut workspace.column);
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
}
