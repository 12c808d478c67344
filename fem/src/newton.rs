//! Equilibrium under given loads by Newton's method.
//!
//! Each step solves the condensed tangent for the displacements and recovers the pressures element by element. A step that
//! would turn an element inside out is halved. The iteration ends when the out-of-balance forces and the volume
//! residuals, both relative to the problem's own, are below the tolerance; every residual is kept.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::assembly::Assembler;
use crate::linear::{Definiteness, Factor, LinearError, Symbolic};
use crate::problem::{Loads, Problem, State};
use crate::solid::InvalidReference;
use crate::sparsity::NONE;
use crate::system::{Imbalance, System};
use crate::tensor::Vector;

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonSettings {
    /// Largest relative residual of an equilibrium.
    pub tolerance: f64,
    /// Iterations after which a load step is given up.
    pub max_iterations: usize,
    /// Relative residual above which the iteration is given up.
    pub divergence: f64,
    /// Smallest volume ratio that a step may reach at an integration point.
    pub min_volume_ratio: f64,
}

impl Default for NewtonSettings {
    fn default() -> Self {
        Self {
            tolerance: 1e-10,
            max_iterations: 25,
            divergence: 1e6,
            min_volume_ratio: 0.05,
        }
    }
}

/// An equilibrium was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Converged {
    /// Relative residual before the first and after each iteration.
    pub history: Vec<Imbalance>,
    /// Whether the last tangent was positive definite.
    pub definiteness: Definiteness,
}

/// No equilibrium was found.
#[derive(Debug, Clone, PartialEq)]
pub struct NotConverged {
    /// Relative residual before the first and after each iteration.
    pub history: Vec<Imbalance>,
    /// What ended the iteration.
    pub cause: Cause,
    /// Whether a tangent on the way had negative pivots: a sign of lost stability.
    pub indefinite: bool,
}

/// What ended an iteration without an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cause {
    /// Too many iterations.
    Iterations,
    /// The residual grew beyond bounds or isn't a number.
    Diverged,
    /// Every fraction of the step turns an element inside out.
    Inverted,
    /// The tangent is singular.
    Singular(LinearError),
    /// An equilibrium was found, but it is unstable.
    Unstable,
    /// The caller asked to stop.
    Stopped,
}

/// Time spent, and iterations made.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Effort {
    /// Newton iterations: linear systems solved.
    pub iterations: usize,
    /// Time in assembly.
    pub assembly: Duration,
    /// Time in numeric factorisation.
    pub factorisation: Duration,
    /// Time in triangular solves.
    pub substitution: Duration,
}

/// Setting up a problem failed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SetupError {
    /// The mesh is invalid.
    #[error(transparent)]
    Mesh(#[from] InvalidReference),
    /// The linear solver can't be set up.
    #[error(transparent)]
    Linear(#[from] LinearError),
}

/// Newton's method for one problem, with all its memory.
#[derive(Debug)]
pub struct Newton<'p> {
    problem: &'p Problem,
    /// When to stop.
    pub settings: NewtonSettings,
    /// Time and iterations since the last reset by the caller.
    pub effort: Effort,
    assembler: Assembler<'p>,
    symbolic: Symbolic,
    system: System,
    factor: Factor,
    increments: Vec<Vector>,
    pending: Vec<Vector>,
}

/// Halvings of a step that would invert an element, before the iteration is given up.
const MAX_HALVINGS: usize = 8;

impl<'p> Newton<'p> {
    /// Sets the problem up: scatter, elimination order, symbolic factorisation.
    ///
    /// # Errors
    /// [`SetupError`] when the mesh is inverted or the factor doesn't fit in memory.
    pub fn new(problem: &'p Problem) -> Result<Self, SetupError> {
        let (assembler, pattern) = Assembler::new(problem)?;
        let symbolic = Symbolic::new(Arc::new(pattern))?;
        let system = assembler.system(symbolic.pattern());
        let factor = Factor::new(symbolic.clone())?;
        let nodes = problem.mesh.nodes.len();
        Ok(Self {
            problem,
            settings: NewtonSettings::default(),
            effort: Effort::default(),
            assembler,
            symbolic,
            system,
            factor,
            increments: vec![[0.0; 3]; nodes],
            pending: vec![[0.0; 3]; nodes],
        })
    }

