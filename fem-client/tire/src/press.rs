//! The tire pressed on the ground, from its inflated state or from a neighbouring equilibrium, and the ground dragged from there.

use fem::newton::iteration::NewtonSettings;
use fem::newton::path::{PathReport, Stability};
use fem::problem::{Loads, State};

use crate::ground_path::{GroundPath, Leg};
use crate::neighbourhood::Pressed;
use crate::press_failure::{path_failure, self_contact};
use crate::self_contact::touches_itself;
use crate::session::Session;
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
            friction: self.friction(&state, target),
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
        let path = GroundPath {
            leg: Leg::Pressing,
            begin: &self.above_ground(inflated),
            start: &self.inflation(),
            target,
        };
        self.set_smallest_step(path.leg);
        if let Some((equilibrium, loads)) = near {
            let (mut state, loads) = self.leaving(equilibrium, loads, target);
            let followed = self.follow(&mut state, &loads, target, Stability::Ignored);
            if let Ok(report) = followed {
                return self.unfolded((state, report), &path);
            }
        }
        self.go(&path)
    }

    fn drag(
        &mut self,
        pressed: &State,
        undragged: &Loads,
        target: &Loads,
    ) -> Result<(State, PathReport), SolveError> {
        let path = GroundPath {
            leg: Leg::Dragging,
            begin: pressed,
            start: undragged,
            target,
        };
        self.set_smallest_step(path.leg);
        self.go(&path)
    }

    fn set_smallest_step(&mut self, leg: Leg) {
        let smallest = NewtonSettings::default().smallest_load_step;
        self.newton.settings.smallest_load_step = smallest * leg.bearable(self.scene);
    }

    /// All of a path.
    fn go(&mut self, path: &GroundPath<'_>) -> Result<(State, PathReport), SolveError> {
        if self.scene.contact.friction > 0.0 {
            self.newton.settings.largest_load_step = path.leg.friction_step(self.scene.model.level);
        }
        let mut state = path.begin.clone();
        let found = match self.follow(&mut state, path.start, path.target, Stability::Ignored) {
            Ok(report) => (state, report),
            Err(failure) => path_failure(self, path, &state, &failure)?,
        };
        self.unfolded(found, path)
    }

    /// Returns what was found at the end of a path, unless the tire touches itself there and on all of the path's branches.
    fn unfolded(
        &mut self,
        found: (State, PathReport),
        path: &GroundPath<'_>,
    ) -> Result<(State, PathReport), SolveError> {
        match touches_itself(self.model, &found.0) {
            true => self_contact(self, path),
            false => Ok(found),
        }
    }
}
