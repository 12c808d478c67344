//! Contact solved to the end on the condensed border.
//!
//! With all else eliminated, a linear body answers forces on the focused part of its border by the Schur complement `S`
//! alone. For the border's increments `x` the equilibrium of body and ground is then
//!
//! > S x + f(u + x) = g,
//!
//! with the contact forces `f` in full and the condensed right-hand side `g`. `S` is dense but small, so that points
//! which open and close cost no sparse factorisation. For a flat ground this is the minimum of a convex energy: Newton's
//! method with a line search on its slope always gets there.

use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Col, ColRef, Mat, Side};

use crate::contact::ContactSurface;
use crate::focus::Focus;
use crate::linear::Inertia;
use crate::obstacle::HeightField;
use crate::problem::{Problem, State};
use crate::setup::Setup;
use crate::tensor::Vector;

/// Newton steps on the border; opening and closing settles in ten or less.
const MAX_ITERATIONS: usize = 30;
/// Steps without a new smallest residual after which the last iterate has to do.
const PATIENCE: usize = 5;
/// Residual relative to the forces of the border that is round-off.
const ROUND_OFF: f64 = 1e-12;
/// Slope after a step, relative to that before, above which the step is shortened.
const SLOPE_SHARE: f64 = 0.5;
/// Secant steps of a line search.
const LINE_STEPS: usize = 6;

/// Contact of the border's faces with the ground, around one state.
pub(crate) struct CondensedContact<'a> {
    contact: &'a ContactSurface,
    ground: &'a HeightField,
    /// Faces, each with its nodal positions and the places of its unknowns in the border.
    faces: Vec<BorderFace>,
    anchors: &'a [[f64; 2]],
    schur: &'a Mat<f64>,
}

struct BorderFace {
    index: usize,
    positions: Vec<Vector>,
    places: Vec<Option<usize>>,
}

impl<'a> CondensedContact<'a> {
    pub(crate) fn new(
        problem: &'a Problem,
        setup: &Setup,
        focus: &'a Focus,
        state: &'a State,
        ground: &'a HeightField,
    ) -> Option<Self> {
        let contact = problem.contact.as_ref()?;
        let faces = (0..contact.surface.face_count())
            .filter(|&index| focus.faces[index])
            .map(|index| {
                let nodes = contact.surface.face(index);
                BorderFace {
                    index,
                    positions: nodes
                        .iter()
                        .map(|&n| state.position(&problem.mesh, n))
                        .collect(),
                    places: setup
                        .equations
                        .of(nodes)
                        .map(|e| focus.place(setup.in_border(e)?))
                        .collect(),
                }
            })
            .collect();
        Some(Self {
            contact,
            ground,
            faces,
            anchors: &state.anchors,
            schur: &focus.schur,
        })
    }

    /// Increments `x` of the border with S x + f(u + x) = `rhs`, up to a residual of `tolerance`, N, or round-off. Where
    /// the ground's curvature leaves several solutions or none, the last iterate.
    pub(crate) fn solve(&self, rhs: &Col<f64>, tolerance: f64) -> Col<f64> {
        let mut x = Col::<f64>::zeros(rhs.nrows());
        let mut tangent = Mat::zeros(rhs.nrows(), rhs.nrows());
        let (mut smallest, mut in_vain) = (f64::INFINITY, 0);
        for _ in 0..MAX_ITERATIONS {
            tangent.copy_from(self.schur);
            let forces = self.forces(&x, Some(&mut tangent));
            let residual = self.schur * &x + &forces - rhs;
            let round_off = ROUND_OFF * (forces.norm_l2() + rhs.norm_l2());
            let size = residual.norm_l2();
            in_vain = if size < smallest { 0 } else { in_vain + 1 };
            smallest = smallest.min(size);
            if size <= tolerance.max(round_off) || in_vain == PATIENCE {
                break;
            }
            let (step, length);
            if self.has_friction() {
                step = PartialPivLu::new(tangent.as_ref()).solve(-&residual);
                length = self.damping(rhs, &x, &step, residual.norm_l2());
            } else {
                step = solve_symmetric(&tangent, &-&residual);
                let slope = step.transpose() * &residual;
                length = self.line_search(rhs, &x, &step, slope);
            }
            x += faer::Scale(length) * &step;
        }
        x
    }

    /// With friction the tangent isn't symmetric, and there is no energy.
    fn has_friction(&self) -> bool {
        !self.anchors.is_empty()
    }

