//! The cheapest model that serves: from a draft up, until a tolerance or a budget is met.
//!
//! Each rung is the study on one mesh with one method. When its claimed error is still too large, the next rung mends the larger
//! part: a finer mesh, or the method that adapts itself. What was solved stays in the archive, and what a rung shares with
//! an earlier one isn't solved again. A budget ends a rung in the middle; the answer is then that of the last whole one.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use fem_client::scene::Level;
use gsa::method::Kind;

use crate::answer::{answer_of, effect_notes};
use crate::assumptions::measuring_assumptions;
use crate::ladder::effects;
use crate::ladder::fidelity::Fidelity;
use crate::layout::solving::measuring_layouts;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::usage::Stopwatch;
use crate::response_table::measuring_forces;
use crate::run::{Ran, run_from};
use crate::signals::measuring;
use documents::parts::directions::Directions;
use documents::study::plan::Plan;
use documents::study::{Accuracy, Study};
use results::{Climb, ClimbRung, GradedNote, Output, StudyResult, Topic};

/// Share of the tolerance that the method may take; the mesh has the rest.
const OF_METHOD: f64 = 0.5;
/// Share of what the finest mesh leaves of the tolerance that the method may take then.
const OF_REST: f64 = 0.8;
/// Exponent with which a solve's time grows with the number of cells, at most.
const GROWTH: f64 = 1.5;
/// Times as many solves as the plan of the lines that the adaptive method is expected to take.
const OF_ADAPTING: f64 = 3.0;
const SIGNALS_LEFT_OUT: &str =
    "The budget left no time for the films' signals: a study with accuracy.preset solves them.";
const FORCES_LEFT_OUT: &str =
    "The budget left no time for the rig: a study with accuracy.preset solves its table.";
const LAYOUTS_LEFT_OUT: &str =
    "The budget left no time for layouts: a study with accuracy.preset scores them.";
/// Interval at which a run looks whether its time is up.
const LOOK: Duration = Duration::from_millis(10);

/// Answers a study with the accuracy that it asks for.
///
/// # Errors
/// See [`RunError`].
pub fn answer(
    study: &Study,
    plan: &Plan,
    context: RunContext<'_>,
) -> Result<StudyResult, RunError> {
    let mut ran = match study.accuracy {
        Accuracy::Preset => {
            let mut ran = run_from(0, study, plan, context)?;
            with_further_solves(ran.points, study, plan, &mut ran, context)?;
            ran
        }
        Accuracy::Tolerance(_) => Climber::new(study, plan, context).climb()?,
        Accuracy::Budget(seconds) => within(seconds, study, plan, context)?,
    };
    ran.result.answer = answer_of(study, &ran.result, ran.slopes.as_ref());
    Ok(ran.result)
}

/// Adds the effects of what is left out, layouts, films' signals and what a rig shows, and the time that they took.
fn with_further_solves(
    first: usize,
    study: &Study,
    plan: &Plan,
    ran: &mut Ran,
    context: RunContext<'_>,
) -> Result<(), RunError> {
    let watch = Stopwatch::start();
    let Ran { result, slopes, .. } = ran;
    effects::measure(first, study, plan, result, context)?;
    for note in effect_notes(&result.model.left_out) {
        result.note(note);
    }
    let first = first + result.cost.effect_solves;
    let scored =
        measuring_layouts::measure(first, study, plan, (result, slopes.as_ref()), context)?;
    if let Some(scored) = scored {
        let first = first + result.cost.layout_solves;
        measuring_assumptions::measure(first, study, plan, (result, &scored), context)?;
    }
    let first = first + result.cost.layout_solves;
    measuring::measure(first, study, plan, result, context)?;
    let first = first + result.cost.signal_solves;
    measuring_forces::measure(first, study, plan, result, context)?;
    watch.add_to(&mut result.cost);
    Ok(())
}