    /// Free displacement unknowns.
    pub fn unknowns(&self) -> usize {
        self.assembler.equations.count
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.symbolic.factor_entries()
    }

    /// Largest |J - 1| of a brick's mean.
    pub fn max_volume_change(&mut self, state: &State) -> f64 {
        self.assembler.max_volume_change(state)
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
        let mut definiteness = Definiteness::Positive;
        let mut indefinite = false;
        self.set_pending(state, loads.support_factor);
        loop {
            let residual = self.residual(state, loads);
            history.push(residual);
            let fail = |history, cause| {
                Err(NotConverged {
                    history,
                    cause,
                    indefinite,
                })
            };
            let moved = self.pending.iter().flatten().all(|du| *du == 0.0);
            if moved && residual.worst() <= self.settings.tolerance {
                return Ok(Converged {
                    history,
                    definiteness,
                });
            }
            if !residual.worst().is_finite() || residual.worst() > self.settings.divergence {
                return fail(history, Cause::Diverged);
            }
            if history.len() > self.settings.max_iterations {
                return fail(history, Cause::Iterations);
            }
            if stop.load(Ordering::Relaxed) {
                return fail(history, Cause::Stopped);
            }
            definiteness = match self.step(state, loads) {
                Ok(definiteness) => definiteness,
                Err(cause) => return fail(history, cause),
            };
            indefinite |= definiteness == Definiteness::Indefinite;
        }
    }

    /// One iteration: tangent, factor, increments, update.
    fn step(&mut self, state: &mut State, loads: &Loads) -> Result<Definiteness, Cause> {
        let start = Instant::now();
        self.assembler
            .tangent(state, loads, &self.pending, &mut self.system);
        let assembled = Instant::now();
        let definiteness = self
            .factor
            .factorise(&self.system.entries)
            .map_err(Cause::Singular)?;
        let factorised = Instant::now();
        self.factor.solve(&mut self.system.condensed_residual);
        self.effort.substitution += factorised.elapsed();
        self.effort.factorisation += factorised - assembled;
        self.effort.assembly += assembled - start;
        self.effort.iterations += 1;
        self.collect_increments();
        self.update(state)?;
        Ok(definiteness)
    }

    fn residual(&mut self, state: &State, loads: &Loads) -> Imbalance {
        let start = Instant::now();
        let imbalance = self.assembler.residual(state, loads, &mut self.system);
        self.effort.assembly += start.elapsed();
        imbalance
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

    fn collect_increments(&mut self) {
        for ((increment, equations), pending) in self
            .increments
            .iter_mut()
            .zip(&self.assembler.equations.of_node)
            .zip(&self.pending)
        {
            *increment = [0, 1, 2].map(|i| match equations[i] {
                NONE => pending[i],
                equation => -self.system.condensed_residual[equation as usize],
            });
        }
    }

    /// Applies the step, or the largest of its halvings that inverts no element.
    fn update(&mut self, state: &mut State) -> Result<(), Cause> {
        let mut factor = 1.0;
        for _ in 0..MAX_HALVINGS {
            let mut trial = state.clone();
            self.assembler
                .apply(&mut trial, &self.system, &self.increments, factor);
            if self.assembler.min_volume_ratio(&trial) > self.settings.min_volume_ratio {
                *state = trial;
                for pending in self.pending.iter_mut().flatten() {
                    *pending *= 1.0 - factor;
                }
                return Ok(());
            }
            factor *= 0.5;
        }
        Err(Cause::Inverted)
    }
}
