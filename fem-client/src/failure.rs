//! Why a tire has no equilibrium: the limit pressure named, the loss of stability under the ground, the depth of
//! self-contact.

use std::sync::atomic::AtomicBool;

use fem::newton::{Cause, Newton};
use fem::path::{PathFailure, Stability, follow};
use fem::problem::{Loads, State};
use fem::volume_control::{Inflated, VolumeControl};

use crate::scene::Scene;
use crate::self_contact::touches_itself;
use crate::solver::{NoEquilibrium, Reached, SolveError};
use crate::tire::TireModel;

/// Growth of the volume within which a limit point is looked for.
const LARGEST_GROWTH: f64 = 4.0;
/// Halvings of the way to the depths in the search of the first self-contact.
const SELF_CONTACT_STEPS: usize = 7;

/// The limit point beyond a state that inflation didn't get past, found with the volume prescribed.
pub(crate) fn limit_point(
    scene: &Scene,
    model: &TireModel,
    state: &State,
    failure: &PathFailure,
    stop: &AtomicBool,
) -> Option<Inflated> {
    if failure.cause == Cause::Stopped {
        return None;
    }
    let mut control = VolumeControl::new(&model.problem).ok()?;
    let start = control
        .at(state.clone(), failure.loads.pressure, stop)
        .ok()?;
    let limit = control
        .limit_point(&start, LARGEST_GROWTH * start.volume, stop)
        .ok()??;
    (limit.pressure < scene.pressure.internal_mpa).then_some(limit)
}

/// Why pressing ended at this state.
pub(crate) fn pressing_failure(
    scene: &Scene,
    newton: &mut Newton<'_>,
    state: &State,
    failure: &PathFailure,
) -> SolveError {
    let inertia = newton.inertia_at(state, &failure.loads);
    let buckled = inertia.is_ok_and(|inertia| !inertia.is_positive());
    pressing_error(scene, failure, buckled)
}

/// How far a tire can be pressed from its inflated state before it touches itself, which it does at the target.
pub(crate) fn self_contact(
    model: &TireModel,
    newton: &mut Newton<'_>,
    inflated: &State,
    [unpressed, target]: [&Loads; 2],
    stop: &AtomicBool,
) -> SolveError {
    let (mut apart, mut touching) = (0.0, 1.0);
    let mut state = inflated.clone();
    for _ in 0..SELF_CONTACT_STEPS {
        let middle = 0.5 * (apart + touching);
        let mut trial = state.clone();
        let [from, to] = [apart, middle].map(|t| unpressed.towards(target, t));
        let path = follow(newton, &mut trial, &from, &to, Stability::Ignored, stop);
        if path.is_ok() && !touches_itself(model, &trial) {
            (apart, state) = (middle, trial);
        } else {
            touching = middle;
        }
    }
    let depths = |loads: &Loads| loads.ground.as_ref().map(|ground| ground.depths.clone());
    let reached = unpressed.towards(target, apart);
    SolveError::NoEquilibrium {
        status: NoEquilibrium::SelfContact,
        detail: format!(
            "the inner surface touches itself between {:.1} and {:.1} % of the way to the depths {:?} mm: press less, or \
             inflate more",
            100.0 * apart,
            100.0 * touching,
            depths(target).unwrap_or_default()
        ),
        reached: Reached {
            pressure_mpa: reached.pressure,
            depths_mm: depths(&reached).unwrap_or_default(),
        },
    }
}

/// Inflation beyond the limit point.
pub(crate) fn beyond_limit(scene: &Scene, limit: &Inflated) -> SolveError {
    let (pressure, asked) = (limit.pressure, scene.pressure.internal_mpa);
    SolveError::NoEquilibrium {
        status: NoEquilibrium::LimitPoint,
        detail: format!(
            "the limit pressure of this tire is {pressure:.6} MPa, below the {asked} MPa asked for: beyond it no equilibrium \
             holds; use a thicker wall, a stiffer rubber, a carcass or less pressure"
        ),
        reached: Reached {
            pressure_mpa: pressure,
            depths_mm: Vec::new(),
        },
    }
}

pub(crate) fn inflation_error(scene: &Scene, failure: &PathFailure) -> SolveError {
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

fn pressing_error(scene: &Scene, failure: &PathFailure, buckled: bool) -> SolveError {
    let depths = failure
        .loads
        .ground
        .as_ref()
        .map(|ground| ground.depths.clone())
        .unwrap_or_default();
    let (status, why) = if buckled {
        let why = "the equilibrium there is unstable: the wall buckles";
        (NoEquilibrium::LimitPoint, why)
    } else {
        (NoEquilibrium::NotConverged, cause(failure.cause))
    };
    let detail = format!(
        "pressing stopped at {:.1} % of the way to the depths {:?} mm ({why})",
        100.0 * failure.reached,
        scene.ground.depths_mm,
    );
    let reached = Reached {
        pressure_mpa: failure.loads.pressure,
        depths_mm: depths,
    };
    no_equilibrium(status, detail, reached, failure.cause)
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