/// Runs until the time is up.
fn within(
    seconds: f64,
    study: &Study,
    plan: &Plan,
    context: RunContext<'_>,
) -> Result<Ran, RunError> {
    let deadline = Instant::now() + Duration::from_secs_f64(seconds);
    let (stop, ended) = (AtomicBool::new(false), AtomicBool::new(false));
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !ended.load(Ordering::Relaxed) {
                if Instant::now() >= deadline || context.stop.load(Ordering::Relaxed) {
                    stop.store(true, Ordering::Relaxed);
                    return;
                }
                std::thread::sleep(LOOK);
            }
        });
        let inner = RunContext {
            stop: &stop,
            pause: None,
            ..context
        };
        let climbed = Climber {
            deadline: Some(deadline),
            ..Climber::new(study, plan, inner)
        }
        .climb();
        ended.store(true, Ordering::Relaxed);
        match climbed {
            Err(RunError::Stopped) if !context.stop.load(Ordering::Relaxed) => {
                Err(RunError::Budget { seconds })
            }
            other => other,
        }
    })
}

struct Climber<'c> {
    study: &'c Study,
    plan: &'c Plan,
    context: RunContext<'c>,
    deadline: Option<Instant>,
    rungs: Vec<ClimbRung>,
    walls_s: Vec<f64>,
    /// Points of the rungs so far.
    points: usize,
    /// Error that the method may claim.
    of_method: f64,
}

impl<'c> Climber<'c> {
    fn new(study: &'c Study, plan: &'c Plan, context: RunContext<'c>) -> Self {
        Self {
            study,
            plan,
            context,
            deadline: None,
            rungs: Vec::new(),
            walls_s: Vec::new(),
            points: 0,
            of_method: match study.accuracy {
                Accuracy::Tolerance(tolerance) => OF_METHOD * tolerance,
                _ => f64::INFINITY,
            },
        }
    }

    fn climb(mut self) -> Result<Ran, RunError> {
        let begun = Instant::now();
        let mut fidelity = Fidelity::of(self.study);
        let mut best = self.rung(fidelity)?;
        while let Some(next) = self.next(fidelity, &best.result) {
            fidelity = next;
            match self.rung(fidelity) {
                Ok(ran) => best = ran,
                // A rung that time ran out on leaves the answer of the one before; the caller knows whose stop it was.
                Err(RunError::Stopped) if self.is_late() => break,
                Err(error) => return Err(error),
            }
        }
        match with_further_solves(self.points, self.study, self.plan, &mut best, self.context) {
            // They are worth knowing, not worth the answer.
            Err(RunError::Stopped) if self.is_late() => {
                let best = &mut best.result;
                if self.study.signals.is_some() && best.signals.is_none() {
                    best.note(GradedNote::changing(Topic::Signals, SIGNALS_LEFT_OUT));
                }
                if self.study.rig.is_some() && best.forces.is_none() {
                    best.note(GradedNote::changing(Topic::Signals, FORCES_LEFT_OUT));
                }
                if self.study.layouts.is_asked() && best.layout_findings.is_none() {
                    best.note(GradedNote::changing(Topic::Layout, LAYOUTS_LEFT_OUT));
                }
            }
            other => other?,
        }
        let result = &mut best.result;
        result.climb = Some(Climb {
            tolerance: self.tolerance(),
            budget_s: self.budget(),
            met: self.tolerance().is_none_or(|tolerance| {
                claimed(result, self.study.directions).is_some_and(|c| c <= tolerance)
            }),
            rungs: self.rungs,
        });
        result.cost.wall_s = begun.elapsed().as_secs_f64();
        result.cost.rungs_wall_s = self.walls_s;
        Ok(best)
    }

    fn rung(&mut self, fidelity: Fidelity) -> Result<Ran, RunError> {
        let mut study = fidelity.raise(self.study);
        if fidelity.kind.is_adaptive() {
            study.method.tolerance = study.method.tolerance.min(self.of_method);
        }
        let plan = self.plan.raised(self.study, &study)?;
        let ran = run_from(self.points, &study, &plan, self.context)?;
        let result = &ran.result;
        self.points += ran.points;
        self.walls_s.push(result.cost.wall_s);
        self.rungs.push(ClimbRung {
            label: fidelity.label(),
            fidelity: fidelity.report(&study),
            solves: result.cost.solves + result.cost.coarser_solves,
            error_claimed: claimed(result, self.study.directions),
            error_of_mesh: of_mesh(result, self.study.directions),
        });
        Ok(ran)
    }

