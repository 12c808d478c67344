//! One solve on its way: inflate the tire, press it, say what stopped it.

use std::sync::atomic::AtomicBool;

use fem::newton::{Cause, Newton};
use fem::path::{PathFailure, PathReport, Stability, follow};
use fem::problem::{Loads, State};

use crate::neighbourhood::Pressed;
use crate::scene::Scene;
use crate::self_contact::touches_itself;
use crate::solver::{NoEquilibrium, Reached, SolveError};
use crate::tire::{FRICTION_STEPS, TireModel, ground};

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

    /// The inflated state, from `near`, the inflated state of a similar scene, or from nothing.
    pub(crate) fn inflate(&mut self, near: Option<State>) -> Result<State, SolveError> {
        let target = self.inflation();
        if let Some(mut state) = near {
            let start = target.clone();
            let required = Stability::Required;
            if follow(
                &mut self.newton,
                &mut state,
                &start,
                &target,
                required,
                self.stop,
            )
            .is_ok()
            {
                return Ok(state);
            }
        }
        let mut state = State::reference(&self.model.problem);
        match follow(
            &mut self.newton,
            &mut state,
            &Loads::default(),
            &target,
            Stability::Required,
            self.stop,
        ) {
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
        let before = self.newton.effort.iterations;
        let (state, report) = self.follow_depths(inflated, target, near)?;
        if touches_itself(self.model, &state) {
            return Err(self.self_contact(inflated, target));
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
            let path = follow(
                &mut self.newton,
                &mut state,
                loads,
                target,
                ignored,
                self.stop,
            );
            if let Ok(report) = path {
                return Ok((state, report));
            }
        }
        let mut state = inflated.clone();
        let unpressed = self.inflation();
        if self.scene.contact.friction > 0.0 {
            self.newton.settings.largest_load_step = 1.0 / FRICTION_STEPS as f64;
        }
        match follow(
            &mut self.newton,
            &mut state,
            &unpressed,
            target,
            ignored,
            self.stop,
        ) {
            Ok(report) => Ok((state, report)),
            Err(failure) => Err(pressing_error(self.scene, &failure)),
        }
    }
}

/// Halvings of the way to the depths in the search of the first self-contact.
const SELF_CONTACT_STEPS: usize = 7;

impl Session<'_> {
    /// Finds how far the tire can be pressed before it touches itself.
    fn self_contact(&mut self, inflated: &State, target: &Loads) -> SolveError {
        let unpressed = self.inflation();
        let (mut apart, mut touching) = (0.0, 1.0);
        let mut state = inflated.clone();
        for _ in 0..SELF_CONTACT_STEPS {
            let middle = 0.5 * (apart + touching);
            let mut trial = state.clone();
            let (from, to) = (
                unpressed.towards(target, apart),
                unpressed.towards(target, middle),
            );
            let ignored = Stability::Ignored;
            let path = follow(&mut self.newton, &mut trial, &from, &to, ignored, self.stop);
            if path.is_ok() && !touches_itself(self.model, &trial) {
                (apart, state) = (middle, trial);
            } else {
                touching = middle;
            }
        }
        let reached = unpressed.towards(target, apart);
        SolveError::NoEquilibrium {
            status: NoEquilibrium::SelfContact,
            detail: format!(
                "the inner surface touches itself between {:.1} and {:.1} % of the way to the depths {:?} mm: press less, \
                 or inflate more",
                100.0 * apart,
                100.0 * touching,
                self.scene.ground.depths_mm
            ),
            reached: Reached {
                pressure_mpa: reached.pressure,
                depths_mm: reached
                    .ground
                    .map(|ground| ground.depths)
                    .unwrap_or_default(),
            },
        }
    }
}

fn inflation_error(scene: &Scene, failure: &PathFailure) -> SolveError {
    let reached = Reached {
        pressure_mpa: failure.loads.pressure,
        depths_mm: Vec::new(),
    };
    let asked = scene.pressure.internal_mpa;
    let at = failure.loads.pressure;
    if failure.indefinite {
        let detail = format!(
            "inflation lost its stability just above {at:.6} MPa of the {asked} MPa asked for: this wall cannot hold the \
             pressure; use a thicker wall, a stiffer rubber, a carcass or less pressure"
        );
        return no_equilibrium(NoEquilibrium::LimitPoint, detail, reached, failure.cause);
    }
    let detail = format!(
        "inflation stopped at {at:.6} MPa of the {asked} MPa asked for ({})",
        cause(failure.cause)
    );
    no_equilibrium(NoEquilibrium::NotConverged, detail, reached, failure.cause)
}

fn pressing_error(scene: &Scene, failure: &PathFailure) -> SolveError {
    let depths = failure
        .loads
        .ground
        .as_ref()
        .map(|ground| ground.depths.clone())
        .unwrap_or_default();
    let detail = format!(
        "pressing stopped at {:.1} % of the way to the depths {:?} mm ({})",
        100.0 * failure.reached,
        scene.ground.depths_mm,
        cause(failure.cause)
    );
    let reached = Reached {
        pressure_mpa: failure.loads.pressure,
        depths_mm: depths,
    };
    no_equilibrium(NoEquilibrium::NotConverged, detail, reached, failure.cause)
}

fn no_equilibrium(
    status: NoEquilibrium,
    detail: String,
    reached: Reached,
    cause: Cause,
) -> SolveError {
    match cause {
        Cause::Stopped => SolveError::Stopped,
        _ => SolveError::NoEquilibrium {
            status,
            detail,
            reached,
        },
    }
}

fn cause(cause: Cause) -> &'static str {
    match cause {
        Cause::Iterations => "too many Newton iterations at the smallest load step",
        Cause::Diverged => "the residual grew without bound at the smallest load step",
        Cause::Inverted => "an element would turn inside out",
        Cause::Singular(_) => "the tangent is singular",
        Cause::Unstable => "the equilibrium found is unstable",
        Cause::Stopped => "stopped on request",
    }
}
