//! Load stepping with automatic cut-back.

use crate::linear::factor::Inertia;
use crate::linear::system::Imbalance;
use crate::newton::iteration::{Cause, Converged, Newton, NotConverged};
use crate::newton::watch::Watch;
use crate::problem::{Loads, State};

/// Newton iterations after which a path that fails again goes on in the smallest steps: each step needs some ten.
const MANY_ITERATIONS: usize = 160;
/// Newton iterations after which a path that fails again is given up.
const MOST_ITERATIONS: usize = 320;
/// Share of a load step that is tried next when it failed.
const CUT_BACK: f64 = 0.25;

/// Whether a load step may end in an equilibrium whose tangent isn't positive definite.
///
/// A body doesn't stay in an unstable equilibrium. Where the load drives the instability, as a pressure beyond the limit
/// point does, Newton's method can jump over it to a state of no meaning, so there stability is worth requiring. Under
/// strong compression mixed elements lose definiteness on distorted meshes before the body does, so elsewhere it is not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// Unstable equilibria are refused.
    Required,
    /// Any equilibrium will do.
    Ignored,
}

/// The path ended at its target.
#[derive(Debug, Clone, PartialEq)]
pub struct PathReport {
    /// Relative residuals of each converged load step.
    pub steps: Vec<Vec<Imbalance>>,
    /// Attempts that failed and were repeated with a smaller step.
    pub cut_backs: usize,
}

/// The path ended before its target.
#[derive(Debug, Clone, PartialEq)]
pub struct PathFailure {
    /// Fraction of the path that has an equilibrium.
    pub reached: f64,
    /// Loads there.
    pub loads: Loads,
    /// Fraction of the path that the last attempt tried to add.
    pub step: f64,
    /// Cause of the last attempt's end.
    pub cause: Cause,
    /// Residuals of the last attempt.
    pub history: Vec<Imbalance>,
    /// Whether the last attempt's last tangent had negative pivots: a sign of lost stability.
    pub indefinite: bool,
    /// Attempts that met one, the last included.
    pub losses: usize,
}

impl PathFailure {
    fn new(reached: f64, loads: Loads, step: f64, losses: usize, failure: NotConverged) -> Self {
        Self {
            reached,
            loads,
            step,
            losses,
            cause: failure.cause,
            history: failure.history,
            indefinite: failure.indefinite,
        }
    }
}

/// Follows the loads from `start`, at which `state` is in equilibrium, to `target`. The first step is the whole way, or
/// the largest that the settings allow: with friction the path matters, and so do its steps. A step that fails is
/// cut to a quarter, one that succeeds doubles the next. On failure `state` is the last equilibrium.
///
/// # Errors
/// [`PathFailure`] says how far it got and why.
pub fn follow(
    newton: &mut Newton<'_>,
    state: &mut State,
    start: &Loads,
    target: &Loads,
    stability: Stability,
    watch: &dyn Watch,
) -> Result<PathReport, Box<PathFailure>> {
    let mut report = PathReport {
        steps: Vec::new(),
        cut_backs: 0,
    };
    let largest = newton.settings.largest_load_step;
    // The share that is tried of the largest step, and the one below which nothing is.
    let (mut share, smallest) = (1.0, newton.settings.smallest_load_step / largest.at(1.0));
    let mut reached = 0.0;
    let (mut cut, mut losses, before) = (false, 0, newton.effort.iterations);
    if let Err(failure) = begin(newton, state, start, target) {
        let loads = start.clone();
        let step = largest.at(0.0);
        return Err(Box::new(PathFailure::new(reached, loads, step, 0, failure)));
    }
    while reached < 1.0 {
        let step = share * largest.at(reached);
        let next = f64::min(reached + step, 1.0);
        let mut trial = state.clone();
        let loads = start.towards(target, next);
        match newton.solve(&mut trial, &loads, watch) {
            Ok(converged) if stability.accepts(newton, &trial, &loads) => {
                *state = trial;
                let ground = loads.ground_in(state);
                state.settle(newton.problem(), ground.as_ref());
                reached = next;
                watch.reached(reached);
                // A step that has just been cut back is kept once, or it would fail again at once.
                if !std::mem::take(&mut cut) {
                    share = f64::min(2.0 * share, 1.0);
                }
                report.steps.push(converged.history);
            }
            attempt => {
                let failure = refused(attempt);
                losses += usize::from(failure.indefinite);
                let spent = newton.effort.iterations - before;
                let is_last = share * CUT_BACK < smallest;
                if is_last || spent > MOST_ITERATIONS || failure.cause == Cause::Stopped {
                    let loads = start.towards(target, reached);
                    return Err(Box::new(PathFailure::new(
                        reached, loads, step, losses, failure,
                    )));
                }
                share *= CUT_BACK;
                cut = true;
                report.cut_backs += 1;
                if spent > MANY_ITERATIONS {
                    // A look at what is near, which says why the path may end here.
                    share = smallest;
                }
            }
        }
    }
    Ok(report)
}

/// Settles friction's anchors on the ground to come, and prepares for the contact that the start has.
fn begin(
    newton: &mut Newton<'_>,
    state: &mut State,
    start: &Loads,
    target: &Loads,
) -> Result<(), NotConverged> {
    if state.anchors.is_empty() {
        let ground = start.towards(target, 0.0).ground_in(state);
        state.settle(newton.problem(), ground.as_ref());
    }
    newton
        .start_from(state, start)
        .map_err(|cause| NotConverged {
            history: Vec::new(),
            cause,
            indefinite: false,
        })
}

impl Stability {
    fn accepts(self, newton: &mut Newton<'_>, state: &State, loads: &Loads) -> bool {
        let is_stable = |inertia: Inertia| inertia.is_positive();
        self == Self::Ignored || newton.inertia_at(state, loads).is_ok_and(is_stable)
    }
}

/// Returns the reason why a step is not taken: it found no equilibrium, or one that is unstable.
fn refused(attempt: Result<Converged, NotConverged>) -> NotConverged {
    attempt.map_or_else(
        |failure| failure,
        |converged| NotConverged {
            history: converged.history,
            cause: Cause::Unstable,
            indefinite: true,
        },
    )
}
