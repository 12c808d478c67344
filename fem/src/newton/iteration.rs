//! Equilibrium under given loads by Newton's method with a tangent that is kept while it serves.
//!
//! Each step solves a factorised tangent of the body for the displacements - contact in full, see [`crate::newton::tangent`] - and
//! recovers the pressures element by element. A tangent is renewed when, at the rate seen, the steps that it would still
//! need cost more than a new one. A step that would turn an element inside out is halved. The iteration ends when the
//! out-of-balance forces and the volume residuals, both relative to the problem's own, are below the tolerance; every
//! residual is kept.

use std::sync::Arc;
use std::time::Instant;

use crate::linear::assembly::Assembler;
use crate::linear::factor::Workspace;
use crate::linear::setup::{Setup, SetupError};
use crate::linear::system::{Entries, Imbalance, Residuals};
use crate::newton::acceleration::Acceleration;
use crate::newton::focus::Focus;
use crate::newton::tangent::Tangent;
use crate::newton::watch::Watch;
use crate::problem::{Loads, Problem, State};
use crate::surface::stretch::StretchRange;
use crate::tensor::Vector;

mod increments;
mod raised_ground;
mod renewal;
mod report;
mod steps;

pub use report::{Cause, Converged, Effort, LargestStep, NewtonSettings, NotConverged};

/// Newton's method for one problem, with all its memory.
#[derive(Debug)]
pub struct Newton<'p> {
    problem: &'p Problem,
    /// Criteria to stop.
    pub settings: NewtonSettings,
    /// Time and iterations since the last reset by the caller.
    pub effort: Effort,
    assembler: Assembler<'p>,
    setup: Arc<Setup>,
    tangent: Option<Arc<Tangent>>,
    entries: Option<Entries>,
    workspace: Workspace,
    residuals: Residuals,
    rhs: Vec<f64>,
    increments: Vec<Vector>,
    pressure_increments: Vec<f64>,
    /// Increment of the ground's height, mm.
    rise: f64,
    pending: Vec<Vector>,
    previous: State,
    /// Contact faces that the present solve may touch, and their part of the tangent's border.
    focused_faces: Vec<bool>,
    focus: Option<Focus>,
    acceleration: Acceleration,
    flat: Vec<f64>,
    /// State at which this attempt last renewed the tangent.
    renewed_at: Option<State>,
}

/// Iterations without a new smallest residual after which the attempt is given up: those that found an equilibrium after
/// that (1 in 300 of random scenes) found it sooner in smaller load steps.
const PATIENCE: usize = 10;
/// Growth of the residual at which a step with a kept tangent is taken back.
const SETBACK: f64 = 10.0;

impl<'p> Newton<'p> {
    /// Sets the problem up: scatter, elimination order, symbolic factorisation.
    ///
    /// # Errors
    /// [`SetupError`] when the mesh is inverted or the factor doesn't fit in memory.
    pub fn new(problem: &'p Problem) -> Result<Self, SetupError> {
        Self::for_contact(problem, &State::reference(problem), &Loads::default())
    }

    /// Sets the problem up for contact from `state` with the ground of `loads`. Without this the first solve that touches the
    /// ground sets up anew.
    ///
    /// # Errors
    /// As [`Newton::new`].
    pub fn for_contact(
        problem: &'p Problem,
        state: &State,
        loads: &Loads,
    ) -> Result<Self, SetupError> {
        Self::with_setup(problem, Arc::new(Setup::new(problem, state, loads)?))
    }

    /// Newton's method on a problem that has been set up.
    ///
    /// # Errors
    /// [`SetupError::Linear`] when the factor doesn't fit in memory.
    pub(crate) fn with_setup(problem: &'p Problem, setup: Arc<Setup>) -> Result<Self, SetupError> {
        let assembler = Assembler::new(problem, setup.clone());
        let nodes = problem.mesh.nodes.len();
        let previous = State::reference(problem);
        Ok(Self {
            problem,
            settings: NewtonSettings::default(),
            effort: Effort::default(),
            residuals: assembler.residuals(),
            assembler,
            tangent: None,
            entries: None,
            workspace: Workspace::new(&setup.symbolic)?,
            rhs: vec![0.0; setup.equations.count],
            setup,
            increments: vec![[0.0; 3]; nodes],
            pressure_increments: vec![0.0; previous.pressure.len()],
            rise: 0.0,
            pending: vec![[0.0; 3]; nodes],
            previous,
            focused_faces: Vec::new(),
            focus: None,
            acceleration: Acceleration::default(),
            flat: Vec::new(),
            renewed_at: None,
        })
    }

