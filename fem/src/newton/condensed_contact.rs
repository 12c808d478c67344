//! Contact solved to the end on the condensed border.
//!
//! With all else eliminated, a linear body answers forces on the focused part of its border by the Schur complement `S`
//! alone. For the border's increments `x` the equilibrium of body and ground is then
//!
//! > S x + f(u + x) = g,
//!
//! with the contact forces `f` in full and the condensed right-hand side `g`. `S` is dense but small, so that points
//! which open and close cost no sparse factorisation. For a flat ground this is the minimum of a convex energy: Newton's
//! method with a line search on its slope always gets there, and does so where whole steps didn't.

use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Col, ColRef, Mat, Side};

use crate::linear::factor::Inertia;
use crate::linear::setup::Setup;
use crate::load::contact::ContactSurface;
use crate::load::obstacle::HeightField;
use crate::newton::focus::Focus;
use crate::newton::watch::Watch;
use crate::problem::{Problem, State};
use crate::tensor::Vector;

/// Newton steps on the border; opening and closing settles in ten or less.
const MAX_ITERATIONS: usize = 30;
/// Steps without a new smallest residual after which the last iterate has to do.
const PATIENCE: usize = 5;
/// Residual relative to the forces of the border that is round-off.
const ROUND_OFF: f64 = 1e-12;
/// Steps that are taken whole while the tangent is positive definite. Each finds which points touch at its end, so that
/// they settle in few; a line search lets only some points close at a time, and may take dozens of steps on a soft wall.
const WHOLE_STEPS: usize = 6;
/// Slope after a step, relative to that before, above which the step is shortened.
const SLOPE_SHARE: f64 = 0.5;
/// Secant steps of a line search.
const LINE_STEPS: usize = 6;

/// Contact of the border's faces with the ground, around one state.
pub(crate) struct CondensedContact<'a> {
    pub(super) contact: &'a ContactSurface,
    pub(super) ground: &'a HeightField,
    /// Faces, each with its nodal positions and the places of its unknowns in the border.
    pub(super) faces: Vec<BorderFace>,
    pub(super) anchors: &'a [[f64; 2]],
    pub(super) schur: &'a Mat<f64>,
    /// Focus whose Schur complement that is, and which has its inverse; none where it is another one.
    pub(super) focus: Option<&'a Focus>,
    /// Whether the body holds without the ground, so that an iterate may leave it.
    pub(super) may_leave: bool,
}

