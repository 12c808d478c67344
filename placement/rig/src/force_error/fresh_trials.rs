//! Trials of what was learnt on runs that nobody learnt from: as they come, with a film dead, with films that lie elsewhere, and on other tires.
//!
//! All are the same runs, with the same stances, gains and noise, so that their errors differ by the films alone. Estimates are held against true forces.

use std::sync::atomic::{AtomicBool, Ordering};

use estimation::error_metrics::{nrmse_percent, r2, rmse};
use estimation::estimator::{Estimate, is_outside};
use estimation::features::GROUPS;

use crate::contact_response::TurnableFilms;
use crate::force_error::learnt_force::LearntForce;
use crate::force_error::thinned_run::{ThinnedRun, thinning};
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
/// Width of the parts of the wheel whose contacts are told apart, degrees.
const CONTACT_DEG: f64 = 5.0;
/// Errors of fewer rows of a part say little of it.
const FEWEST_ROWS: usize = 20;

/// Runs that nobody learns from.
#[derive(Debug, Clone, PartialEq)]
pub struct FreshTrials {
    fresh: Vec<ThinnedRun>,
    askew: Vec<ThinnedRun>,
    elsewhere: Vec<Elsewhere>,
    contact_deg: [f64; 2],
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

/// A true force with its estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Tried {
    truth: f64,
    estimate: Estimate,
    /// Whether a signal is beyond what was learnt from.
    outside: bool,
}

impl Tried {
    fn square(&self) -> f64 {
        let error = self.estimate.force - self.truth;
        error * error
    }
}

impl FreshTrials {
    /// Records them, counted behind those of the settings; None where the caller stops meanwhile.
    pub fn recorded<R: TurnableFilms>(
        response: &R,
        others: &[OtherTire<R>],
        settings: &RigSettings,
        stop: &AtomicBool,
    ) -> Option<Self> {
        let one_of = thinning(settings, settings.runs.min(AS_OF));
        let recorded = |response: &R, run: u64| {
            let stopped = stop.load(Ordering::Relaxed);
            (!stopped).then(|| ThinnedRun::recorded(response, settings, run, one_of))
        };
        let askew = |run: u64| {
            let mut draws = SeededDraws::new(settings.seed, run, Stream::Place);
            let by_deg: Vec<f64> = (0..response.films())
                .map(|_| ASKEW_DEG * draws.normal())
                .collect();
            recorded(&response.turned(&by_deg), run)
        };
        let numbers = || (settings.runs..settings.runs + RUNS).map(|run| run as u64);
        let on = |tire: &R| {
            numbers()
                .map(|run| recorded(tire, run))
                .collect::<Option<_>>()
        };
        Some(Self {
            fresh: on(response)?,
            askew: numbers().map(askew).collect::<Option<_>>()?,
            elsewhere: others
                .iter()
                .map(|other| {
                    Some(Elsewhere {
                        described: other.described.clone(),
                        learnt: other.learnt,
                        runs: on(&other.response)?,
                    })
                })
                .collect::<Option<_>>()?,
            contact_deg: settings.gait.contact_deg,
        })
    }

    /// Tries it on the runs as they come; with the worst contacts.
    pub fn fresh(&self, learnt: &LearntForce, axis: usize) -> (TrialError, Option<WorstContact>) {
        let tried = tried(learnt, &self.fresh, axis);
        (trial_error(&tried), self.worst_contact(&tried))
    }

    /// Tries it on the runs with films askew.
    pub fn askew(&self, learnt: &LearntForce, axis: usize) -> AskewError {
        AskewError {
            std_deg: ASKEW_DEG,
            error: trial_error(&tried(learnt, &self.askew, axis)),
        }
    }

    /// Tries it on the runs with other tires.
    pub fn elsewhere(&self, learnt: &LearntForce, axis: usize) -> Vec<ElsewhereError> {
        let on = |other: &Elsewhere| ElsewhereError {
            tire: other.described.clone(),
            learnt: other.learnt,
            error: trial_error(&tried(learnt, &other.runs, axis)),
        };
        self.elsewhere.iter().map(on).collect()
    }

