//! Renewal of Newton's tangent: when, and how.

use std::sync::Arc;
use std::time::Instant;

use super::{Cause, Newton};
use crate::linear::factor::Inertia;
use crate::linear::system::{Entries, Imbalance};
use crate::newton::tangent::Tangent;
use crate::problem::{Loads, State};

/// Steps over which the rate of convergence is taken.
const RATE_STEPS: usize = 2;

/// Residual above which a body with a sheet takes a new tangent for each step: that of a stiff sheet foresees one step alone. 12 to 18 iterations in the time of 14 without
/// a sheet, where a tangent that is kept takes 20 to 60.
const FORESEEN: f64 = 1e-3;

impl Newton<'_> {
    /// Whether the steps that the tangent still needs cost more than a new one, at the mean rate of the last two of the
    /// `kept` steps that it has made: a point that opens or closes can spoil a single one.
    pub(super) fn wants_renewal(&self, history: &[Imbalance], kept: usize) -> bool {
        if self.tangent.is_none() || kept == 0 {
            return self.tangent.is_none();
        }
        if self.problem.sheet.is_some() && history[history.len() - 1].worst() > FORESEEN {
            return true;
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

    /// Assembles and factorises the tangent at a state.
    ///
    /// # Errors
    /// [`Cause::Singular`].
    pub(super) fn renew(&mut self, state: &State, loads: &Loads) -> Result<(), Cause> {
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
        self.tangent = Some(Arc::new(tangent));
        self.renewed_at = Some(state.clone());
        Ok(())
    }

    /// Signs of the pivots of the last tangent that was made with these loads, contact included: a dense factorisation of the border, which steps don't need.
    pub(super) fn inertia_of_last(&self, loads: &Loads) -> Option<Inertia> {
        let (tangent, state) = (self.tangent.as_ref()?, self.renewed_at.as_ref()?);
        let ground = loads.ground_in(state);
        Some(tangent.inertia(self.problem, state, ground.as_ref()))
    }

    /// The tangent at a state, for solves of the same problem near it: its factor is in single precision, because these
    /// solves are bound by reading it and correct its rounding like the distance between their states.
    ///
    /// # Errors
    /// [`Cause`] when it is singular or doesn't fit in memory.
    pub fn tangent_at(&mut self, state: &State, loads: &Loads) -> Result<Arc<Tangent>, Cause> {
        self.renew_in_full(state, loads)?;
        let own = self.tangent.take().and_then(Arc::into_inner);
        own.map(|tangent| Arc::new(tangent.rounded()))
            .ok_or(Cause::Diverged)
    }

    /// Signs of the pivots at an equilibrium. The tangent made for it serves the next solve.
    ///
    /// # Errors
    /// As [`Newton::tangent_at`].
    pub fn inertia_at(&mut self, state: &State, loads: &Loads) -> Result<Inertia, Cause> {
        self.renew_in_full(state, loads)?;
        self.inertia_of_last(loads).ok_or(Cause::Diverged)
    }

    /// Renews the tangent at an equilibrium, of the tensions there and not of those that some step foresaw.
    fn renew_in_full(&mut self, state: &State, loads: &Loads) -> Result<(), Cause> {
        self.set_pending(state, loads.support_factor);
        self.cover_contact(state, loads)?;
        self.assembler.forget_last_tangent();
        self.renew(state, loads)
    }
}