pub(super) struct BorderFace {
    index: usize,
    pub(super) positions: Vec<Vector>,
    pub(super) places: Vec<Option<usize>>,
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
            focus: Some(focus),
            may_leave: true,
        })
    }

    /// Increments `x` of the border with S x + f(u + x) = `rhs`, up to a residual of `tolerance`, N, or round-off. Where
    /// the ground's curvature leaves several solutions or none, or once it is to stop, the last iterate.
    pub(crate) fn solve(&self, rhs: &Col<f64>, tolerance: f64, watch: &dyn Watch) -> Col<f64> {
        self.solve_from(Col::zeros(rhs.nrows()), rhs, tolerance, watch)
    }

    /// Solves as [`Self::solve`], from other increments; where the body mustn't leave the ground, they touch it.
    pub(super) fn solve_from(
        &self,
        mut x: Col<f64>,
        rhs: &Col<f64>,
        tolerance: f64,
        watch: &dyn Watch,
    ) -> Col<f64> {
        let mut touching = x.clone();
        let compliance = match self.has_friction() {
            true => self.focus.and_then(Focus::compliance),
            false => None,
        };
        let mut tangent = match compliance {
            Some(_) => Mat::new(),
            None => Mat::zeros(rhs.nrows(), rhs.nrows()),
        };
        let (mut smallest, mut in_vain) = (f64::INFINITY, 0);
        for iteration in 0..MAX_ITERATIONS {
            let mut blocks = Vec::new();
            let forces = match compliance {
                Some(_) => self.forces_and_blocks(&x, &mut blocks),
                None => {
                    tangent.copy_from(self.schur);
                    self.forces(&x, Some(&mut tangent))
                }
            };
            if !self.may_leave && forces.norm_l2() == 0.0 {
                x = faer::Scale(0.5) * (&x + &touching);
                continue;
            }
            touching.copy_from(&x);
            let residual = self.schur * &x + &forces - rhs;
            let round_off = ROUND_OFF * (forces.norm_l2() + rhs.norm_l2());
            let size = residual.norm_l2();
            // Whole steps may raise the residual before they find which points touch.
            in_vain = if size < smallest || iteration <= WHOLE_STEPS {
                0
            } else {
                in_vain + 1
            };
            smallest = if iteration <= WHOLE_STEPS {
                size
            } else {
                smallest.min(size)
            };
            let stopped = watch.is_stopped();
            if size <= tolerance.max(round_off) || in_vain == PATIENCE || stopped {
                break;
            }
            if self.has_friction() {
                let step = match compliance {
                    Some(compliance) => touching_step(compliance, &blocks, &residual),
                    None => PartialPivLu::new(tangent.as_ref()).solve(-&residual),
                };
                let length = self.damping(rhs, &x, &step, size);
                x += faer::Scale(length) * &step;
                continue;
            }
            let whole = iteration < WHOLE_STEPS;
            x += self.energy_step(&tangent, rhs, &x, &residual, whole);
        }
        x
    }

    /// Increments x of the border with (S + f'(u)) x = `rhs`, of the points that touch at u; and how far the ground rises, mm, where its force is to grow
    /// by `lack`, N. With w = x - d e as in `pressing_ground` that is e . f'(u) w = -lack.
    pub(crate) fn solve_linear(&self, rhs: &Col<f64>, lack: Option<f64>) -> (Col<f64>, f64) {
        let unknowns = rhs.nrows();
        let mut stiffness = Mat::zeros(unknowns, unknowns);
        self.forces(&Col::zeros(unknowns), Some(&mut stiffness));
        let tangent = self.schur + &stiffness;
        let held = solve_symmetric(&tangent, rhs);
        let Some(lack) = lack else {
            return (held, 0.0);
        };
        let lift = self.lift(unknowns);
        let pushed = &stiffness * &lift;
        let lifted = solve_symmetric(&tangent, &pushed);
        let resistance = pushed.transpose() * (&lift - &lifted);
        let rise = (lack + pushed.transpose() * &held) / resistance;
        (held + faer::Scale(rise) * &lifted, rise)
    }

    /// Newton's step towards the minimum of the energy, whole where that is wanted and the tangent positive definite.
    fn energy_step(
        &self,
        tangent: &Mat<f64>,
        rhs: &Col<f64>,
        x: &Col<f64>,
        residual: &Col<f64>,
        whole: bool,
    ) -> Col<f64> {
        let (step, is_definite) = match tangent.llt(Side::Lower) {
            Ok(factor) => (factor.solve(-residual), true),
            Err(_) => (tangent.lblt(Side::Lower).solve(-residual), false),
        };
        if whole && is_definite {
            return step;
        }
        let slope = step.transpose() * residual;
        faer::Scale(self.line_search(rhs, x, &step, slope)) * step
    }

    /// Whether there is friction: the tangent isn't symmetric then, and there is no energy.
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
    pub(super) fn forces(&self, x: &Col<f64>, mut stiffness: Option<&mut Mat<f64>>) -> Col<f64> {
        let with_stiffness = stiffness.is_some();
        self.visit_touching(x, with_stiffness, |places, block| {
            if let Some(stiffness) = stiffness.as_deref_mut() {
                add_block(places, block, stiffness);
            }
        })
    }

    /// Contact forces at the increments `x`, and their derivative by the faces that touch.
    fn forces_and_blocks<'s>(&'s self, x: &Col<f64>, blocks: &mut Vec<Block<'s>>) -> Col<f64> {
        self.visit_touching(x, true, |places, block| {
            blocks.push(Block {
                places,
                stiffness: block.to_vec(),
            });
        })
    }

    /// Returns the contact forces at the increments `x`; visits the faces that touch, each with the places of its unknowns and, when asked for, its stiffness by rows.
    fn visit_touching<'s>(
        &'s self,
        x: &Col<f64>,
        with_stiffness: bool,
        mut visit: impl FnMut(&'s [Option<usize>], &[f64]),
    ) -> Col<f64> {
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
            if with_stiffness {
                block.fill(0.0);
            }
            let touches = self.contact.integrate(
                self.ground,
                face.index,
                &positions,
                self.anchors,
                &mut residual,
                with_stiffness.then_some(block.as_mut_slice()),
            );
            if !touches {
                continue;
            }
            for (place, force) in face.places.iter().zip(&residual) {
                if let Some(place) = place {
                    forces[*place] += force;
                }
            }
            visit(&face.places, &block);
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

/// Derivative of the forces of a face that touches.
struct Block<'a> {
    /// Places of its unknowns in the border.
    places: &'a [Option<usize>],
    /// Stiffness by rows.
    stiffness: Vec<f64>,
}

