//! Sparse symmetric factorisation: one symbolic phase per pattern, many numeric ones.

use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, LltRef, SymbolicCholesky, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

use crate::sparsity::Pattern;

/// The symbolic phase: what is common to all matrices of one pattern. Cheap to clone.
#[derive(Debug, Clone)]
pub struct Symbolic {
    pattern: Arc<Pattern>,
    cholesky: Arc<SymbolicCholesky<usize>>,
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
    /// Analyses a pattern whose equations are already in elimination order.
    ///
    /// # Errors
    /// [`LinearError::OutOfMemory`].
    pub fn new(pattern: Arc<Pattern>) -> Result<Self, LinearError> {
        let cholesky = factorize_symbolic_cholesky(
            view(&pattern),
            Side::Upper,
            SymmetricOrdering::Identity,
            CholeskySymbolicParams::default(),
        )
        .map_err(|_| LinearError::OutOfMemory {
            unknowns: pattern.column_starts.len() - 1,
        })?;
        Ok(Self {
            pattern,
            cholesky: Arc::new(cholesky),
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
}

fn view(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    let n = pattern.column_starts.len() - 1;
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.column_starts, None, &pattern.rows)
}

/// Whether a matrix is positive definite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Definiteness {
    /// All pivots are positive: the equilibrium is stable.
    Positive,
    /// Some are negative.
    Indefinite,
}

/// Numeric factor with its own memory; used again and again.
pub struct Factor {
    symbolic: Symbolic,
    values: Vec<f64>,
    memory: MemBuffer,
    definiteness: Definiteness,
}

impl std::fmt::Debug for Factor {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Factor")
            .field("entries", &self.values.len())
            .finish_non_exhaustive()
    }
}

impl Factor {
    /// Allocates the memory of a factor.
    ///
    /// # Errors
    /// [`LinearError::OutOfMemory`].
    pub fn new(symbolic: Symbolic) -> Result<Self, LinearError> {
        let unknowns = symbolic.cholesky.nrows();
        let cholesky = &symbolic.cholesky;
        let need = cholesky
            .factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default())
            .or(cholesky.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default()))
            .or(cholesky.solve_in_place_scratch::<f64>(1, Par::Seq));
        let out_of_memory = LinearError::OutOfMemory { unknowns };
        let memory = MemBuffer::try_new(need).map_err(|_| out_of_memory)?;
        let mut values = Vec::new();
        values
            .try_reserve_exact(cholesky.len_val())
            .map_err(|_| out_of_memory)?;
        values.resize(cholesky.len_val(), 0.0);
        Ok(Self {
            symbolic,
            values,
            memory,
            definiteness: Definiteness::Positive,
        })
    }

    /// Factorises the matrix with these entries (upper triangle in the pattern's order). Cholesky first; when a pivot
    /// isn't positive, LDL^T without pivoting.
    ///
    /// # Errors
    /// [`LinearError::ZeroPivot`].
    pub fn factorise(&mut self, entries: &[f64]) -> Result<Definiteness, LinearError> {
        let matrix = SparseColMatRef::new(view(&self.symbolic.pattern), entries);
        let cholesky = &self.symbolic.cholesky;
        let stack = MemStack::new(&mut self.memory);
        let positive = cholesky.factorize_numeric_llt(
            &mut self.values,
            matrix,
            Side::Upper,
            LltRegularization::default(),
            Par::Seq,
            stack,
            Default::default(),
        );
        self.definiteness = if positive.is_ok() {
            Definiteness::Positive
        } else {
            let stack = MemStack::new(&mut self.memory);
            cholesky
                .factorize_numeric_ldlt(
                    &mut self.values,
                    matrix,
                    Side::Upper,
                    LdltRegularization::default(),
                    Par::Seq,
                    stack,
                    Default::default(),
                )
                .map_err(
                    |faer::linalg::cholesky::ldlt::factor::LdltError::ZeroPivot { index }| {
                        LinearError::ZeroPivot { index }
                    },
                )?;
            Definiteness::Indefinite
        };
        Ok(self.definiteness)
    }

    /// Solves with the last factor, in place.
    pub fn solve(&mut self, rhs: &mut [f64]) {
        let n = rhs.len();
        let rhs = MatMut::from_column_major_slice_mut(rhs, n, 1);
        let stack = MemStack::new(&mut self.memory);
        let cholesky = &self.symbolic.cholesky;
        match self.definiteness {
            Definiteness::Positive => {
                LltRef::new(cholesky, &self.values).solve_in_place_with_conj(
                    Conj::No,
                    rhs,
                    Par::Seq,
                    stack,
                );
            }
            Definiteness::Indefinite => {
                LdltRef::new(cholesky, &self.values).solve_in_place_with_conj(
                    Conj::No,
                    rhs,
                    Par::Seq,
                    stack,
                );
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pattern() -> Arc<Pattern> {
        Arc::new(Pattern {
            column_starts: vec![0, 1, 3, 5],
            rows: vec![0, 0, 1, 1, 2],
        })
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
    fn one_symbolic_phase_serves_definite_and_indefinite_matrices() {
        let mut factor = Factor::new(Symbolic::new(pattern()).unwrap()).unwrap();
        let cases = [
            ([4.0, 1.0, 5.0, -1.0, 3.0], Definiteness::Positive),
            ([4.0, 1.0, -5.0, -1.0, 3.0], Definiteness::Indefinite),
        ];
        for (entries, expected) in cases {
            assert_eq!(factor.factorise(&entries).unwrap(), expected);
            let mut x = [1.0, 2.0, 3.0];
            factor.solve(&mut x);
            assert!(residual(&entries, &x) < 1e-14);
        }
    }
}
