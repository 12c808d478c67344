//! The tire pressed on the ground, from its inflated state or from a neighbouring equilibrium, and the ground dragged from there.

use fem::newton::iteration::NewtonSettings;
use fem::newton::path::{PathReport, Stability};
use fem::problem::{Loads, State};

use crate::neighbourhood::Pressed;
use crate::press_failure::{self_contact, way_failure};
use crate::self_contact::touches_itself;
use crate::session::Session;
use crate::way::{Leg, Way};
use fem_client::solver::SolveError;

impl Session<'_> {
    /// The equilibrium on the ground: from a neighbouring one, with its loads, else by pressing the inflated tire. Ground that is dragged presses first.
    pub(crate) fn press(
        &mut self,
        inflated: &State,
        target: &Loads,
        near: Option<(&State, &Loads)>,
    ) -> Result<Pressed, SolveError> {
        let before = self.newton.effort.iterations;
        let undragged = target.with_shift([0.0; 2]);
        let (mut state, mut report) = self.press_down(inflated, &undragged, near)?;
        if undragged != *target {
            let (dragged, steps) = self.drag(&state, &undragged, target)?;
            state = dragged;
            report.cut_backs += steps.cut_backs;
            report.steps.extend(steps.steps);
        }
        Ok(Pressed {
            friction: self.friction_force(&state, target),
            state,
            report,
            iterations: self.newton.effort.iterations - before,
        })
    }

    fn press_down(
        &mut self,
        inflated: &State,
        target: &Loads,
        near: Option<(&State, &Loads)>,
    ) -> Result<(State, PathReport), SolveError> {
        let way = Way {
            leg: Leg::Pressing,
            begin: &self.above_ground(inflated),
            start: &self.inflation(),
            target,
        };
        self.set_smallest_step(way.leg);
        if let Some((equilibrium, loads)) = near {
            let (mut state, loads) = self.leaving(equilibrium, loads, target);
            let path = self.follow(&mut state, &loads, target, Stability::Ignored);
            if let Ok(report) = path {
                return self.unfolded((state, report), &way);
            }
        }
        self.go(&way)
    }

    fn drag(
        &mut self,
        pressed: &State,
        undragged: &Loads,
        target: &Loads,
    ) -> Result<(State, PathReport), SolveError> {
        let way = Way {
            leg: Leg::Dragging,
            begin: pressed,
            start: undragged,
            target,
        };
        self.set_smallest_step(way.leg);
        self.go(&way)
    }

    fn set_smallest_step(&mut self, leg: Leg) {
        let smallest = NewtonSettings::default().smallest_load_step;
        self.newton.settings.smallest_load_step = smallest * leg.bearable(self.scene);
    }

    /// All of a way.
    fn go(&mut self, way: &Way<'_>) -> Result<(State, PathReport), SolveError> {
        if self.scene.contact.friction > 0.0 {
            self.newton.settings.largest_load_step = 1.0 / way.leg.friction_steps() as f64;
        }
        let mut state = way.begin.clone();
        let found = match self.follow(&mut state, way.start, way.target, Stability::Ignored) {
            Ok(report) => (state, report),
            Err(failure) => way_failure(self, way, &state, &failure)?,
        };
        self.unfolded(found, way)
    }

    /// Returns what was found at the end of a way, unless the tire touches itself there and on all of the way's branches.
    fn unfolded(
        &mut self,
        found: (State, PathReport),
        way: &Way<'_>,
    ) -> Result<(State, PathReport), SolveError> {
        match touches_itself(self.model, &found.0) {
            true => self_contact(self, way),
            false => Ok(found),
        }
    }
}