impl Block<'_> {
    /// Numbers of its unknowns that are free, and their places among those that touch.
    fn columns(&self, place_of: &[Option<usize>]) -> Vec<(usize, usize)> {
        let places = self.places.iter().enumerate();
        let free = places.filter_map(|(own, place)| Some((own, place_of[(*place)?]?)));
        free.collect()
    }

    /// Stiffness of these unknowns.
    fn matrix(&self, columns: &[(usize, usize)]) -> Mat<f64> {
        let unknowns = self.places.len();
        let entry = |i: usize, j: usize| self.stiffness[columns[i].0 * unknowns + columns[j].0];
        Mat::from_fn(columns.len(), columns.len(), entry)
    }
}

/// Newton's step -(S + K)^-1 `residual` by the compliance C = S^-1. K is that of the unknowns that touch alone, so that their part of the step solves
/// (1 + C K) x = -C `residual`: of half of the border's unknowns, in an eighth of the work.
fn touching_step(compliance: &Mat<f64>, blocks: &[Block<'_>], residual: &Col<f64>) -> Col<f64> {
    let mut touching: Vec<usize> = blocks
        .iter()
        .flat_map(|block| block.places.iter().flatten().copied())
        .collect();
    touching.sort_unstable();
    touching.dedup();
    let mut place_of = vec![None; residual.nrows()];
    for (place, &border) in touching.iter().enumerate() {
        place_of[border] = Some(place);
    }
    let count = touching.len();
    let free = compliance * -residual;
    let own = Mat::from_fn(count, count, |i, j| compliance[(touching[i], touching[j])]);
    let mut matrix = Mat::<f64>::identity(count, count);
    let faces: Vec<_> = blocks
        .iter()
        .map(|block| {
            let columns = block.columns(&place_of);
            let stiffness = block.matrix(&columns);
            (columns, stiffness)
        })
        .collect();
    for (columns, stiffness) in &faces {
        // C K face by face: K is as sparse as the surface.
        let of_face = Mat::from_fn(count, columns.len(), |i, k| own[(i, columns[k].1)]);
        let product = of_face * stiffness;
        for (k, &(_, place)) in columns.iter().enumerate() {
            let mut column = matrix.col_mut(place);
            column += product.col(k);
        }
    }
    let of_free = Col::from_fn(count, |k| free[touching[k]]);
    let step = PartialPivLu::new(matrix.as_ref()).solve(of_free);
    let mut forces = -residual;
    for (columns, stiffness) in &faces {
        let own = Col::from_fn(columns.len(), |k| step[columns[k].1]);
        let pushed = stiffness * own;
        for (&(_, place), force) in columns.iter().zip(pushed.iter()) {
            forces[touching[place]] -= force;
        }
    }
    compliance * forces
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
        Err(_) => matrix.lblt(Side::Lower).solve(rhs),
    }
}

