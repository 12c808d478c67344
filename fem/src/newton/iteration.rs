//! Equilibrium under given loads by Newton's method with a tangent that is kept while it serves.
//!
//! Each step solves a factorised tangent of the body for the displacements - contact in full, see [`crate::newton::tangent`] - and
//! recovers the pressures element by element. A tangent is renewed when, at the rate seen, the steps that it would still
//! need cost more than a new one. A step that would turn an element inside out is halved. The iteration ends when the
//! out-of-balance forces and the volume residuals, both relative to the problem's own, are below the tolerance; every
//! residual is kept.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use crate::linear::assembly::Assembler;
use crate::linear::factor::{Inertia, Workspace};
use crate::linear::setup::{Setup, SetupError};
use crate::linear::sparsity::NONE;
use crate::linear::system::{Entries, Imbalance, Residuals};
use crate::newton::acceleration::Acceleration;
use crate::newton::focus::Focus;
use crate::newton::tangent::Tangent;
use crate::problem::{Loads, Problem, State};
use crate::surface::stretch::StretchRange;
use crate::tensor::Vector;

mod raised_ground;
mod report;
mod steps;

pub use report::{Cause, Converged, Effort, NewtonSettings, NotConverged};

/// Newton's method for one problem, with all its memory.
#[derive(Debug)]
pub struct Newton<'p> {
    problem: &'p Problem,
    /// When to stop.
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
    pending: Vec<Vector>,
    previous: State,
    /// Contact faces that the present solve may touch, and their part of the tangent's border.
    focused_faces: Vec<bool>,
    focus: Option<Focus>,
    acceleration: Acceleration,
    flat: Vec<f64>,
    indefinite: bool,
}

