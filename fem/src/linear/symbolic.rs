//! The symbolic phase of a factorisation: the pattern of the factor, and its memory.

use faer::Side;
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::{SupernodalLdltRef, SymbolicSupernodalCholesky};
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};

use crate::linear::rounding::single;
use crate::linear::sparsity::Pattern;
use crate::linear::substitution;

/// The symbolic phase: what is common to all matrices of one pattern.
#[derive(Debug)]
pub struct Symbolic {
    pattern: Pattern,
    pub(super) cholesky: SymbolicCholesky<usize>,
    /// Equations before the border.
    pub(super) interior: usize,
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

    /// The entries of a factor as a factor of this pattern.
    pub(super) fn ldlt<'a, T>(&'a self, values: &'a [T]) -> SupernodalLdltRef<'a, usize, T> {
        SupernodalLdltRef::new(self.supernodal(), values)
    }

    /// Memory of a factor.
    pub(super) fn zeros(&self) -> Result<Vec<f64>, LinearError> {
        let mut values = Vec::new();
        values
            .try_reserve_exact(self.factor_entries())
            .map_err(|_| LinearError::OutOfMemory {
                unknowns: self.cholesky.nrows(),
            })?;
        values.resize(self.factor_entries(), 0.0);
        Ok(values)
    }

    /// Whether single precision has the range for a factor's entries.
    pub(super) fn fits_single(&self, values: &[f64]) -> bool {
        let mut pivots = substitution::pivots(self.ldlt(values), self.interior);
        pivots.all(|pivot| single(pivot) != 0.0)
            && values.iter().all(|&value| single(value).is_finite())
    }
}

/// The pattern as the library sees it.
pub(super) fn view(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    let n = pattern.column_starts.len() - 1;
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.column_starts, None, &pattern.rows)
}