    /// Starts with a tangent made for the same problem at another state.
    ///
    /// # Errors
    /// [`SetupError::Linear`] when the factor doesn't fit in memory.
    pub fn with_tangent(problem: &'p Problem, tangent: Arc<Tangent>) -> Result<Self, SetupError> {
        let mut newton = Self::with_setup(problem, tangent.setup.clone())?;
        newton.tangent = Some(tangent);
        Ok(newton)
    }

    /// The problem that is solved.
    pub fn problem(&self) -> &'p Problem {
        self.problem
    }

    /// Forces of the supports on the body at each node, N; 0 at free displacements.
    pub fn reactions(&mut self, state: &State, loads: &Loads) -> Vec<Vector> {
        self.residual(state, loads);
        self.residuals.held_forces()
    }

    /// Free displacement unknowns.
    pub fn unknowns(&self) -> usize {
        self.setup.equations.count
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.setup.symbolic.factor_entries()
    }

    /// Largest |J - 1| of a brick's mean.
    pub fn max_volume_change(&mut self, state: &State) -> f64 {
        self.assembler.max_volume_change(state)
    }

    /// Extremes of the principal stretches.
    pub fn stretch_range(&mut self, state: &State) -> StretchRange {
        self.assembler.stretch_range(state)
    }

    /// Brings `state` into equilibrium with `loads`; on failure `state` is left somewhere on the way.
    ///
    /// # Errors
    /// [`NotConverged`] with the residual history and the cause.
    pub fn solve(
        &mut self,
        state: &mut State,
        loads: &Loads,
        watch: &dyn Watch,
    ) -> Result<Converged, NotConverged> {
        let mut history = Vec::new();
        self.renewed_at = None;
        self.set_pending(state, loads.support_factor);
        match self.iterate(state, loads, watch, &mut history) {
            Ok(()) => Ok(Converged { history }),
            Err(cause) => Err(NotConverged {
                history,
                cause,
                indefinite: self
                    .inertia_of_last(loads)
                    .is_some_and(|last| !last.is_positive()),
            }),
        }
    }

    fn iterate(
        &mut self,
        state: &mut State,
        loads: &Loads,
        watch: &dyn Watch,
        history: &mut Vec<Imbalance>,
    ) -> Result<(), Cause> {
        self.cover_contact(state, loads)?;
        let mut residual = self.residual(state, loads);
        self.acceleration.reset();
        let mut kept = 0;
        loop {
            history.push(residual);
            watch.iterated(residual.worst());
            let moved = self.pending.iter().flatten().all(|du| *du == 0.0);
            if moved && residual.worst() <= self.settings.tolerance {
                return Ok(());
            }
            if !residual.worst().is_finite() || residual.worst() > self.settings.divergence {
                return Err(Cause::Diverged);
            }
            if history.len() > self.settings.max_iterations || is_lost(history) {
                return Err(Cause::Iterations);
            }
            if watch.is_stopped() {
                return Err(Cause::Stopped);
            }
            if !moved || self.wants_renewal(history, kept) {
                self.renew(state, loads)?;
                kept = 0;
            }
            let before = residual.worst();
            residual = self.step(state, loads, watch)?;
            while self.residuals.touches_outside {
                if watch.is_stopped() {
                    return Err(Cause::Stopped);
                }
                self.widen_focus(state, loads)?;
                residual = self.step(state, loads, watch)?;
            }
            kept += 1;
            let grown = residual.worst().is_nan() || residual.worst() > SETBACK * before;
            if kept > 1 && grown {
                self.restore(state);
                residual = self.residual(state, loads);
                self.tangent = None;
            }
        }
    }

    /// Assembles the residual at a state and returns its size.
    fn residual(&mut self, state: &State, loads: &Loads) -> Imbalance {
        let start = Instant::now();
        let served = &self.focused_faces;
        let imbalance = self
            .assembler
            .residual(state, loads, served, &mut self.residuals);
        self.effort.assembly += start.elapsed();
        imbalance
    }
}

/// Whether the smallest residual is too long ago.
pub(crate) fn is_lost(history: &[Imbalance]) -> bool {
    let Some(recent) = history.len().checked_sub(PATIENCE) else {
        return false;
    };
    let smallest = |part: &[Imbalance]| {
        part.iter()
            .map(Imbalance::worst)
            .fold(f64::INFINITY, f64::min)
    };
    let (before, since) = history.split_at(recent);
    !before.is_empty() && smallest(since) >= smallest(before)
}