/// Halvings of a step that would invert an element, before the iteration is given up.
const MAX_HALVINGS: usize = 8;
/// Residual of the condensed contact relative to the imbalance before the step, which no step reduces as much.
const CONTACT_SHARE: f64 = 1e-4;
/// Steps over which the rate of convergence is taken.
const RATE_STEPS: usize = 2;
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

    /// The same, ready for contact from `state` with the ground of `loads`: else the first solve that touches the ground
    /// sets up anew.
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
    pub fn with_setup(problem: &'p Problem, setup: Arc<Setup>) -> Result<Self, SetupError> {
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
            pending: vec![[0.0; 3]; nodes],
            previous,
            focused_faces: Vec::new(),
            focus: None,
            acceleration: Acceleration::default(),
            flat: Vec::new(),
            indefinite: false,
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
        stop: &AtomicBool,
    ) -> Result<Converged, NotConverged> {
        let mut history = Vec::new();
        self.indefinite = false;
        self.set_pending(state, loads.support_factor);
        match self.iterate(state, loads, stop, &mut history) {
            Ok(()) => Ok(Converged { history }),
            Err(cause) => Err(NotConverged {
                history,
                cause,
                indefinite: self.indefinite,
            }),
        }
    }

    fn iterate(
        &mut self,
        state: &mut State,
        loads: &Loads,
        stop: &AtomicBool,
        history: &mut Vec<Imbalance>,
    ) -> Result<(), Cause> {
        self.cover_contact(state, loads)?;
        let mut residual = self.residual(state, loads);
        self.acceleration.reset();
        let mut kept = 0;
        loop {
            history.push(residual);
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
            if stop.load(Ordering::Relaxed) {
                return Err(Cause::Stopped);
            }
            if !moved || self.wants_renewal(history, kept) {
                self.renew(state, loads)?;
                kept = 0;
            }
            let before = residual.worst();
            residual = self.step(state, loads)?;
            while self.residuals.touches_outside {
                self.widen_focus(state, loads)?;
                residual = self.step(state, loads)?;
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

    /// Whether the steps that the tangent still needs cost more than a new one, at the mean rate of the last two of the
    /// `kept` steps that it has made: a point that opens or closes can spoil a single one.
    fn wants_renewal(&self, history: &[Imbalance], kept: usize) -> bool {
        if self.tangent.is_none() || kept == 0 {
            return self.tangent.is_none();
        }
        let steps = kept.min(RATE_STEPS);
        let (before, now) = (
            history[history.len() - 1 - steps],
            history[history.len() - 1],
        );
        let rate = (now.worst() / before.worst()).powf(1.0 / steps as f64);
        let left = (self.settings.tolerance / now.worst()).ln() / rate.ln();
        rate >= 1.0 || left > self.settings.renewal_cost
    }

    /// Assembles and factorises the tangent at a state, and returns the signs of its pivots, contact included.
    ///
    /// # Errors
    /// [`Cause::Singular`].
    fn renew(&mut self, state: &State, loads: &Loads) -> Result<Inertia, Cause> {
        let start = Instant::now();
        let mut tangent = match self.tangent.take().and_then(Arc::into_inner) {
            Some(own) => own,
            None => Tangent::new(self.setup.clone(), self.assembler.coupling_len())
                .map_err(Cause::Singular)?,
        };
        let entries = self
            .entries
            .get_or_insert_with(|| Entries::new(&self.setup));
        self.assembler
            .tangent(state, loads, &self.pending, entries, &mut tangent.coupling);
        let assembled = Instant::now();
        tangent
            .factorise(entries, &mut self.workspace)
            .map_err(Cause::Singular)?;
        self.effort.factorisation += assembled.elapsed();
        self.effort.assembly += assembled - start;
        self.effort.factorisations += 1;
        self.focus = None;
        self.acceleration.reset();
        let inertia = tangent.inertia(self.problem, state, loads.ground.as_ref());
        self.tangent = Some(Arc::new(tangent));
        self.indefinite |= !inertia.is_positive();
        Ok(inertia)
    }

    /// The tangent at a state, for solves of the same problem near it: its factor is in single precision, because these
    /// solves are bound by reading it and correct its rounding like the distance between their states.
    ///
    /// # Errors
    /// [`Cause`] when it is singular or doesn't fit in memory.
    pub fn tangent_at(&mut self, state: &State, loads: &Loads) -> Result<Arc<Tangent>, Cause> {
        self.inertia_at(state, loads)?;
        let own = self.tangent.take().and_then(Arc::into_inner);
        own.map(|tangent| Arc::new(tangent.rounded()))
            .ok_or(Cause::Diverged)
    }

    /// Signs of the pivots at an equilibrium. The tangent made for it serves the next solve.
    ///
    /// # Errors
    /// As [`Newton::tangent_at`].
    pub fn inertia_at(&mut self, state: &State, loads: &Loads) -> Result<Inertia, Cause> {
        self.set_pending(state, loads.support_factor);
        self.cover_contact(state, loads)?;
        self.renew(state, loads)
    }

    fn residual(&mut self, state: &State, loads: &Loads) -> Imbalance {
        let start = Instant::now();
        let served = &self.focused_faces;
        let imbalance = self
            .assembler
            .residual(state, loads, served, &mut self.residuals);
        self.effort.assembly += start.elapsed();
        imbalance
    }

    /// One iteration with the present tangent: increments and update. Returns the residual there.
    fn step(&mut self, state: &mut State, loads: &Loads) -> Result<Imbalance, Cause> {
        self.solve_displacements(state, loads)?;
        let start = Instant::now();
        self.collect_increments()?;
        self.accelerate();
        self.effort.substitution += start.elapsed();
        self.update(state, loads).map(|(_, residual)| residual)
    }

    /// Increments of the free displacements by the present tangent.
    fn solve_displacements(&mut self, state: &State, loads: &Loads) -> Result<(), Cause> {
        let tangent = self.tangent.clone().ok_or(Cause::Diverged)?;
        let start = Instant::now();
        let (forces, contact) = (&self.residuals.forces, &self.residuals.contact);
        for ((target, force), contact) in self.rhs.iter_mut().zip(forces).zip(contact) {
            *target = force - contact;
        }
        let volumes = &self.residuals.volumes;
        self.assembler
            .add_condensed_volumes(&tangent.coupling, volumes, &mut self.rhs);
        if let Some(entries) = &self.entries {
            for (target, force) in self.rhs.iter_mut().zip(&entries.pending_forces) {
                *target += force;
            }
        }
        for value in &mut self.rhs {
            *value = -*value;
        }
        let imbalance: f64 = forces.iter().map(|f| f * f).sum::<f64>().sqrt();
        let (rhs, workspace) = (&mut self.rhs, &mut self.workspace);
        let tolerance = CONTACT_SHARE * imbalance;
        let contact = loads.ground.as_ref().map(|ground| {
            let faces = &self.focused_faces;
            let focus = || tangent.focus(self.problem, faces.clone());
            (ground, &*self.focus.get_or_insert_with(focus))
        });
        tangent.solve(self.problem, state, contact, rhs, tolerance, workspace);
        self.effort.substitution += start.elapsed();
        self.effort.iterations += 1;
        Ok(())
    }

    /// What is left to move of the held displacements.
    fn set_pending(&mut self, state: &State, factor: f64) {
        for ((pending, support), u) in self
            .pending
            .iter_mut()
            .zip(&self.problem.supports)
            .zip(&state.displacement)
        {
            *pending = [0, 1, 2].map(|i| support[i].map_or(0.0, |target| factor * target - u[i]));
        }
    }

    /// Increments of all displacements, and of the element pressures that belong to them.
    fn collect_increments(&mut self) -> Result<(), Cause> {
        let tangent = self.tangent.clone().ok_or(Cause::Diverged)?;
        for ((increment, equations), pending) in self
            .increments
            .iter_mut()
            .zip(&self.setup.equations.of_node)
            .zip(&self.pending)
        {
            *increment = [0, 1, 2].map(|i| match equations[i] {
                NONE => pending[i],
                equation => self.rhs[equation as usize],
            });
        }
        self.assembler.pressure_increments(
            &tangent.coupling,
            &self.residuals.volumes,
            &self.increments,
            &mut self.pressure_increments,
        );
        Ok(())
    }

    fn accelerate(&mut self) {
        let displacements = 3 * self.increments.len();
        self.flat.clear();
        self.flat.extend_from_slice(self.increments.as_flattened());
        self.flat.extend_from_slice(&self.pressure_increments);
        let depth = self.settings.acceleration_depth;
        self.acceleration
            .correct(&mut self.flat, displacements, depth);
        let (displacement, pressure) = self.flat.split_at(displacements);
        self.increments
            .as_flattened_mut()
            .copy_from_slice(displacement);
        self.pressure_increments.copy_from_slice(pressure);
    }

    /// Applies the step, or the largest of its halvings that inverts no element, and returns the fraction and the residual
    /// there.
    fn update(&mut self, state: &mut State, loads: &Loads) -> Result<(f64, Imbalance), Cause> {
        self.previous.clone_from(state);
        let mut factor = 1.0;
        for _ in 0..MAX_HALVINGS {
            state.add(factor, &self.increments, &self.pressure_increments);
            let residual = self.residual(state, loads);
            if self.residuals.min_volume_ratio > self.settings.min_volume_ratio {
                for pending in self.pending.iter_mut().flatten() {
                    *pending *= 1.0 - factor;
                }
                if let Some(entries) = &mut self.entries {
                    entries.pending_forces.fill(0.0);
                }
                return Ok((factor, residual));
            }
            self.restore(state);
            self.acceleration.reset();
            factor *= 0.5;
        }
        Err(Cause::Inverted)
    }

    fn restore(&self, state: &mut State) {
        state.clone_from(&self.previous);
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
