//! Solves the points of a plan that the archive lacks, on threads of their own.
//!
//! The cut point is solved first, from scratch. Each other one starts from the equilibrium of the point that the series names, of a study's own points from the cut
//! point's: a start from whichever neighbour happens to be ready would make the answer depend on the order of the work. So a
//! point's answer is the same to the bit on any number of threads and after any interruption.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use fem_client::scene::Scene;
use fem_client::solver::{NoEquilibrium, Readout, SolveError, SolveRequest, Solver, StartState};
use rayon::iter::{ParallelBridge, ParallelIterator};

use super::attempt::{Costed, Found, Process, ask, quarantined};
use super::point_readouts::PointReadouts;
use super::point_watch::PointWatch;
use super::starts::Starts;
use crate::points::archive::{Archive, ArchiveError, Outcome, PointRecord};
use crate::points::ground_images::images_near;
use crate::points::run_error::{RunError, refusals};
use crate::points::run_event::{Event, Observer};
use results::{Cause, FailedPoint};

/// A series of points, with what they share.
pub(crate) struct Points<'r> {
    /// The scene of each.
    pub scenes: &'r [Scene],
    /// Point that each starts from.
    pub starts: Starts,
    /// Input values of each.
    pub values: &'r [Vec<f64>],
    pub readout: &'r Readout,
    pub solver: &'r dyn Solver,
    pub archive: &'r dyn Archive,
    pub stop: &'r AtomicBool,
    pub pause: Option<&'r AtomicBool>,
    pub observer: Observer<'r>,
    /// Content key of each point.
    pub keys: Vec<String>,
    /// Place of the points in the run.
    pub place: Place,
    /// Counts and locks of all series that are solved at once.
    pub shared: &'r Shared,
}

/// Counts and locks that series have in common which are solved at once.
#[derive(Default)]
pub(crate) struct Shared {
    done: Mutex<usize>,
    ended: AtomicBool,
    apart: Mutex<()>,
}

impl Shared {
    /// Points of the run that are done.
    pub fn done(&self) -> MutexGuard<'_, usize> {
        // A number is whole even when an observer panicked while it was locked.
        self.done.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Held while a solve has a process of its own: one at a time.
    pub fn alone(&self) -> MutexGuard<'_, ()> {
        self.apart.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Ends all series: what they still lack is of no use.
    pub fn end(&self) {
        self.ended.store(true, Ordering::Relaxed);
    }

    /// Whether no further point is worth its time.
    pub fn has_ended(&self) -> bool {
        self.ended.load(Ordering::Relaxed)
    }
}

/// Place of a plan's points among all that a run solves.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// Ordinal of the plan's first point: all before are done.
    pub first: usize,
    /// Points of the run, as far as that is known.
    pub of: usize,
}

/// A value with the ordinal of its point.
type Numbered<T> = (usize, T);

/// Answers in the order of the plan, and how many of them were there already.
pub(crate) struct Answers {
    pub points: Vec<Costed>,
    pub reused: usize,
}

impl Answers {
    /// Outcomes alone.
    pub fn outcomes(self) -> Vec<Outcome> {
        self.points
            .into_iter()
            .map(|(outcome, _)| outcome)
            .collect()
    }
}

/// States that points start from, by the ordinals of the points that they are said to start from.
type States = BTreeMap<usize, Begin>;

/// A state that points start from.
#[derive(Clone)]
struct Begin {
    state: Arc<StartState>,
    /// Whether it is what the keys of these points stand for. Of a point that broke, and may be solved another time, it isn't: what starts there isn't kept.
    is_keyed: bool,
}

impl Begin {
    fn keyed(state: StartState) -> Self {
        Self {
            state: Arc::new(state),
            is_keyed: true,
        }
    }
}

/// A solved point, with its state where others start from it.
type WithState = (Costed, Option<Begin>);

/// Points looked up in the archive before the run asks whether it is to stop.
const AT_ONCE: usize = 4096;

/// Crashes of its own process after which a point is left alone.
const QUARANTINE: usize = 3;

/// Points by what is known of their crashes.
#[derive(Default)]
struct Suspicion {
    clean: Vec<usize>,
    suspect: Vec<usize>,
    quarantined: Vec<Numbered<Costed>>,
}

