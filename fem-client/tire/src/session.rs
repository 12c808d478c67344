//! One solve on its way: a scene's model, its Newton method, and the loads they meet.

use std::sync::atomic::AtomicBool;

use fem::newton::iteration::Newton;
use fem::newton::path::{PathFailure, PathReport, Stability, follow};
use fem::problem::{Loads, State};

use crate::model::{TireModel, ground};
use fem_client::scene::Scene;

/// A scene's model with its Newton method.
pub(crate) struct Session<'m> {
    pub(crate) scene: &'m Scene,
    pub(crate) model: &'m TireModel,
    pub(crate) newton: Newton<'m>,
    pub(crate) stop: &'m AtomicBool,
}

impl Session<'_> {
    /// Loads of the inflated state.
    pub(crate) fn inflation(&self) -> Loads {
        Loads {
            pressure: self.scene.pressure.internal_mpa,
            ..Loads::default()
        }
    }

    pub(crate) fn follow(
        &mut self,
        state: &mut State,
        start: &Loads,
        target: &Loads,
        stability: Stability,
    ) -> Result<PathReport, Box<PathFailure>> {
        follow(&mut self.newton, state, start, target, stability, self.stop)
    }

    /// Loads of the scene, given its inflated state.
    pub(crate) fn target(&self, inflated: &State) -> Loads {
        let radius = self.model.crown_radius(inflated);
        Loads {
            ground: Some(ground(&self.scene.ground, radius)),
            ..self.inflation()
        }
    }
}
