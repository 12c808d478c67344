//! A step of Newton's method: increments by the present tangent, and how much of them is applied.

use std::time::Instant;

use super::{Cause, Newton};
use crate::linear::sparsity::NONE;
use crate::linear::system::Imbalance;
use crate::newton::tangent::Pressing;
use crate::newton::watch::Watch;
use crate::problem::{Loads, State};

/// Halvings of a step that would invert an element, before the iteration is given up.
const MAX_HALVINGS: usize = 8;
/// Residual of the condensed contact relative to the imbalance before the step, which no step reduces as much.
const CONTACT_SHARE: f64 = 1e-4;

impl Newton<'_> {
    /// Does an iteration with the present tangent: increments and update. Returns the residual there.
    pub(super) fn step(
        &mut self,
        state: &mut State,
        loads: &Loads,
        watch: &dyn Watch,
    ) -> Result<Imbalance, Cause> {
        self.solve_displacements(state, loads, watch)?;
        let start = Instant::now();
        self.collect_increments()?;
        self.accelerate();
        self.effort.substitution += start.elapsed();
        self.update(state, loads).map(|(_, residual)| residual)
    }

    /// Increments of the free displacements by the present tangent.
    pub(super) fn solve_displacements(
        &mut self,
        state: &State,
        loads: &Loads,
        watch: &dyn Watch,
    ) -> Result<(), Cause> {
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
        let ground = loads.ground_in(state);
        let pressing = ground.as_ref().map(|ground| {
            let faces = &self.focused_faces;
            let focus = || tangent.focus(self.problem, faces.clone());
            let focus = &*self.focus.get_or_insert_with(focus);
            Pressing {
                ground,
                force: loads.ground_force,
                focus,
                tolerance,
                watch,
            }
        });
        self.rise = tangent.solve(self.problem, state, pressing, rhs, workspace);
        self.effort.substitution += start.elapsed();
        self.effort.iterations += 1;
        Ok(())
    }

    /// Sets what is left to move of the held displacements.
    pub(super) fn set_pending(&mut self, state: &State, factor: f64) {
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
    pub(super) fn collect_increments(&mut self) -> Result<(), Cause> {
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

    /// Corrects the increments by earlier ones with this tangent.
    fn accelerate(&mut self) {
        let displacements = 3 * self.increments.len();
        self.flat.clear();
        self.flat.extend_from_slice(self.increments.as_flattened());
        self.flat.extend_from_slice(&self.pressure_increments);
        self.flat.push(self.rise);
        let depth = self.settings.acceleration_depth;
        self.acceleration
            .correct(&mut self.flat, displacements, depth);
        self.rise = self.flat.pop().unwrap_or_default();
        let (displacement, pressure) = self.flat.split_at(displacements);
        self.increments
            .as_flattened_mut()
            .copy_from_slice(displacement);
        self.pressure_increments.copy_from_slice(pressure);
    }

    /// Applies the step, or the largest of its halvings that inverts no element, and returns the fraction and the residual
    /// there.
    pub(super) fn update(
        &mut self,
        state: &mut State,
        loads: &Loads,
    ) -> Result<(f64, Imbalance), Cause> {
        self.previous.clone_from(state);
        let mut factor = 1.0;
        for _ in 0..MAX_HALVINGS {
            state.add(factor, &self.increments, &self.pressure_increments);
            state.rise += factor * self.rise;
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

    /// Takes the last update back.
    pub(super) fn restore(&self, state: &mut State) {
        state.clone_from(&self.previous);
    }
}