/// Border increments without any ground, in place of the right-hand side: S x = rhs.
pub(crate) fn solve_free(schur: &Mat<f64>, rhs: &mut [f64]) {
    let solution = solve_symmetric(schur, &ColRef::from_slice(rhs).to_owned());
    for (target, value) in rhs.iter_mut().zip(solution.iter()) {
        *target = *value;
    }
}

/// Signs of the eigenvalues of a dense symmetric matrix: by Sylvester's law those of the blocks, of one or two rows, of its
/// pivoted factorisation.
pub(crate) fn inertia(matrix: &Mat<f64>) -> Inertia {
    // A factorisation may not notice what isn't a number.
    if !matrix.norm_l2().is_finite() {
        return Inertia { negative: 1 };
    }
    if matrix.llt(Side::Lower).is_ok() {
        return Inertia::default();
    }
    let factor = matrix.lblt(Side::Lower);
    let (diagonal, below) = (
        factor.B_diag().column_vector(),
        factor.B_subdiag().column_vector(),
    );
    let (mut negative, mut k) = (0, 0);
    while k < matrix.nrows() {
        if below[k] == 0.0 {
            negative += usize::from(diagonal[k] < 0.0);
            k += 1;
        } else {
            let determinant = diagonal[k] * diagonal[k + 1] - below[k] * below[k];
            negative += if determinant < 0.0 {
                1
            } else {
                2 * usize::from(diagonal[k] < 0.0)
            };
            k += 2;
        }
    }
    Inertia { negative }
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::linalg::solvers::DenseSolveCore;

    #[test]
    fn the_step_of_what_touches_is_that_of_the_whole_border() {
        const BORDER: usize = 7;
        let wave = |i: usize, j: usize| (1.3 * i as f64 + 0.7 * j as f64).sin();
        let skew = Mat::from_fn(BORDER, BORDER, wave);
        let schur = &skew * skew.transpose() + Mat::<f64>::identity(BORDER, BORDER);
        let compliance = schur.llt(Side::Lower).expect("positive definite").inverse();
        // Two faces that share an unknown, one of which is held; friction makes them unsymmetric.
        let faces = [[Some(1), None, Some(4)], [Some(4), Some(6), Some(2)]];
        let blocks = faces.each_ref().map(|places| Block {
            places,
            stiffness: (0..9).map(|k| 40.0 * wave(k, 2 * k)).collect(),
        });
        let residual = Col::from_fn(BORDER, |k| wave(k, 5));
        let mut tangent = schur.clone();
        for block in &blocks {
            add_block(block.places, &block.stiffness, &mut tangent);
        }
        let whole = PartialPivLu::new(tangent.as_ref()).solve(-&residual);
        let step = touching_step(&compliance, &blocks, &residual);
        // Round-off times the stiffnesses' ratio, some hundreds.
        assert!((step - &whole).norm_l2() < 1e-12 * whole.norm_l2());
    }

    #[test]
    fn inertia_counts_negative_eigenvalues() {
        // diag(3, -1, 2, -5) seen from a skew basis, and a zero diagonal that needs a block of two rows
        let skew = Mat::from_fn(4, 4, |i, j| {
            if i >= j {
                1.0 + (i + 2 * j) as f64
            } else {
                0.0
            }
        });
        let signs = Mat::from_fn(4, 4, |i, j| {
            if i == j {
                [3.0, -1.0, 2.0, -5.0][i]
            } else {
                0.0
            }
        });
        assert_eq!(inertia(&(&skew * signs * skew.transpose())).negative, 2);
        let exchange = Mat::from_fn(2, 2, |i, j| f64::from(u8::from(i != j)));
        assert_eq!(inertia(&exchange).negative, 1);
        assert_eq!(inertia(&Mat::<f64>::identity(3, 3)).negative, 0);
        assert_eq!(inertia(&Mat::from_fn(2, 2, |_, _| f64::NAN)).negative, 1);
    }
}
