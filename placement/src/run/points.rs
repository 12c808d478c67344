//! Solves the points of a plan that the archive lacks, on plain threads.
//!
//! The cut point is solved first, from scratch. All others start from the cut point's equilibrium and from no other:
//! a start from whichever neighbour happens to be ready would make the answer depend on the order of the work. So a
//! point's answer is the same to the bit on any number of threads and after any interruption.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use fem_client::solver::{
    Cost, Readout, Response, SolveError, SolveRequest, Solved, Solver, StartState,
};

use super::finite::not_finite;
use super::{Event, Observer, RunError, refusals};
use crate::archive::{Archive, ArchiveError, PointRecord};
use crate::plan::Plan;
use crate::result::FailedPoint;
use crate::study::sha256_hex;

/// What the points of one run share.
pub(crate) struct Points<'r> {
    pub plan: &'r Plan,
    pub readout: Readout,
    pub solver: &'r dyn Solver,
    pub archive: &'r dyn Archive,
    pub stop: &'r AtomicBool,
    pub observer: Observer<'r>,
    /// Content key of each point.
    pub keys: Vec<String>,
}

/// What a solve gave and what it took.
type Answer = (Response, Cost);

/// Something of the point with this ordinal.
type Numbered<T> = (usize, T);

/// Answers in the order of the plan, and how many of them were there already.
pub(crate) struct Answers {
    pub points: Vec<Answer>,
    pub reused: usize,
}

/// Content keys: SHA-256 over all that determines a response to the bit, which is the solver's version, the scene, the
/// readout and the start. The cut point starts from scratch, the others from the cut point, which its key stands for.
pub(crate) fn keys(plan: &Plan, solver: &dyn Solver, readout: &Readout) -> Vec<String> {
    let version = solver.version();
    let key = |scene: &fem_client::scene::Scene, start: &str| {
        let content = serde_json::json!({
            "solver": version, "scene": scene.to_value(), "readout": readout, "start": start,
        });
        sha256_hex(&content.to_string())
    };
    let cut = key(&plan.points[0], "scratch");
    let others: Vec<String> = plan.points[1..]
        .iter()
        .map(|scene| key(scene, &cut))
        .collect();
    std::iter::once(cut).chain(others).collect()
}

/// Why one point has no answer.
enum Lack {
    /// The point itself: its siblings go on.
    Failed(SolveError),
    /// The run ends.
    Stopped,
    /// The run ends.
    Archive(ArchiveError),
}

