//! Focus: the part of the contact surface that Newton's method is ready for.

use std::sync::Arc;

use crate::linear::setup::{SetupError, contact_faces};
use crate::newton::iteration::{Cause, Newton};
use crate::problem::{Loads, State};

impl Newton<'_> {
    /// Takes back a step that touched the ground outside the focus, and brings that into focus.
    pub(super) fn widen_focus(&mut self, state: &mut State, loads: &Loads) -> Result<(), Cause> {
        let touching = state.clone();
        self.restore(state);
        self.cover_contact(&touching, loads)?;
        self.set_pending(state, loads.support_factor);
        // What moving supports cause at the free displacements is assembled with the tangent.
        let moves = self.pending.iter().flatten().any(|du| *du != 0.0);
        if self.tangent.is_none() || moves {
            self.renew(state, loads)?;
        }
        self.acceleration.reset();
        self.residual(state, loads);
        Ok(())
    }

    /// Focuses on the contact with the ground of `loads` alone, at which `state` is in equilibrium: a path that starts
    /// there touches at least this.
    ///
    /// # Errors
    /// [`Cause`] when a new border doesn't fit in memory.
    pub fn start_from(&mut self, state: &State, loads: &Loads) -> Result<(), Cause> {
        self.focused_faces.clear();
        self.focus = None;
        self.cover_contact(state, loads)
    }

    /// Brings all faces into focus that may touch the ground from this state, beside those that are, and makes the
    /// border serve them.
    pub(super) fn cover_contact(&mut self, state: &State, loads: &Loads) -> Result<(), Cause> {
        let faces = contact_faces(self.problem, state, loads);
        self.focused_faces.resize(faces.len(), false);
        for (focused, needed) in self.focused_faces.iter_mut().zip(&faces) {
            if *needed && !*focused {
                *focused = true;
                self.focus = None;
            }
        }
        let refused = |error| match error {
            SetupError::Linear(error) => Cause::Singular(error),
            SetupError::Mesh(_) => Cause::Inverted,
        };
        let widened = self.setup.widened(self.problem, &self.focused_faces);
        let Some(setup) = widened.map_err(refused)? else {
            return Ok(());
        };
        let settings = self.settings;
        let mut fresh = Self::with_setup(self.problem, Arc::new(setup)).map_err(refused)?;
        fresh.settings = settings;
        fresh.effort = self.effort;
        fresh.pending.clone_from(&self.pending);
        fresh.focused_faces = std::mem::take(&mut self.focused_faces);
        *self = fresh;
        Ok(())
    }
}
