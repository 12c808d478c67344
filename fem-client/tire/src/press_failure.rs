//! Why a tire can't be pressed further: the loss of stability under the ground, the depth of self-contact.

use std::sync::atomic::Ordering;

use fem::newton::iteration::Cause;
use fem::newton::path::{PathFailure, PathReport, Stability};
use fem::problem::{Loads, State};

use crate::self_contact::touches_itself;
use crate::session::Session;
use fem_client::scene::Scene;
use fem_client::solver::{NoEquilibrium, Reached, SolveError};

/// Fraction of the way to the depths within which lost stability is where pressing ended.
const NEARBY: f64 = 1.0 / 64.0;
/// Principal stretch below which a missing equilibrium is put down to compression: mixed elements lose their stability at
/// 0.68 on a distorted mesh.
const CRUSHED: f64 = 0.6;
/// Halvings of the way to the depths in the search of the first self-contact.
const SELF_CONTACT_STEPS: usize = 7;

/// Why pressing ended at this state, the last equilibrium; or the equilibrium at the target, if the end was another
/// branch's, on which the tire touches itself.
pub(crate) fn pressing_failure(
    session: &mut Session<'_>,
    inflated: &State,
    target: &Loads,
    state: &State,
    failure: &PathFailure,
) -> Result<(State, PathReport), SolveError> {
    if failure.cause != Cause::Stopped && touches_itself(session.model, state) {
        return self_contact(session, inflated, target);
    }
    let inertia = session.newton.inertia_at(state, &failure.loads);
    let buckled = inertia.is_ok_and(|inertia| !inertia.is_positive());
    let squeezed = session.newton.stretch_range(state).smallest;
    Err(pressing_error(session.scene, failure, buckled, squeezed))
}

/// Presses in small steps a tire that touches itself at the target when it is pressed in large ones.
///
/// # Errors
/// How far it can be pressed from its inflated state before it touches itself. Large steps may end on another branch: where no
/// smaller one touches, the target itself is tried again from nearby.
pub(crate) fn self_contact(
    session: &mut Session<'_>,
    inflated: &State,
    target: &Loads,
) -> Result<(State, PathReport), SolveError> {
    let unpressed = session.inflation();
    let (mut apart, mut touching) = (0.0, 1.0);
    let mut state = inflated.clone();
    for _ in 0..SELF_CONTACT_STEPS {
        let middle = 0.5 * (apart + touching);
        let mut trial = state.clone();
        let [from, to] = [apart, middle].map(|t| unpressed.towards(target, t));
        let path = session.follow(&mut trial, &from, &to, Stability::Ignored);
        if path.is_ok() && !touches_itself(session.model, &trial) {
            (apart, state) = (middle, trial);
        } else {
            touching = middle;
        }
        // A path that was stopped says nothing of contact.
        if session.stop.load(Ordering::Relaxed) {
            return Err(SolveError::Stopped);
        }
    }
    if touching == 1.0 {
        let from = unpressed.towards(target, apart);
        let path = session.follow(&mut state, &from, target, Stability::Ignored);
        if let Some(report) = path.ok().filter(|_| !touches_itself(session.model, &state)) {
            return Ok((state, report));
        }
    }
    let depths = |loads: &Loads| loads.ground.as_ref().map(|ground| ground.depths.clone());
    let reached = unpressed.towards(target, apart);
    Err(SolveError::NoEquilibrium {
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
    })
}

fn pressing_error(
    scene: &Scene,
    failure: &PathFailure,
    buckled: bool,
    squeezed: f64,
) -> SolveError {
    let depths = failure
        .loads
        .ground
        .as_ref()
        .map(|ground| ground.depths.clone())
        .unwrap_or_default();
    let (status, why) = if buckled {
        let why = "the equilibrium there is unstable: the wall buckles";
        (NoEquilibrium::LimitPoint, why.to_owned())
    } else if failure.indefinite && failure.step <= NEARBY {
        let why = "the next step leads through unstable states only: the wall buckles, snaps through or folds";
        (NoEquilibrium::LimitPoint, why.to_owned())
    } else if let Some(why) = crushed(squeezed) {
        (NoEquilibrium::Crushed, why)
    } else {
        (NoEquilibrium::NotConverged, unconverged(failure))
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

/// How far the rubber is squeezed, where that is what a mesh can't follow any further.
pub(crate) fn crushed(smallest_stretch: f64) -> Option<String> {
    (smallest_stretch < CRUSHED).then(|| {
        format!(
            "some rubber is squeezed to {smallest_stretch:.2} of its length there: the wall is crushed or folded beyond what \
             this mesh can follow"
        )
    })
}

/// What ended the iterations, and what happened on the way.
fn unconverged(failure: &PathFailure) -> String {
    let cause = cause_text(failure.cause);
    if failure.losses == 0 {
        return cause.to_owned();
    }
    format!(
        "{cause}; {} attempts met unstable states: the wall wrinkles or snaps from one shape to the next, more often than was \
         followed",
        failure.losses
    )
}

pub(crate) fn no_equilibrium(
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

pub(crate) fn cause_text(cause: Cause) -> &'static str {
    match cause {
        Cause::Iterations => "too many Newton iterations",
        Cause::Diverged => "the residual grew without bound",
        Cause::Inverted => "an element would turn inside out",
        Cause::Singular(_) => "the tangent is singular",
        Cause::Unstable => "the equilibrium found is unstable",
        Cause::Stopped => "stopped on request",
    }
}
