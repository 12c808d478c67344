//! The tire pressed on the ground, from its inflated state or from a neighbouring equilibrium.

use fem::newton::iteration::NewtonSettings;
use fem::newton::path::{PathReport, Stability};
use fem::problem::{Loads, State};

use crate::model::{FRICTION_STEPS, load_step};
use crate::neighbourhood::Pressed;
use crate::press_failure::{pressing_failure, self_contact};
use crate::self_contact::touches_itself;
use crate::session::Session;
use fem_client::solver::SolveError;

impl Session<'_> {
    /// The equilibrium on the ground: from a neighbouring one, with its loads, else by pressing the inflated tire.
    pub(crate) fn press(
        &mut self,
        inflated: &State,
        target: &Loads,
        near: Option<(&State, &Loads)>,
    ) -> Result<Pressed, SolveError> {
        let smallest = NewtonSettings::default().smallest_load_step;
        self.newton.settings.smallest_load_step = smallest * load_step(self.scene);
        let before = self.newton.effort.iterations;
        let (mut state, mut report) = self.follow_depths(inflated, target, near)?;
        if touches_itself(self.model, &state) {
            (state, report) = self_contact(self, inflated, target)?;
        }
        Ok(Pressed {
            state,
            report,
            iterations: self.newton.effort.iterations - before,
        })
    }

    fn follow_depths(
        &mut self,
        inflated: &State,
        target: &Loads,
        near: Option<(&State, &Loads)>,
    ) -> Result<(State, PathReport), SolveError> {
        let ignored = Stability::Ignored;
        if let Some((equilibrium, loads)) = near {
            let (mut state, loads) = self.leaving(equilibrium, loads, target);
            let path = self.follow(&mut state, &loads, target, ignored);
            if let Ok(report) = path {
                return Ok((state, report));
            }
        }
        let mut state = self.above_ground(inflated);
        let unpressed = self.inflation();
        if self.scene.contact.friction > 0.0 {
            self.newton.settings.largest_load_step = 1.0 / FRICTION_STEPS as f64;
        }
        match self.follow(&mut state, &unpressed, target, ignored) {
            Ok(report) => Ok((state, report)),
            Err(failure) => pressing_failure(self, inflated, target, &state, &failure),
        }
    }
}
