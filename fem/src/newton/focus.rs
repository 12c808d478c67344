//! The part of the border that one solve touches, with the rest of the border eliminated.
//!
//! A tangent that serves many loads has a border wide enough for all of them. One solve needs less of it, and what
//! contact costs grows with the cube of its size.

use std::sync::OnceLock;

use faer::linalg::solvers::{DenseSolveCore, Llt, PartialPivLu, Solve};
use faer::{Col, Mat, Side};

use crate::linear::setup::Setup;
use crate::problem::Problem;

/// Error of an inverse, by what it gives back of a column, above which there is none: Newton's steps would stall.
const LOST: f64 = 1e-8;

/// The focused part of a border.
#[derive(Debug)]
pub(crate) struct Focus {
    /// Contact faces that the focus serves.
    pub(crate) faces: Vec<bool>,
    /// Schur complement of the focused unknowns.
    pub(crate) schur: Mat<f64>,
    /// Place of each border unknown in the focus.
    places: Vec<Option<usize>>,
    focused: Vec<usize>,
    rest: Vec<usize>,
    /// Inverse of the Schur complement, once it was asked for; none where it is singular.
    compliance: OnceLock<Option<Mat<f64>>>,
    /// Factor of the rest, and its coupling to the focused unknowns: rest x focused.
    eliminated: Option<(Llt<f64>, Mat<f64>)>,
}

impl Focus {
    /// Focuses on these contact faces, all of which the border serves.
    pub(crate) fn new(
        problem: &Problem,
        setup: &Setup,
        schur: &Mat<f64>,
        faces: Vec<bool>,
    ) -> Self {
        let mut is_focused = vec![false; schur.nrows()];
        if let Some(contact) = &problem.contact {
            let of_faces = contact.surface.iter().zip(&faces).filter(|(_, of)| **of);
            for (nodes, _) in of_faces {
                for place in setup.equations.of(nodes).filter_map(|e| setup.in_border(e)) {
                    is_focused[place] = true;
                }
            }
        }
        let (focused, rest): (Vec<usize>, Vec<usize>) =
            (0..schur.nrows()).partition(|&k| is_focused[k]);
        let part = |rows: &[usize], columns: &[usize]| {
            Mat::from_fn(rows.len(), columns.len(), |i, j| {
                schur[(rows[i], columns[j])]
            })
        };
        match part(&rest, &rest).llt(Side::Lower) {
            Ok(factor) => {
                let coupling = part(&rest, &focused);
                let schur =
                    part(&focused, &focused) - coupling.transpose() * factor.solve(&coupling);
                Self::with_parts(faces, schur, focused, rest, Some((factor, coupling)))
            }
            // Where the rest alone is unstable all of the border stays in focus.
            Err(_) => {
                let all = (0..schur.nrows()).collect();
                Self::with_parts(faces, schur.clone(), all, Vec::new(), None)
            }
        }
    }

    fn with_parts(
        faces: Vec<bool>,
        schur: Mat<f64>,
        focused: Vec<usize>,
        rest: Vec<usize>,
        eliminated: Option<(Llt<f64>, Mat<f64>)>,
    ) -> Self {
        let mut places = vec![None; focused.len() + rest.len()];
        for (place, &border) in focused.iter().enumerate() {
            places[border] = Some(place);
        }
        Self {
            faces,
            schur,
            places,
            focused,
            rest,
            compliance: OnceLock::new(),
            eliminated,
        }
    }

    /// Inverse of the Schur complement; `None` where it is singular, as that of a body which rests on nothing but the ground. That of a wall which is pressed in far is
    /// indefinite, and has one.
    pub(crate) fn compliance(&self) -> Option<&Mat<f64>> {
        self.compliance
            .get_or_init(|| inverse(&self.schur))
            .as_ref()
    }

    /// Place of a border unknown in the focus.
    pub(crate) fn place(&self, border: usize) -> Option<usize> {
        self.places[border]
    }

    /// Right-hand side of the focused unknowns, the rest eliminated.
    pub(crate) fn reduce(&self, rhs: &[f64]) -> Col<f64> {
        let mut reduced = Col::from_fn(self.focused.len(), |k| rhs[self.focused[k]]);
        if let Some((factor, coupling)) = &self.eliminated {
            let rest = Col::from_fn(self.rest.len(), |k| rhs[self.rest[k]]);
            reduced -= coupling.transpose() * factor.solve(&rest);
        }
        reduced
    }

    /// Replaces a right-hand side by the solution whose focused part is known.
    pub(crate) fn expand(&self, focused: &Col<f64>, rhs: &mut [f64]) {
        if let Some((factor, coupling)) = &self.eliminated {
            let rest = Col::from_fn(self.rest.len(), |k| rhs[self.rest[k]]);
            let solution = factor.solve(&(rest - coupling * focused));
            for (&place, value) in self.rest.iter().zip(solution.iter()) {
                rhs[place] = *value;
            }
        }
        for (&place, value) in self.focused.iter().zip(focused.iter()) {
            rhs[place] = *value;
        }
    }
}

/// Inverse of a symmetric matrix; `None` where it is singular.
fn inverse(matrix: &Mat<f64>) -> Option<Mat<f64>> {
    let inverse = match matrix.llt(Side::Lower) {
        Ok(factor) => factor.inverse(),
        Err(_) => PartialPivLu::new(matrix.as_ref()).inverse(),
    };
    let column = Col::<f64>::ones(matrix.nrows());
    let lost = matrix * (&inverse * &column) - &column;
    (lost.norm_l2() <= LOST * column.norm_l2()).then_some(inverse)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_indefinite_matrix_has_an_inverse_and_a_singular_one_has_none() {
        // A mirror through the plane across a direction, whose own inverse it is; and the projection onto that plane.
        const SIZE: usize = 5;
        let direction = Col::from_fn(SIZE, |k| (1.0 + k as f64) / 55f64.sqrt());
        let across = |share: f64| {
            let one = Mat::<f64>::identity(SIZE, SIZE);
            one - faer::Scale(share) * &direction * direction.transpose()
        };
        let mirror = across(2.0);
        let found = inverse(&mirror).expect("regular");
        assert!((found - &mirror).norm_max() < 1e-14);
        assert!(inverse(&across(1.0)).is_none());
    }
}
