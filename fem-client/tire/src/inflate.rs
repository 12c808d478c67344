//! The inflated state, or why a tire has none at the pressure asked for.
//!
//! The pressure is raised in large steps. Where they fail the volume takes over, which has an equilibrium beyond a limit
//! point too, and tells a limit point, buckling and endless growth apart.

use fem::newton::iteration::{Cause, NewtonSettings, NotConverged};
use fem::newton::path::Stability;
use fem::newton::volume_control::{Ending, Inflated, VolumeControl};
use fem::problem::{Loads, State};

use crate::press_failure::{cause_text, crushed, no_equilibrium};
use crate::session::Session;
use fem_client::solver::{NoEquilibrium, Reached, SolveError};

/// Smallest step of the pressure before the volume is prescribed.
const COARSEST_CUT_BACK: f64 = 1.0 / 64.0;
/// Stretch above which an equilibrium may lie beyond a limit point: a step of the pressure jumps over the falling part of the
/// path to where the rubber has stiffened.
const BALLOONED: f64 = 2.0;
/// Growth of the volume between the inner surface and the wheel's centre at which inflation is given up: on tires of usual
/// proportions the rubber is stretched four- to sixfold then, and tears.
const LARGEST_GROWTH: f64 = 8.0;

/// Relative rise of the pressure over that of the volume below which a path counts as level: whether it passes a flat maximum
/// or not is then a matter of the mesh.
const LEVEL: f64 = 0.1;

impl Session<'_> {
    /// The inflated state, from `near`, the inflated state of a similar scene, or from nothing.
    ///
    /// # Errors
    /// [`SolveError::NoEquilibrium`] with the pressure reached.
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
        let path = self.follow(&mut state, &Loads::default(), &target, Stability::Required);
        let ballooned = self.newton.stretch_range(&state).largest > BALLOONED;
        match path {
            Ok(_) if !ballooned => Ok(state),
            Ok(_) => self.inflate_by_volume(None),
            Err(failure) if failure.cause == Cause::Stopped => Err(SolveError::Stopped),
            Err(failure) => {
                let near = (state, failure.loads.pressure);
                self.inflate_by_volume(Some(near).filter(|_| !ballooned))
            }
        }
    }

    /// Goes on from an equilibrium at this pressure, MPa, or from the tire at rest.
    fn inflate_by_volume(&mut self, near: Option<(State, f64)>) -> Result<State, SolveError> {
        let pressure = near.as_ref().map_or(0.0, |(_, pressure)| *pressure);
        let mut control = VolumeControl::new(&self.model.problem).map_err(SolveError::broken)?;
        let start = match near {
            Some((state, pressure)) => control.at(state, pressure, &self.watch),
            None => control.reference(&self.watch),
        };
        let start = start.map_err(|lost| self.lost(pressure, lost.cause, lost.indefinite, None))?;
        let asked = self.scene.pressure.internal_mpa;
        let ending = control.inflate(&start, asked, LARGEST_GROWTH * start.volume, &self.watch);
        self.newton.effort += control.effort();
        match ending {
            Ending::Reached(near) => self.finish(near),
            Ending::LimitPoint(limit) => Err(self.beyond_limit(limit.pressure)),
            Ending::Unstable { below, above } => Err(self.buckled(below.pressure, above)),
            Ending::Outgrown(last) => Err(self.outgrown(&last)),
            Ending::Lost { last, failure } => {
                let NotConverged {
                    cause, indefinite, ..
                } = failure;
                Err(self.lost(last.pressure, cause, indefinite, Some(&last.state)))
            }
        }
    }

    /// Goes from an equilibrium near the pressure asked for to that pressure.
    fn finish(&mut self, near: Inflated) -> Result<State, SolveError> {
        self.newton.settings.smallest_load_step = NewtonSettings::default().smallest_load_step;
        let target = self.inflation();
        let start = Loads {
            pressure: near.pressure,
            ..target.clone()
        };
        let mut state = near.state;
        match self.follow(&mut state, &start, &target, Stability::Required) {
            Ok(_) => Ok(state),
            Err(failure) => {
                let pressure = failure.loads.pressure;
                Err(self.lost(pressure, failure.cause, failure.indefinite, Some(&state)))
            }
        }
    }

    fn beyond_limit(&self, limit: f64) -> SolveError {
        let asked = self.scene.pressure.internal_mpa;
        let detail = format!(
            "the limit pressure of this tire is {limit:.6} MPa, below the {asked} MPa asked for: beyond it no equilibrium \
             holds; {REMEDY}"
        );
        ended(NoEquilibrium::LimitPoint, detail, limit)
    }

    fn buckled(&self, below: f64, above: f64) -> SolveError {
        let asked = self.scene.pressure.internal_mpa;
        let detail = format!(
            "the inflated wall buckles between {below:.6} and {above:.6} MPa, below the {asked} MPa asked for: it leaves its \
             shape though the pressure could still rise; {REMEDY}"
        );
        ended(NoEquilibrium::LimitPoint, detail, below)
    }

    /// Explains an end at the largest volume: the pressure has levelled off, or the rubber stiffens and would be stretched too far.
    fn outgrown(&mut self, last: &Inflated) -> SolveError {
        let (asked, pressure) = (self.scene.pressure.internal_mpa, last.pressure);
        let stretch = self.newton.stretch_range(&last.state).largest;
        let levelled = last.slope * last.volume < LEVEL * pressure;
        let (status, what) = match levelled {
            true => (NoEquilibrium::LimitPoint, "the pressure levels off"),
            false => (NoEquilibrium::Overstretched, "the wall still gives"),
        };
        let detail = format!(
            "at {pressure:.6} MPa, below the {asked} MPa asked for, the rubber is stretched {stretch:.1}-fold and {what}: real \
             rubber tears before; {REMEDY}"
        );
        ended(status, detail, pressure)
    }

    /// No equilibrium was found beyond a pressure: for lack of stability where the tangents on the way had lost it, or because
    /// the rubber of the last state, if there is one, is squeezed too far.
    fn lost(
        &mut self,
        pressure: f64,
        cause: Cause,
        indefinite: bool,
        last: Option<&State>,
    ) -> SolveError {
        let asked = self.scene.pressure.internal_mpa;
        let squeezed = last.and_then(|state| crushed(self.newton.stretch_range(state).smallest));
        let (status, detail) = if indefinite {
            let detail = format!(
                "inflation lost its stability just above {pressure:.6} MPa of the {asked} MPa asked for: this wall cannot \
                 hold the pressure; {REMEDY}"
            );
            (NoEquilibrium::LimitPoint, detail)
        } else {
            let status = match squeezed {
                Some(_) => NoEquilibrium::Crushed,
                None => NoEquilibrium::NotConverged,
            };
            let why = squeezed.unwrap_or_else(|| cause_text(cause).to_owned());
            let detail = format!(
                "inflation stopped at {pressure:.6} MPa of the {asked} MPa asked for ({why})"
            );
            (status, detail)
        };
        let reached = Reached {
            pressure_mpa: pressure,
            ..Reached::default()
        };
        no_equilibrium(status, detail, reached, cause)
    }
}

const REMEDY: &str = "use a thicker wall, a stiffer rubber, a carcass or less pressure";

fn ended(status: NoEquilibrium, detail: String, pressure_mpa: f64) -> SolveError {
    SolveError::NoEquilibrium {
        status,
        detail,
        reached: Reached {
            pressure_mpa,
            ..Reached::default()
        },
    }
}