impl Points<'_> {
    /// Loads or solves every point.
    pub fn answers(&self, threads: usize) -> Result<Answers, RunError> {
        let mut found = Vec::with_capacity(self.keys.len());
        for (ordinal, key) in self.keys.iter().enumerate() {
            found.push(self.archive.load(key, ordinal)?);
        }
        let reused = found.iter().flatten().count();
        let lacking: Vec<usize> = (0..found.len()).filter(|i| found[*i].is_none()).collect();
        (self.observer)(Event::Started {
            points: found.len(),
            reused,
        });
        let done = Mutex::new(reused);
        if !lacking.is_empty() {
            let start = self.cut_point(&mut found[0], &done)?;
            let rest: Vec<usize> = lacking.into_iter().filter(|i| *i != 0).collect();
            for (ordinal, answer) in self.others(&rest, &start, threads, &done)? {
                found[ordinal] = Some(answer);
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

    /// The equilibrium at the means, from the archive or solved now.
    fn cut_point(
        &self,
        found: &mut Option<Answer>,
        done: &Mutex<usize>,
    ) -> Result<StartState, RunError> {
        let key = &self.keys[0];
        if found.is_some() {
            let start = self.archive.load_start(key)?;
            return start.ok_or_else(|| RunError::StartMissing { key: key.clone() });
        }
        let solved = match self.solved(0, None) {
            Ok(solved) => solved,
            Err(lack) => return Err(self.cut_error(lack)),
        };
        self.save(0, &solved, Some(&solved.state))?;
        self.report_solved(0, &solved.cost, done);
        *found = Some((solved.response, solved.cost));
        Ok(solved.state)
    }

    /// Without the cut point there is nothing for the others to start from.
    fn cut_error(&self, lack: Lack) -> RunError {
        match lack {
            Lack::Stopped => RunError::Stopped,
            Lack::Archive(error) => RunError::Archive(error),
            Lack::Failed(SolveError::Refused { faults }) => RunError::Refused { faults },
            Lack::Failed(error) => {
                self.report_failed(0, &error);
                RunError::PointsFailed {
                    failed: vec![self.failed_point(0, &error)],
                }
            }
        }
    }

    /// Solves the points with these ordinals, all from the same start.
    fn others(
        &self,
        ordinals: &[usize],
        start: &StartState,
        threads: usize,
        done: &Mutex<usize>,
    ) -> Result<Vec<Numbered<Answer>>, RunError> {
        let next = AtomicUsize::new(0);
        let broken = AtomicBool::new(false);
        let outcomes = Mutex::new(Vec::with_capacity(ordinals.len()));
        let work = || {
            while !broken.load(Ordering::Relaxed) {
                let Some(&ordinal) = ordinals.get(next.fetch_add(1, Ordering::Relaxed)) else {
                    return;
                };
                let outcome = self.point(ordinal, start, done);
                if matches!(outcome, Err(Lack::Stopped | Lack::Archive(_))) {
                    broken.store(true, Ordering::Relaxed);
                }
                lock(&outcomes).push((ordinal, outcome));
            }
        };
        std::thread::scope(|scope| {
            for _ in 0..threads.clamp(1, ordinals.len().max(1)) {
                scope.spawn(work);
            }
        });
        let mut outcomes = outcomes
            .into_inner()
            .unwrap_or_else(PoisonError::into_inner);
        outcomes.sort_by_key(|(ordinal, _)| *ordinal);
        self.sorted_out(outcomes)
    }

    /// Solves, saves and reports one point, in this order: what is reported survives.
    fn point(
        &self,
        ordinal: usize,
        start: &StartState,
        done: &Mutex<usize>,
    ) -> Result<Answer, Lack> {
        match self.solved(ordinal, Some(start)) {
            Ok(solved) => {
                self.save(ordinal, &solved, None).map_err(Lack::Archive)?;
                self.report_solved(ordinal, &solved.cost, done);
                Ok((solved.response, solved.cost))
            }
            Err(lack) => {
                if let Lack::Failed(error) = &lack {
                    self.report_failed(ordinal, error);
                }
                Err(lack)
            }
        }
    }

    /// An archive's failure comes before a stop, a stop before failed points.
    fn sorted_out(
        &self,
        outcomes: Vec<Numbered<Result<Answer, Lack>>>,
    ) -> Result<Vec<Numbered<Answer>>, RunError> {
        let (mut answers, mut failed) = (Vec::new(), Vec::new());
        let (mut stopped, mut archive) = (false, None);
        for (ordinal, outcome) in outcomes {
            match outcome {
                Ok(answer) => answers.push((ordinal, answer)),
                Err(Lack::Failed(error)) => failed.push(self.failed_point(ordinal, &error)),
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

    /// One solve; a solver that broke is asked once more.
    fn solved(&self, ordinal: usize, start: Option<&StartState>) -> Result<Solved, Lack> {
        match self.attempt(ordinal, start) {
            Err(SolveError::Broken { .. }) => self.attempt(ordinal, start),
            other => other,
        }
        .map_err(|error| match error {
            SolveError::Stopped => Lack::Stopped,
            error => Lack::Failed(error),
        })
    }

    /// A panic costs this point alone.
    fn attempt(&self, ordinal: usize, start: Option<&StartState>) -> Result<Solved, SolveError> {
        if self.stop.load(Ordering::Relaxed) {
            return Err(SolveError::Stopped);
        }
        let scene = &self.plan.points[ordinal];
        let request = SolveRequest {
            scene,
            readout: &self.readout,
            start,
            stop: self.stop,
        };
        // Nothing of ours is half-changed by an unwinding solve: it only reads what it was given.
        let outcome = catch_unwind(AssertUnwindSafe(|| self.solver.solve(&request)));
        let broken = |detail| SolveError::Broken { detail };
        let solved = outcome.map_err(|panic| broken(format!("panic: {}", message(&*panic))))??;
        match not_finite(&solved.response) {
            Some(what) => Err(broken(format!("{what} isn't a finite number"))),
            None => Ok(solved),
        }
    }

    fn save(
        &self,
        ordinal: usize,
        solved: &Solved,
        start: Option<&StartState>,
    ) -> Result<(), ArchiveError> {
        self.archive.save(&PointRecord {
            key: &self.keys[ordinal],
            ordinal,
            scene: &self.plan.points[ordinal].canonical_json(),
            response: &solved.response,
            cost: solved.cost,
            start,
        })
    }

    /// Counts and reports under one lock, so that the counts arrive in order.
    fn report_solved(&self, ordinal: usize, cost: &Cost, done: &Mutex<usize>) {
        let mut done = lock(done);
        *done += 1;
        (self.observer)(Event::PointSolved {
            ordinal,
            done: *done,
            of: self.keys.len(),
            wall_s: cost.wall_s,
            newton_iterations: cost.newton_iterations,
        });
    }

    fn report_failed(&self, ordinal: usize, error: &SolveError) {
        (self.observer)(Event::PointFailed {
            ordinal,
            cause: cause(error),
        });
    }

    fn failed_point(&self, ordinal: usize, error: &SolveError) -> FailedPoint {
        let values = self.plan.values()[ordinal].clone();
        FailedPoint {
            ordinal,
            values,
            cause: cause(error),
        }
    }
}

fn cause(error: &SolveError) -> String {
    match error {
        SolveError::Refused { faults } => format!("{error}: {}", refusals(faults)),
        other => other.to_string(),
    }
}

fn message(panic: &(dyn std::any::Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("no message")
}

/// A counter or list is whole even when an observer panicked while it was locked.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