    /// Largest halving of the step that reduces the residual, or the last one tried.
    fn damping(&self, rhs: &Col<f64>, x: &Col<f64>, step: &Col<f64>, start: f64) -> f64 {
        let mut length = 1.0;
        for _ in 0..LINE_STEPS {
            let trial = x + faer::Scale(length) * step;
            let residual = self.schur * &trial + self.forces(&trial, None) - rhs;
            if residual.norm_l2() < start {
                break;
            }
            length *= 0.5;
        }
        length
    }

    /// Fraction of the step at which the energy's slope along it has fallen enough.
    fn line_search(&self, rhs: &Col<f64>, x: &Col<f64>, step: &Col<f64>, start: f64) -> f64 {
        let slope_at = |t: f64| {
            let trial = x + faer::Scale(t) * step;
            let residual = self.schur * &trial + self.forces(&trial, None) - rhs;
            step.transpose() * &residual
        };
        let (mut low, mut slope_low) = (0.0, start);
        let (mut high, mut slope_high) = (1.0, slope_at(1.0));
        let mut length = 1.0;
        for _ in 0..LINE_STEPS {
            if start >= 0.0 || slope_high <= SLOPE_SHARE * start.abs() {
                break;
            }
            length = low + (high - low) * slope_low / (slope_low - slope_high);
            let slope = slope_at(length);
            if slope.abs() <= SLOPE_SHARE * start.abs() {
                break;
            }
            if slope < 0.0 {
                (low, slope_low) = (length, slope);
            } else {
                (high, slope_high) = (length, slope);
            }
        }
        length
    }

    /// Contact forces at the increments `x`; their derivative is added to `stiffness`.
    fn forces(&self, x: &Col<f64>, mut stiffness: Option<&mut Mat<f64>>) -> Col<f64> {
        let mut forces = Col::<f64>::zeros(x.nrows());
        let unknowns = self.faces.first().map_or(0, |face| face.places.len());
        let mut residual = vec![0.0; unknowns];
        let mut block = vec![0.0; unknowns * unknowns];
        let mut positions = vec![[0.0; 3]; unknowns / 3];
        for face in &self.faces {
            residual.fill(0.0);
            positions.copy_from_slice(&face.positions);
            for (position, place) in positions.as_flattened_mut().iter_mut().zip(&face.places) {
                *position += place.map_or(0.0, |place| x[place]);
            }
            let tangent = stiffness.is_some();
            if tangent {
                block.fill(0.0);
            }
            let block_target = tangent.then_some(block.as_mut_slice());
            let touches = self.contact.integrate(
                self.ground,
                face.index,
                &positions,
                self.anchors,
                &mut residual,
                block_target,
            );
            if !touches {
                continue;
            }
            for (place, force) in face.places.iter().zip(&residual) {
                if let Some(place) = place {
                    forces[*place] += force;
                }
            }
            if let Some(stiffness) = stiffness.as_deref_mut() {
                add_block(&face.places, &block, stiffness);
            }
        }
        forces
    }

    /// Signs of the eigenvalues of S plus the contact's stiffness.
    pub(crate) fn inertia(&self) -> Inertia {
        let mut tangent = self.schur.clone();
        self.forces(&Col::zeros(tangent.nrows()), Some(&mut tangent));
        inertia(&tangent)
    }
}

/// Adds a face's stiffness, by rows, to a dense matrix.
fn add_block(places: &[Option<usize>], block: &[f64], stiffness: &mut Mat<f64>) {
    let n = places.len();
    for (r, row) in places.iter().enumerate() {
        for (c, column) in places.iter().enumerate() {
            if let (Some(row), Some(column)) = (*row, *column) {
                stiffness[(row, column)] += block[r * n + c];
            }
        }
    }
}

fn solve_symmetric(matrix: &Mat<f64>, rhs: &Col<f64>) -> Col<f64> {
    match matrix.llt(Side::Lower) {
        Ok(factor) => factor.solve(rhs),
        Err(_) => PartialPivLu::new(matrix.as_ref()).solve(rhs),
    }
}

/// Border increments without any ground, in place of the right-hand side: S x = rhs.
pub(crate) fn solve_free(schur: &Mat<f64>, rhs: &mut [f64]) {
    let solution = solve_symmetric(schur, &ColRef::from_slice(rhs).to_owned());
    for (target, value) in rhs.iter_mut().zip(solution.iter()) {
        *target = *value;
    }
}

/// Signs of the eigenvalues of a dense symmetric matrix.
pub(crate) fn inertia(matrix: &Mat<f64>) -> Inertia {
    if matrix.llt(Side::Lower).is_ok() {
        return Inertia::default();
    }
    let negative = matrix
        .self_adjoint_eigenvalues(Side::Lower)
        .map_or(1, |values| values.iter().filter(|v| **v < 0.0).count());
    Inertia { negative }
}
