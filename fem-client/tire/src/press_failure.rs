//! Reasons why a tire can't be pressed further, or dragged: the loss of stability on the ground, the depth of self-contact.

use fem::newton::iteration::Cause;
use fem::newton::path::{PathFailure, PathReport, Stability};
use fem::newton::watch::Watch;
use fem::problem::{Loads, State};

use crate::ground_path::GroundPath;
use crate::model::TireModel;
use crate::self_contact::touches_itself;
use crate::session::Session;
use fem_client::solver::{NoEquilibrium, Reached, SolveError};

/// Fraction of the path within which lost stability is where it ended.
const NEARBY: f64 = 1.0 / 64.0;
/// Principal stretch below which a missing equilibrium is put down to compression: mixed elements lose their stability at
/// 0.68 on a distorted mesh.
const CRUSHED: f64 = 0.6;
/// Halvings of the path to the target in the search of the first self-contact.
const SELF_CONTACT_STEPS: usize = 7;
/// Reach of a search over what a tire may bear, or over the end of the search before.
const SELF_CONTACT_REACH: f64 = 4.0;
/// Searches, each beyond the end of the one before.
const SELF_CONTACT_ROUNDS: usize = 4;

/// Explains why a path ended at this state, the last equilibrium; or returns the equilibrium at its target, if the end was another branch's, on which
/// the tire touches itself.
pub(crate) fn path_failure(
    session: &mut Session<'_>,
    path: &GroundPath<'_>,
    state: &State,
    failure: &PathFailure,
) -> Result<(State, PathReport), SolveError> {
    if failure.cause != Cause::Stopped && touches_itself(session.model, state) {
        return self_contact(session, path);
    }
    let inertia = session.newton.inertia_at(state, &failure.loads);
    let buckled = inertia.is_ok_and(|inertia| !inertia.is_positive());
    let squeezed = session.newton.stretch_range(state).smallest;
    let reached = loads_reached(session.model, &failure.loads, state);
    let load = reached.load_n;
    let stopped = path.leg.stopped(session.scene, failure.reached, load);
    Err(stopped_error(stopped, failure, reached, buckled, squeezed))
}

/// Returns the share of a path to which the search goes beyond this one, at most the target.
fn beyond(share: f64) -> f64 {
    (SELF_CONTACT_REACH * share).min(1.0)
}

/// The state on a path, from one share of it to another, with the path there; `None` where the tire touches itself then, or isn't found.
///
/// # Errors
/// A path that was stopped says nothing of contact.
fn apart_at(
    session: &mut Session<'_>,
    path: &GroundPath<'_>,
    state: &State,
    shares: [f64; 2],
) -> Result<Option<(State, PathReport)>, SolveError> {
    let mut trial = state.clone();
    let [from, to] = shares.map(|share| path.start.towards(path.target, share));
    let followed = session.follow(&mut trial, &from, &to, Stability::Ignored);
    if session.watch.is_stopped() {
        return Err(SolveError::Stopped);
    }
    let found = followed
        .ok()
        .filter(|_| !touches_itself(session.model, &trial));
    Ok(found.map(|report| (trial, report)))
}

/// Loads of an equilibrium on the path.
fn loads_reached(model: &TireModel, loads: &Loads, state: &State) -> Reached {
    // Without any force the ground touches, wherever the search for more began.
    let rise = if loads.ground_force == Some(0.0) {
        0.0
    } else {
        state.rise
    };
    let depths = loads.ground.as_ref().map_or(Vec::new(), |ground| {
        ground.depths.iter().map(|depth| depth + rise).collect()
    });
    Reached {
        pressure_mpa: loads.pressure,
        depths_mm: depths,
        load_n: loads.ground_force.map(|force| model.multiplicity() * force),
    }
}

/// Goes in small steps the path of a tire that touches itself at its target when it goes in large ones.
///
/// # Errors
/// How far it can go before it touches itself. Large steps may end on another branch: the smallest path at which one touches
/// is tried again from nearby, and the search goes on beyond it where it doesn't.
pub(crate) fn self_contact(
    session: &mut Session<'_>,
    path: &GroundPath<'_>,
) -> Result<(State, PathReport), SolveError> {
    let (mut apart, mut touching) = (0.0, beyond(path.leg.bearable(session.scene)));
    let mut state = path.begin.clone();
    for _ in 0..SELF_CONTACT_ROUNDS {
        for _ in 0..SELF_CONTACT_STEPS {
            let middle = 0.5 * (apart + touching);
            match apart_at(session, path, &state, [apart, middle])? {
                Some((trial, _)) => (apart, state) = (middle, trial),
                None => touching = middle,
            }
        }
        match apart_at(session, path, &state, [apart, touching])? {
            Some(found) if touching == 1.0 => return Ok(found),
            Some((trial, _)) => (apart, state, touching) = (touching, trial, beyond(touching)),
            None => break,
        }
    }
    let reached = path.start.towards(path.target, apart);
    Err(SolveError::NoEquilibrium {
        status: NoEquilibrium::SelfContact,
        detail: format!(
            "the inner surface touches itself between {}: {}",
            path.leg.between(session.scene, [apart, touching]),
            path.leg.remedy()
        ),
        reached: loads_reached(session.model, &reached, &state),
    })
}

fn stopped_error(
    stopped: String,
    failure: &PathFailure,
    reached: Reached,
    buckled: bool,
    squeezed: f64,
) -> SolveError {
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
    let detail = format!("{stopped} ({why})");
    no_equilibrium(status, detail, reached, failure.cause)
}

/// Says how far the rubber is squeezed, where that is what a mesh can't follow any further.
pub(crate) fn crushed(smallest_stretch: f64) -> Option<String> {
    (smallest_stretch < CRUSHED).then(|| {
        format!(
            "some rubber is squeezed to {smallest_stretch:.2} of its length there: the wall is crushed or folded beyond what \
             this mesh can follow"
        )
    })
}

/// Says what ended the iterations, and what happened on the path.
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