    /// Tries it on the runs with the film dead whose loss costs most; None without films.
    pub fn dead(&self, learnt: &LearntForce, axis: usize) -> Option<DeadFilmError> {
        let films = self.fresh.first()?.features.ncols() / GROUPS;
        let squares = |film: usize| -> f64 {
            let runs = self.fresh.iter().map(|run| {
                let few = (RUNS * run.time_s.len()).div_ceil(DEAD_ROWS).max(1);
                let dead = run.with_dead_film(film);
                let rows = (0..dead.time_s.len()).step_by(few);
                let squares = rows.map(|row| at(learnt, &dead, axis, row).square());
                squares.sum::<f64>()
            });
            runs.sum()
        };
        let costs: Vec<f64> = (0..films).map(squares).collect();
        // The first of equal ones.
        let film = (0..films)
            .rev()
            .max_by(|a, b| costs[*a].total_cmp(&costs[*b]))?;
        let dead: Vec<ThinnedRun> = self
            .fresh
            .iter()
            .map(|run| run.with_dead_film(film))
            .collect();
        Some(DeadFilmError {
            film,
            error: trial_error(&tried(learnt, &dead, axis)),
        })
    }

    fn worst_contact(&self, tried: &[Tried]) -> Option<WorstContact> {
        let [from, to] = self.contact_deg;
        let parts = (((to - from) / CONTACT_DEG).ceil() as usize).max(1);
        let mut squares = vec![(0.0, 0usize); parts];
        let rows = self
            .fresh
            .iter()
            .flat_map(|run| (0..run.time_s.len()).map(move |row| (run, row)));
        for ((run, row), tried) in rows.zip(tried) {
            if run.touches(row) {
                let part = ((run.contact_deg[row] - from) / CONTACT_DEG) as usize;
                let (sum, count) = &mut squares[part.min(parts - 1)];
                *sum += tried.square();
                *count += 1;
            }
        }
        let known = squares
            .iter()
            .enumerate()
            .filter(|(_, (_, count))| *count >= FEWEST_ROWS);
        let errors = known.map(|(part, (sum, count))| {
            let begin = from + part as f64 * CONTACT_DEG;
            WorstContact {
                deg: 0.5 * (begin + (begin + CONTACT_DEG).min(to)),
                rmse_n: (sum / *count as f64).sqrt(),
            }
        });
        let worst = errors.max_by(|a, b| a.rmse_n.total_cmp(&b.rmse_n));
        worst.filter(|worst| worst.rmse_n.is_finite())
    }
}

fn at(learnt: &LearntForce, run: &ThinnedRun, axis: usize, row: usize) -> Tried {
    let features = run.features.row(row);
    let films = features.len() / GROUPS;
    let features = features.to_vec();
    Tried {
        truth: run.true_force_n[[row, axis]],
        estimate: learnt.model.estimate(&features),
        outside: is_outside(&features[..films], &learnt.ranges),
    }
}

fn tried(learnt: &LearntForce, runs: &[ThinnedRun], axis: usize) -> Vec<Tried> {
    let rows = runs
        .iter()
        .flat_map(|run| (0..run.time_s.len()).map(move |row| (run, row)));
    rows.map(|(run, row)| at(learnt, run, axis, row)).collect()
}

fn trial_error(tried: &[Tried]) -> TrialError {
    if tried.is_empty() {
        return TrialError::default();
    }
    let (truth, mean): (Vec<f64>, Vec<f64>) = tried
        .iter()
        .map(|tried| (tried.truth, tried.estimate.force))
        .unzip();
    let share = |is: fn(&Tried) -> bool| {
        let count = tried.iter().filter(|tried| is(tried)).count();
        count as f64 / tried.len() as f64
    };
    let covered = |Tried {
                       truth, estimate, ..
                   }: &Tried| { (estimate.low..=estimate.high).contains(truth) };
    let error = rmse(&truth, &mean);
    let finite = |x: &f64| x.is_finite();
    TrialError {
        rmse_n: Some(error).filter(finite),
        nrmse_percent: nrmse_percent(&truth, error).filter(finite),
        r2: r2(&truth, &mean).filter(finite),
        coverage: Some(share(covered)),
        outside: Some(share(|tried| tried.outside)),
    }
}