    /// The rung that mends the larger part of the error; `None` when the answer serves, or nothing better fits.
    fn next(&mut self, fidelity: Fidelity, result: &StudyResult) -> Option<Fidelity> {
        let claim = claimed(result, self.study.directions).unwrap_or(1.0);
        if self.tolerance().is_some_and(|tolerance| claim <= tolerance) {
            return None;
        }
        let finer = Level::ALL.into_iter().find(|level| *level > fidelity.level);
        let finer = finer.map(|level| Fidelity { level, ..fidelity });
        let adaptive = (!fidelity.kind.is_adaptive()).then_some(Fidelity {
            kind: Kind::Auto,
            ..fidelity
        });
        // An unknown error of the mesh may be of any size.
        let mesh = of_mesh(result, self.study.directions).unwrap_or(1.0);
        let next = if 2.0 * mesh > claim {
            finer.or(adaptive)
        } else {
            adaptive.or(finer)
        };
        next.or_else(|| self.tightened(fidelity, mesh))
            .filter(|next| self.fits(fidelity, *next))
    }

    /// The top of the ladder once more, where the mesh leaves room for a method that errs less.
    fn tightened(&mut self, fidelity: Fidelity, mesh: f64) -> Option<Fidelity> {
        let rest = OF_REST * (self.tolerance()? - mesh);
        if rest <= 0.0 || rest >= OF_REST * self.of_method {
            return None;
        }
        self.of_method = rest;
        Some(fidelity)
    }

    /// Whether a rung is expected to end in time.
    fn fits(&self, from: Fidelity, to: Fidelity) -> bool {
        let Some(deadline) = self.deadline else {
            return true;
        };
        let mut scene = self.study.scene.clone();
        let mut cells = |level| {
            scene.model.level = level;
            self.context.solver.cells(&scene) as f64
        };
        let size = (cells(to.level) / cells(from.level)).powf(GROWTH);
        let adapting = if from.kind == to.kind {
            1.0
        } else {
            OF_ADAPTING
        };
        let expected = self.walls_s.last().copied().unwrap_or(0.0) * size * adapting;
        Instant::now() + Duration::from_secs_f64(expected) < deadline
    }

    fn is_late(&self) -> bool {
        self.deadline
            .is_some_and(|deadline| Instant::now() >= deadline)
    }

    fn tolerance(&self) -> Option<f64> {
        match self.study.accuracy {
            Accuracy::Tolerance(tolerance) => Some(tolerance),
            _ => None,
        }
    }

    fn budget(&self) -> Option<f64> {
        match self.study.accuracy {
            Accuracy::Budget(seconds) => Some(seconds),
            _ => None,
        }
    }
}

/// Largest claimed error of any first-order index that is asked for at P1, P2, ..., absolute; `None` where one is missing. A strain
/// that doesn't vary has none.
fn claimed(result: &StudyResult, directions: Directions) -> Option<f64> {
    let indexed = asked(result, directions).filter(|output| output.first_order.is_some());
    let errors: Option<Vec<f64>> = indexed.map(|output| output.error.total).collect();
    errors
        .filter(|errors| !errors.is_empty())
        .map(|errors| errors.into_iter().fold(0.0, f64::max))
}

/// The mesh's part where the claimed error is largest.
fn of_mesh(result: &StudyResult, directions: Directions) -> Option<f64> {
    let claim = |output: &&Output| output.error.total.unwrap_or(0.0);
    let worst = asked(result, directions).max_by(|a, b| claim(a).total_cmp(&claim(b)));
    worst?.error.mesh
}

fn asked(result: &StudyResult, directions: Directions) -> impl Iterator<Item = &Output> {
    let outputs = result.outputs.iter();
    outputs.filter(move |output| directions.include(output.direction))
}
