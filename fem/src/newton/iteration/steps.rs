//! Newton's iteration step by step, for methods that add equations of their own.

use std::sync::Arc;
use std::time::Instant;

use super::{Cause, Newton};
use crate::linear::factor::Inertia;
use crate::linear::setup::Setup;
use crate::linear::sparsity::Equations;
use crate::linear::system::{Imbalance, Residuals};
use crate::newton::state_rate::StateRate;
use crate::newton::tangent::LinearPressing;
use crate::newton::watch::Watch;
use crate::problem::{Loads, State};

impl Newton<'_> {
    /// Prescribes the held displacements at this factor: the first step from `state` makes them.
    pub(crate) fn hold(&mut self, state: &State, support_factor: f64) {
        self.set_pending(state, support_factor);
    }

    /// Imbalance at a state, which the next [`Newton::linearise`] works on.
    pub(crate) fn imbalance(&mut self, state: &State, loads: &Loads) -> Imbalance {
        self.residual(state, loads)
    }

    /// Equation numbers of the displacements.
    pub(crate) fn equations(&self) -> &Equations {
        &self.setup.equations
    }

    /// Renews the tangent, and solves it for the increments of the free displacements that belong to the last residual:
    /// [`Newton::increments_mut`].
    pub(crate) fn linearise(
        &mut self,
        state: &State,
        loads: &Loads,
        watch: &dyn Watch,
    ) -> Result<Inertia, Cause> {
        self.renew(state, loads)?;
        let inertia = self.inertia_of_last(loads).ok_or(Cause::Diverged)?;
        self.solve_displacements(state, loads, watch)?;
        Ok(inertia)
    }

    /// Increments of the free displacements, by equations, that [`Newton::advance`] will apply.
    pub(crate) fn increments_mut(&mut self) -> &mut [f64] {
        &mut self.rhs
    }

    /// Solves with the present tangent, without ground, in place.
    pub(crate) fn solve_linear(&mut self, state: &State, rhs: &mut [f64]) -> Result<(), Cause> {
        let tangent = self.tangent.clone().ok_or(Cause::Diverged)?;
        tangent.solve(self.problem, state, None, rhs, &mut self.workspace);
        Ok(())
    }

    /// Whether there is a tangent.
    pub(crate) fn has_tangent(&self) -> bool {
        self.tangent.is_some()
    }

    /// The problem's set-up.
    pub(crate) fn setup(&self) -> &Arc<Setup> {
        &self.setup
    }

    /// Residuals that the next [`Newton::linear_step`] works on.
    pub(crate) fn residuals_mut(&mut self) -> &mut Residuals {
        &mut self.residuals
    }

    /// Increments by which the residuals vanish where body and contact are linear about `state`, and the ground's force grows by `lack`, N.
    pub(crate) fn linear_step(
        &mut self,
        state: &State,
        loads: &Loads,
        lack: f64,
    ) -> Result<StateRate, Cause> {
        let tangent = self.tangent.clone().ok_or(Cause::Diverged)?;
        let start = Instant::now();
        self.rhs.copy_from_slice(&self.residuals.forces);
        let volumes = &self.residuals.volumes;
        self.assembler
            .add_condensed_volumes(&tangent.coupling, volumes, &mut self.rhs);
        for value in &mut self.rhs {
            *value = -*value;
        }
        let ground = loads.ground_in(state);
        let pressing = ground.as_ref().map(|ground| LinearPressing {
            ground,
            lack: loads.ground_force.map(|_| lack),
        });
        let (rhs, workspace) = (&mut self.rhs, &mut self.workspace);
        let rise = tangent.solve_linear(self.problem, state, pressing, rhs, workspace);
        self.collect_increments()?;
        self.effort.substitution += start.elapsed();
        self.effort.iterations += 1;
        Ok(StateRate {
            displacement: self.increments.clone(),
            pressure: self.pressure_increments.clone(),
            rise,
        })
    }

    /// Applies the increments, or the largest of their halvings that inverts no element. Returns the fraction applied.
    pub(crate) fn advance(&mut self, state: &mut State, loads: &Loads) -> Result<f64, Cause> {
        self.collect_increments()?;
        self.update(state, loads).map(|(factor, _)| factor)
    }
}
