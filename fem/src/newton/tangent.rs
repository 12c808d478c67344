//! A factorised tangent, and the step it gives at any state near its own.
//!
//! Contact is left out of the matrix and solved in full on the border (see `condensed_contact`), so one factor serves
//! all states whose body - not contact - is nearly as stiff. To hold a body that rests on nothing but the ground, springs
//! are added to the border before the factorisation and taken off its Schur complement.

use std::sync::Arc;

use faer::Mat;

use crate::linear::factor::{Factor, Inertia, Workspace};
use crate::linear::setup::Setup;
use crate::linear::symbolic::LinearError;
use crate::linear::system::Entries;
use crate::load::obstacle::HeightField;
use crate::newton::condensed_contact::{CondensedContact, inertia, solve_free};
use crate::newton::focus::Focus;
use crate::newton::watch::Watch;
use crate::problem::{Problem, State};

/// The ground that a step works against.
pub(crate) struct Pressing<'a> {
    pub ground: &'a HeightField,
    /// Force with which it presses, N; `None` where it stands still.
    pub force: Option<f64>,
    pub focus: &'a Focus,
    /// Residual up to which the contact is solved, N.
    pub tolerance: f64,
    /// May end the step early.
    pub watch: &'a dyn Watch,
}

/// The ground at a state about which contact is linear.
pub(crate) struct LinearPressing<'a> {
    pub ground: &'a HeightField,
    /// Growth of the force with which it presses, N; `None` where it stands still.
    pub lack: Option<f64>,
}

/// Tangent of everything but contact at one state, factorised.
#[derive(Debug)]
pub struct Tangent {
    pub(crate) setup: Arc<Setup>,
    factor: Factor,
    /// Schur complement of the border, without contact.
    schur: Mat<f64>,
    /// Derivative of each brick's volume residuals by its displacements: brick, mode, unknown.
    pub(crate) coupling: Vec<f64>,
}

impl Tangent {
    pub(crate) fn new(setup: Arc<Setup>, coupling_len: usize) -> Result<Self, LinearError> {
        Ok(Self {
            factor: Factor::new(setup.symbolic.clone())?,
            schur: Mat::new(),
            coupling: vec![0.0; coupling_len],
            setup,
        })
    }

    /// Factorises these entries; the coupling has been filled by the caller.
    pub(crate) fn factorise(
        &mut self,
        entries: &mut Entries,
        workspace: &mut Workspace,
    ) -> Result<(), LinearError> {
        let spring = self.add_springs(entries);
        self.factor.factorise(&entries.values, workspace)?;
        self.schur = self.factor.schur_complement();
        for k in 0..self.schur.nrows() {
            self.schur[(k, k)] -= spring;
        }
        Ok(())
    }

    /// Returns this tangent with its factor in single precision.
    #[must_use]
    pub(crate) fn rounded(self) -> Self {
        Self {
            factor: self.factor.rounded(),
            ..self
        }
    }

    /// Puts a spring as stiff as the body's mean diagonal on each unknown of the border; returns its stiffness.
    fn add_springs(&self, entries: &mut Entries) -> f64 {
        let starts = &self.setup.symbolic.pattern().column_starts;
        let diagonals = || self.setup.equations.interior..self.setup.equations.count;
        if diagonals().is_empty() {
            return 0.0;
        }
        let place = |column: usize| starts[column + 1] - 1;
        let sum: f64 = diagonals().map(|c| entries.values[place(c)].abs()).sum();
        let spring = sum / diagonals().len() as f64;
        for column in diagonals() {
            entries.values[place(column)] += spring;
        }
        spring
    }

    /// Solves for the displacement increments of all equations, in place of the right-hand side: minus the condensed
    /// residual of all but contact. Returns by how much the ground rises, mm.
    pub(crate) fn solve(
        &self,
        problem: &Problem,
        state: &State,
        pressing: Option<Pressing<'_>>,
        rhs: &mut [f64],
        workspace: &mut Workspace,
    ) -> f64 {
        self.around_border(rhs, workspace, |border| {
            let Some((pressing, contact)) = pressing.and_then(|pressing| {
                let Pressing { ground, focus, .. } = pressing;
                let contact = CondensedContact::new(problem, &self.setup, focus, state, ground)?;
                Some((pressing, contact))
            }) else {
                solve_free(&self.schur, border);
                return 0.0;
            };
            let Pressing {
                focus,
                tolerance,
                watch,
                ..
            } = pressing;
            let reduced = focus.reduce(border);
            let (increments, rise) = match pressing.force {
                Some(force) => contact.solve_pressing(&reduced, force, tolerance, watch),
                None => (contact.solve(&reduced, tolerance, watch), 0.0),
            };
            focus.expand(&increments, border);
            rise
        })
    }

    /// Solves as [`Self::solve`], with the points in contact that touch at `state`.
    pub(crate) fn solve_linear(
        &self,
        problem: &Problem,
        state: &State,
        pressing: Option<LinearPressing<'_>>,
        rhs: &mut [f64],
        workspace: &mut Workspace,
    ) -> f64 {
        self.around_border(rhs, workspace, |border| {
            let focus = self.focus(problem, self.setup.border_faces.clone());
            let contact = pressing.and_then(|LinearPressing { ground, lack }| {
                let contact = CondensedContact::new(problem, &self.setup, &focus, state, ground);
                Some((contact?, lack))
            });
            let Some((contact, lack)) = contact else {
                solve_free(&self.schur, border);
                return 0.0;
            };
            let (increments, rise) = contact.solve_linear(&focus.reduce(border), lack);
            focus.expand(&increments, border);
            rise
        })
    }

    /// Eliminates the interior, has the border solved if there is one, and completes the interior. Returns by how much the ground rises, mm.
    fn around_border(
        &self,
        rhs: &mut [f64],
        workspace: &mut Workspace,
        solve: impl FnOnce(&mut [f64]) -> f64,
    ) -> f64 {
        self.factor.eliminate(rhs, workspace);
        let border = &mut rhs[self.setup.equations.interior..];
        let rise = if border.is_empty() {
            0.0
        } else {
            solve(border)
        };
        self.factor.complete(rhs, workspace);
        rise
    }

    /// The part of the border that serves these contact faces.
    pub(crate) fn focus(&self, problem: &Problem, faces: Vec<bool>) -> Focus {
        Focus::new(problem, &self.setup, &self.schur, faces)
    }

    /// Signs of the pivots, those of the contact at `state` included.
    pub(crate) fn inertia(
        &self,
        problem: &Problem,
        state: &State,
        ground: Option<&HeightField>,
    ) -> Inertia {
        let focus = self.focus(problem, self.setup.border_faces.clone());
        let contact = ground
            .and_then(|ground| CondensedContact::new(problem, &self.setup, &focus, state, ground));
        let border = match contact {
            Some(contact) => contact.inertia(),
            None if self.schur.nrows() > 0 => inertia(&self.schur),
            None => Inertia::default(),
        };
        Inertia {
            negative: self.factor.interior_inertia().negative + border.negative,
        }
    }
}