/// Reason why a point has no answer.
enum Lack {
    /// The solver refused it: its siblings go on.
    Refused(SolveError),
    /// The run ends.
    Stopped,
    /// The run ends.
    Archive(ArchiveError),
}

impl Points<'_> {
    /// Solves every point that wasn't found in the archive, on the threads of this one's pool; the cut point's outcome is a response.
    pub fn answers(&self, mut found: Vec<Option<Costed>>) -> Result<Answers, RunError> {
        let reused = found.iter().flatten().count();
        let lacking: Vec<usize> = (0..found.len()).filter(|i| found[*i].is_none()).collect();
        let Suspicion {
            clean,
            suspect,
            quarantined,
        } = self.suspicion(&lacking)?;
        for (ordinal, answer) in quarantined {
            self.report(ordinal, &answer);
            found[ordinal] = Some(answer);
        }
        let cut_failed = matches!(found[0], Some((Err(_), _)));
        if !lacking.is_empty() || cut_failed {
            let of_cut = match suspect.first() {
                Some(0) => Process::Apart,
                _ => Process::Own,
            };
            let cut = self.cut_point(&mut found[0], of_cut)?;
            let mut states = States::from([(0, Begin::keyed(cut))]);
            for generation in self.starts.generations() {
                // Those that may end the program come last, and each alone: only one process more takes memory.
                for (ordinals, process) in [(&clean, Process::Own), (&suspect, Process::Apart)] {
                    let due = generation
                        .iter()
                        .filter(|i| ordinals.binary_search(i).is_ok());
                    let due: Vec<usize> = due.copied().collect();
                    for (ordinal, (answer, state)) in self.others(&due, &states, process)? {
                        found[ordinal] = Some(answer);
                        states.extend(state.map(|state| (ordinal, state)));
                    }
                }
                self.load_states(&generation, &found, &mut states)?;
            }
        }
        let points: Vec<_> = found.into_iter().flatten().collect();
        assert_eq!(
            points.len(),
            self.keys.len(),
            "every point is loaded, solved or reported"
        );
        Ok(Answers { points, reused })
    }

    /// Loads what the archive has of them.
    pub fn loaded(&self) -> Result<Vec<Option<Costed>>, RunError> {
        let mut found = Vec::with_capacity(self.keys.len());
        for keys in self.keys.chunks(AT_ONCE) {
            if self.stop.load(Ordering::Relaxed) {
                return Err(RunError::Stopped);
            }
            found.extend(self.archive.load(keys, self.place.first + found.len())?);
        }
        Ok(found)
    }

    /// Sorts points by what is known of their crashes.
    fn suspicion(&self, lacking: &[usize]) -> Result<Suspicion, ArchiveError> {
        let suspects = self.archive.crashes()?;
        let mut sorted = Suspicion::default();
        for &ordinal in lacking {
            match suspects.get(&self.keys[ordinal]) {
                None => sorted.clean.push(ordinal),
                Some(crashes) if crashes.own >= QUARANTINE => {
                    let found = quarantined(crashes.own, &crashes.cause);
                    sorted.quarantined.push((ordinal, found.answer));
                }
                Some(_) => sorted.suspect.push(ordinal),
            }
        }
        Ok(sorted)
    }

    /// The equilibrium at the means, from the archive or solved now.
    fn cut_point(
        &self,
        found: &mut Option<Costed>,
        process: Process,
    ) -> Result<StartState, RunError> {
        if found.is_none() {
            let Found {
                answer,
                state,
                lasting,
            } = match self.solved(0, None, process) {
                Ok(solved) => solved,
                Err(lack) => return Err(self.cut_error(lack)),
            };
            if lasting {
                self.save(0, &answer, state.as_ref())?;
            }
            self.report(0, &answer);
            *found = Some(answer);
            if let Some(state) = state {
                return Ok(state);
            }
        }
        if let Some((Err(unsolved), _)) = found {
            return Err(self.without_cut((&*unsolved).into()));
        }
        self.stored_state(0)
    }

    /// State of a point that the archive has.
    fn stored_state(&self, ordinal: usize) -> Result<StartState, RunError> {
        let key = &self.keys[ordinal];
        let start = self.archive.load_start(key)?;
        start.ok_or_else(|| RunError::StartMissing { key: key.clone() })
    }

    /// Loads the states of those points of a generation that others start from which weren't solved now. What would start from a point without an equilibrium starts where that did.
    fn load_states(
        &self,
        generation: &[usize],
        found: &[Option<Costed>],
        states: &mut States,
    ) -> Result<(), RunError> {
        for &ordinal in generation {
            if !self.starts.is_left(ordinal) || states.contains_key(&ordinal) {
                continue;
            }
            let begin = match &found[ordinal] {
                Some((Err(unsolved), _)) => {
                    let own = self.begin_of(ordinal, states);
                    let is_lasting = NoEquilibrium::ALL.contains(&unsolved.status);
                    Begin {
                        is_keyed: own.is_keyed && is_lasting,
                        ..own
                    }
                }
                _ => Begin::keyed(self.stored_state(ordinal)?),
            };
            states.insert(ordinal, begin);
        }
        Ok(())
    }

    /// The state that a point starts from, whose start is of a generation before.
    fn begin_of(&self, ordinal: usize, states: &States) -> Begin {
        states[&self.starts.of(ordinal).unwrap_or_default()].clone()
    }

    /// Returns the error of a run without the cut point: there is nothing for the others to start from.
    fn without_cut(&self, cause: Cause) -> RunError {
        RunError::PointsFailed {
            failed: vec![self.failed_point(0, cause.noting(&self.scenes[0].slips()))],
        }
    }

    fn cut_error(&self, lack: Lack) -> RunError {
        match lack {
            Lack::Stopped => RunError::Stopped,
            Lack::Archive(error) => RunError::Archive(error),
            Lack::Refused(SolveError::Refused { faults }) => RunError::Refused { faults },
            Lack::Refused(error) => {
                self.report_refused(0, &error);
                self.without_cut(Cause::other(cause(&error)))
            }
        }
    }

    /// Solves the points with these ordinals, whose starts are all there.
    fn others(
        &self,
        ordinals: &[usize],
        states: &States,
        process: Process,
    ) -> Result<Vec<Numbered<WithState>>, RunError> {
        let over = AtomicBool::new(false);
        let unless_over = |&ordinal: &usize| {
            if over.load(Ordering::Relaxed) || self.shared.has_ended() {
                return None;
            }
            let outcome = self.point(ordinal, &self.begin_of(ordinal, states), process);
            // Asked after a point, so that a run that is paused again and again still comes to its end.
            let paused = self
                .pause
                .is_some_and(|pause| pause.load(Ordering::Relaxed));
            if paused || matches!(outcome, Err(Lack::Stopped | Lack::Archive(_))) {
                over.store(true, Ordering::Relaxed);
            }
            Some((ordinal, outcome))
        };
        let mut outcomes: Vec<_> = match process {
            // Of two mirrored grounds one is still remembered when the other one's turn comes.
            Process::Own => images_near(ordinals, self.scenes)
                .iter()
                .par_bridge()
                .filter_map(unless_over)
                .collect(),
            Process::Apart => ordinals.iter().filter_map(unless_over).collect(),
        };
        outcomes.sort_by_key(|(ordinal, _)| *ordinal);
        let whole = outcomes.len() == ordinals.len();
        let answers = self.sorted_out(outcomes)?;
        if whole {
            Ok(answers)
        } else {
            Err(RunError::Paused)
        }
    }

    /// Solves, saves and reports one point, in this order: what is reported survives.
    fn point(&self, ordinal: usize, begin: &Begin, process: Process) -> Result<WithState, Lack> {
        match self.solved(ordinal, Some(&begin.state), process) {
            Ok(Found {
                answer,
                state,
                lasting,
            }) => {
                let state = state.filter(|_| self.starts.is_left(ordinal));
                if lasting {
                    let kept = match begin.is_keyed {
                        true => self.save(ordinal, &answer, state.as_ref()),
                        false => self.archive.give_up(&self.keys[ordinal]),
                    };
                    kept.map_err(Lack::Archive)?;
                }
                self.report(ordinal, &answer);
                let own = |state| Begin {
                    state: Arc::new(state),
                    ..*begin
                };
                Ok((answer, state.map(own)))
            }
            Err(lack) => {
                if let Lack::Refused(error) = &lack {
                    self.report_refused(ordinal, error);
                }
                Err(lack)
            }
        }
    }

    /// An archive's failure comes before a stop, a stop before refused points.
    fn sorted_out(
        &self,
        outcomes: Vec<Numbered<Result<WithState, Lack>>>,
    ) -> Result<Vec<Numbered<WithState>>, RunError> {
        let (mut answers, mut failed) = (Vec::new(), Vec::new());
        let (mut stopped, mut archive) = (false, None);
        for (ordinal, outcome) in outcomes {
            match outcome {
                Ok(answer) => answers.push((ordinal, answer)),
                Err(Lack::Refused(error)) => {
                    failed.push(self.failed_point(ordinal, Cause::other(cause(&error))));
                }
                Err(Lack::Stopped) => stopped = true,
                Err(Lack::Archive(error)) => archive = Some(error),
            }
        }
        match archive {
            Some(error) => Err(RunError::Archive(error)),
            None if stopped => Err(RunError::Stopped),
            None if !failed.is_empty() => Err(RunError::PointsFailed { failed }),
            None => Ok(answers),
        }
    }

    /// Solves a point, from its note in the archive to its answer.
    fn solved(
        &self,
        ordinal: usize,
        start: Option<&StartState>,
        process: Process,
    ) -> Result<Found, Lack> {
        let key = &self.keys[ordinal];
        // Before it is said to have begun: what waits for a process of its own can't have ended the program.
        let _alone = matches!(process, Process::Apart).then(|| self.shared.alone());
        self.archive.begin(key).map_err(Lack::Archive)?;
        let place = self.place.first + ordinal;
        let watch = PointWatch::new(self.stop, self.observer, place);
        let request = SolveRequest {
            scene: &self.scenes[ordinal],
            readout: &PointReadouts::new(self.readout, self.scenes).of(ordinal),
            start,
            watch: &watch,
        };
        let found = loop {
            match ask(self.solver, &request, process) {
                Err(SolveError::Crashed { detail }) => {
                    let crashes = self.archive.crashed(key, &detail);
                    let crashes = crashes.map_err(Lack::Archive)?;
                    if crashes >= QUARANTINE {
                        break Ok(quarantined(crashes, &detail));
                    }
                }
                other => break other,
            }
        };
        if !found.as_ref().is_ok_and(|found| found.lasting) {
            self.archive.give_up(key).map_err(Lack::Archive)?;
        }
        found.map_err(|error| match error {
            SolveError::Stopped => Lack::Stopped,
            error => Lack::Refused(error),
        })
    }

    fn save(
        &self,
        ordinal: usize,
        (outcome, cost): &Costed,
        start: Option<&StartState>,
    ) -> Result<(), ArchiveError> {
        self.archive.save(&PointRecord {
            key: &self.keys[ordinal],
            ordinal: self.place.first + ordinal,
            scene: &self.scenes[ordinal].canonical_json(),
            outcome,
            cost: *cost,
            start,
        })
    }

    /// Counts and reports under one lock, so that the counts arrive in order.
    fn report(&self, ordinal: usize, (outcome, cost): &Costed) {
        let mut done = self.shared.done();
        *done += 1;
        let (ordinal, of) = (self.place.first + ordinal, self.place.of);
        (self.observer)(match outcome {
            Ok(_) => Event::PointSolved {
                ordinal,
                done: *done,
                of,
                wall_s: cost.wall_s,
                newton_iterations: cost.newton_iterations,
            },
            Err(unsolved) => Event::PointFailed {
                ordinal,
                done: *done,
                of,
                cause: unsolved.to_string(),
            },
        });
    }

    /// A point that was refused isn't done.
    fn report_refused(&self, ordinal: usize, error: &SolveError) {
        let done = self.shared.done();
        (self.observer)(Event::PointFailed {
            ordinal: self.place.first + ordinal,
            done: *done,
            of: self.place.of,
            cause: cause(error),
        });
    }

    fn failed_point(&self, ordinal: usize, cause: Cause) -> FailedPoint {
        FailedPoint {
            ordinal,
            values: self.values[ordinal].clone(),
            cause,
        }
    }
}

fn cause(error: &SolveError) -> String {
    match error {
        SolveError::Refused { faults } => format!("{error}: {}", refusals(faults)),
        other => other.to_string(),
    }
}
