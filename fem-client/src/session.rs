//! One solve on its way: inflate the tire, press it, say what stopped it.

use std::sync::atomic::AtomicBool;

use fem::newton::{Newton, NewtonSettings};
use fem::path::{PathFailure, PathReport, Stability, follow};
use fem::problem::{Loads, State};

use crate::failure::{beyond_limit, inflation_error, limit_point, pressing_failure, self_contact};
use crate::neighbourhood::Pressed;
use crate::scene::Scene;
use crate::self_contact::touches_itself;
use crate::solver::SolveError;
use crate::tire::{FRICTION_STEPS, TireModel, ground};

/// Smallest step of inflation before a limit point is looked for.
const COARSEST_CUT_BACK: f64 = 1.0 / 32.0;

/// A scene's model with its Newton method.
pub(crate) struct Session<'m> {
    pub(crate) scene: &'m Scene,
    pub(crate) model: &'m TireModel,
    pub(crate) newton: Newton<'m>,
    pub(crate) stop: &'m AtomicBool,
}

impl Session<'_> {
    /// Loads of the inflated state.
    fn inflation(&self) -> Loads {
        Loads {
            pressure: self.scene.pressure.internal_mpa,
            ..Loads::default()
        }
    }

    fn follow(
        &mut self,
        state: &mut State,
        start: &Loads,
        target: &Loads,
        stability: Stability,
    ) -> Result<PathReport, Box<PathFailure>> {
        follow(&mut self.newton, state, start, target, stability, self.stop)
    }

    /// The inflated state, from `near`, the inflated state of a similar scene, or from nothing.
    pub(crate) fn inflate(&mut self, near: Option<State>) -> Result<State, SolveError> {
        let target = self.inflation();
        if let Some(mut state) = near {
            let start = target.clone();
            let required = Stability::Required;
            if self.follow(&mut state, &start, &target, required).is_ok() {
                return Ok(state);
            }
        }
        let mut state = State::reference(&self.model.problem);
        self.newton.settings.smallest_load_step = COARSEST_CUT_BACK;
        match self.follow(&mut state, &Loads::default(), &target, Stability::Required) {
            Ok(_) => Ok(state),
            Err(failure) => self.inflate_further(state, &failure),
        }
    }

    /// Where inflation in large steps ended: at a limit point, or it goes on in small ones.
    fn inflate_further(
        &mut self,
        mut state: State,
        failure: &PathFailure,
    ) -> Result<State, SolveError> {
        if let Some(limit) = limit_point(self.scene, self.model, &state, failure, self.stop) {
            return Err(beyond_limit(self.scene, &limit));
        }
        self.newton.settings.smallest_load_step = NewtonSettings::default().smallest_load_step;
        let (start, target) = (failure.loads.clone(), self.inflation());
        let required = Stability::Required;
        match self.follow(&mut state, &start, &target, required) {
            Ok(_) => Ok(state),
            Err(failure) => Err(inflation_error(self.scene, &failure)),
        }
    }

    /// Loads of the scene, given its inflated state.
    pub(crate) fn target(&self, inflated: &State) -> Loads {
        let radius = self.model.crown_radius(inflated);
        Loads {
            ground: Some(ground(&self.scene.ground, radius)),
            ..self.inflation()
        }
    }

    /// The equilibrium on the ground: from a neighbouring one, with its loads, else by pressing the inflated tire.
    pub(crate) fn press(
        &mut self,
        inflated: &State,
        target: &Loads,
        near: Option<(&State, &Loads)>,
    ) -> Result<Pressed, SolveError> {
        self.newton.settings.smallest_load_step = NewtonSettings::default().smallest_load_step;
        let before = self.newton.effort.iterations;
        let (state, report) = self.follow_depths(inflated, target, near)?;
        if touches_itself(self.model, &state) {
            let path = [&self.inflation(), target];
            let newton = &mut self.newton;
            return Err(self_contact(self.model, newton, inflated, path, self.stop));
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
            let mut state = equilibrium.clone();
            let path = self.follow(&mut state, loads, target, ignored);
            if let Ok(report) = path {
                return Ok((state, report));
            }
        }
        let mut state = inflated.clone();
        let unpressed = self.inflation();
        if self.scene.contact.friction > 0.0 {
            self.newton.settings.largest_load_step = 1.0 / FRICTION_STEPS as f64;
        }
        match self.follow(&mut state, &unpressed, target, ignored) {
            Ok(report) => Ok((state, report)),
            Err(failure) => Err(pressing_failure(
                self.scene,
                &mut self.newton,
                &state,
                &failure,
            )),
        }
    }
}
