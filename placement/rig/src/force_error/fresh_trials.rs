//! Trials of what was learnt on runs that nobody learnt from: as they come, with a film dead, with films that lie elsewhere, and on other tires.
//!
//! All are the same runs, with the same stances, gains and noise, so that their errors differ by the films alone. Estimates are held against true forces.

use std::sync::atomic::{AtomicBool, Ordering};

use estimation::features::GROUPS;

use crate::contact_response::TurnableFilms;
use crate::force_error::learnt_force::LearntForce;
use crate::force_error::thinned_run::{ThinnedRun, thinning};
use crate::force_error::tried_rows::{TriedRow, error_of, in_contact, tried, worst_contact};
use crate::seeded_draws::{SeededDraws, Stream};
use documents::rig::rig_settings::RigSettings;
use results::film::force_error::{
    AskewError, DeadFilmError, ElsewhereError, TrialError, WorstContact,
};

/// Runs of each kind: one would show the luck of its gains.
const RUNS: usize = 2;
/// A trial keeps as many rows as one of so many runs: of more runs each would have few.
const AS_OF: usize = 4;
/// Standard deviation of the places of films that are askew, degrees around the wheel: about a millimetre on the foot tire.
const ASKEW_DEG: f64 = 3.0;
/// Rows of all runs from which the film is told whose loss costs most.
const DEAD_ROWS: usize = 160;

/// Runs that nobody learns from.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FreshTrials {
    /// Runs as they come.
    pub fresh: FreshRuns,
    askew: Vec<ThinnedRun>,
    elsewhere: Vec<Elsewhere>,
}

/// Runs of a tire as they come.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FreshRuns {
    runs: Vec<ThinnedRun>,
    contact_deg: [f64; 2],
}

/// Errors on runs as they come.
#[derive(Debug, Clone, Default)]
pub(crate) struct Fresh {
    /// Error of all rows.
    pub fresh: TrialError,
    /// Error of those with a contact.
    pub in_contact: TrialError,
    /// Worst part of the wheel.
    pub worst_contact: Option<WorstContact>,
}

/// Another tire with the same films.
#[derive(Debug, Clone, PartialEq)]
pub struct OtherTire<R> {
    /// Difference from the study's tire, in words.
    pub described: String,
    /// Whether estimators learn from it, too.
    pub learnt: bool,
    /// Response of the tire.
    pub response: R,
}

/// Runs on another tire.
#[derive(Debug, Clone, PartialEq)]
struct Elsewhere {
    described: String,
    learnt: bool,
    runs: Vec<ThinnedRun>,
}

impl FreshRuns {
    /// Records them, counted behind those of the settings; None where the caller stops meanwhile.
    pub fn recorded<R: TurnableFilms>(
        response: &R,
        settings: &RigSettings,
        stop: &AtomicBool,
    ) -> Option<Self> {
        Some(Self {
            runs: all_recorded(response, settings, stop)?,
            contact_deg: settings.gait.contact_deg,
        })
    }

    /// Tries it on them.
    pub fn errors(&self, learnt: &LearntForce, axis: usize) -> Fresh {
        let tried = tried(learnt, &self.runs, axis);
        Fresh {
            fresh: error_of(&tried),
            in_contact: error_of(&in_contact(&self.runs, &tried)),
            worst_contact: worst_contact(&self.runs, &tried, self.contact_deg),
        }
    }
}

/// Numbers of the runs that nobody learns from.
fn numbers(settings: &RigSettings) -> impl Iterator<Item = u64> {
    (settings.runs..settings.runs + RUNS).map(|run| run as u64)
}

fn all_recorded<R: TurnableFilms>(
    response: &R,
    settings: &RigSettings,
    stop: &AtomicBool,
) -> Option<Vec<ThinnedRun>> {
    let runs = numbers(settings).map(|run| recorded(response, settings, run, stop));
    runs.collect()
}

fn recorded<R: TurnableFilms>(
    response: &R,
    settings: &RigSettings,
    run: u64,
    stop: &AtomicBool,
) -> Option<ThinnedRun> {
    let one_of = thinning(settings, settings.runs.min(AS_OF));
    let stopped = stop.load(Ordering::Relaxed);
    (!stopped).then(|| ThinnedRun::recorded(response, settings, run, one_of))
}

impl FreshTrials {
    /// Records them, counted behind those of the settings; None where the caller stops meanwhile.
    pub fn recorded<R: TurnableFilms>(
        response: &R,
        others: &[OtherTire<R>],
        settings: &RigSettings,
        stop: &AtomicBool,
    ) -> Option<Self> {
        let askew = |run: u64| {
            let mut draws = SeededDraws::new(settings.seed, run, Stream::Place);
            let by_deg: Vec<f64> = (0..response.films())
                .map(|_| ASKEW_DEG * draws.normal())
                .collect();
            recorded(&response.turned(&by_deg), settings, run, stop)
        };
        Some(Self {
            fresh: FreshRuns::recorded(response, settings, stop)?,
            askew: numbers(settings).map(askew).collect::<Option<_>>()?,
            elsewhere: others
                .iter()
                .map(|other| {
                    Some(Elsewhere {
                        described: other.described.clone(),
                        learnt: other.learnt,
                        runs: all_recorded(&other.response, settings, stop)?,
                    })
                })
                .collect::<Option<_>>()?,
        })
    }

    /// Tries it on the runs with films askew.
    pub fn askew(&self, learnt: &LearntForce, axis: usize) -> AskewError {
        AskewError {
            std_deg: ASKEW_DEG,
            error: error_of(&tried(learnt, &self.askew, axis)),
        }
    }

    /// Tries it on the runs with other tires.
    pub fn elsewhere(&self, learnt: &LearntForce, axis: usize) -> Vec<ElsewhereError> {
        let on = |other: &Elsewhere| ElsewhereError {
            tire: other.described.clone(),
            learnt: other.learnt,
            error: error_of(&tried(learnt, &other.runs, axis)),
        };
        self.elsewhere.iter().map(on).collect()
    }

    /// Tries it on the runs with the film dead whose loss costs most; None without films.
    pub fn dead(&self, learnt: &LearntForce, axis: usize) -> Option<DeadFilmError> {
        let fresh = &self.fresh.runs;
        let films = fresh.first()?.features.ncols() / GROUPS;
        let squares = |film: usize| -> f64 {
            let runs = fresh.iter().map(|run| {
                let few = (RUNS * run.time_s.len()).div_ceil(DEAD_ROWS).max(1);
                let dead = run.with_dead_film(film);
                let rows = (0..dead.time_s.len()).step_by(few);
                let squares = rows.map(|row| TriedRow::of(learnt, &dead, axis, row).square());
                squares.sum::<f64>()
            });
            runs.sum()
        };
        let costs: Vec<f64> = (0..films).map(squares).collect();
        // The first of equal ones.
        let film = (0..films)
            .rev()
            .max_by(|a, b| costs[*a].total_cmp(&costs[*b]))?;
        let dead: Vec<ThinnedRun> = fresh.iter().map(|run| run.with_dead_film(film)).collect();
        Some(DeadFilmError {
            film,
            error: error_of(&tried(learnt, &dead, axis)),
        })
    }
}
