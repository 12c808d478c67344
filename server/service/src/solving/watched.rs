//! A solver whose every solve comes to an end in time, as far as its caller can tell.
//!
//! A solve runs on a thread of its own. When the time is over it is asked to stop; one that doesn't heed that is left behind, and its point goes without
//! an answer. A thread can't be ended from outside: what is left behind takes a core until the program ends. When the caller wishes to stop, nobody waits
//! for a factorisation, which is the longest that a solve goes without looking at its flag: 7 s of contact all over the reference mesh.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use fem_client::solver::{SolveError, SolveProgress, SolveRequest, Solved, Solver, Watch};
use placement::points::usage::{cpu_s, credit};

use crate::solving::awake_clock::AwakeClock;
use crate::solving::inner_tells;

/// Interval at which the caller's wish to stop is looked at. An answer is taken at once.
const LOOK: Duration = Duration::from_millis(10);

/// Time that a caller that wishes to stop waits for a solve.
const PATIENCE: Duration = Duration::from_secs(1);

/// Relay between a solve's own thread and the one that waits for it.
struct Relay {
    stop: AtomicBool,
    told: Mutex<Option<SolveProgress>>,
}

impl Relay {
    fn new(stop: bool) -> Self {
        Self {
            stop: AtomicBool::new(stop),
            told: Mutex::default(),
        }
    }

    fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// The newest of what was told since it was taken last.
    fn take(&self) -> Option<SolveProgress> {
        let mut told = self.told.lock().unwrap_or_else(PoisonError::into_inner);
        told.take()
    }
}

impl Watch for Relay {
    fn is_stopped(&self) -> bool {
        self.stop.is_stopped()
    }

    fn tell(&self, progress: SolveProgress) {
        let mut told = self.told.lock().unwrap_or_else(PoisonError::into_inner);
        *told = Some(progress);
    }
}

/// Another solver, watched.
pub struct Watched {
    solver: Arc<dyn Solver>,
    limit: Duration,
    grace: Duration,
}

type SolveResult = Result<Solved, SolveError>;
/// Choice of a solver's two ways to solve.
type Solving = fn(&dyn Solver, &SolveRequest<'_>) -> SolveResult;
/// Result of a solve, and the processor time of its thread, s.
type Timed = (SolveResult, f64);

impl Watched {
    /// Gives each solve of `solver` the time `limit`, and `grace` to heed its stop flag then.
    pub fn new(solver: Arc<dyn Solver>, limit: Duration, grace: Duration) -> Self {
        Self {
            solver,
            limit,
            grace,
        }
    }

    /// Waits for an answer, passing the caller's wish to stop on, and what the solve tells back, until the time is over.
    fn wait(
        &self,
        answers: &Receiver<Timed>,
        thread: JoinHandle<()>,
        asked: &dyn Watch,
        relay: &Relay,
    ) -> SolveResult {
        let mut clock = AwakeClock::start();
        let mut stopping: Option<Duration> = None;
        loop {
            match answers.recv_timeout(LOOK) {
                Ok((answer, cpu_s)) => {
                    credit(cpu_s);
                    let stopped = matches!(answer, Err(SolveError::Stopped));
                    return match stopped && !asked.is_stopped() {
                        true => Err(self.over_time(false)),
                        false => answer,
                    };
                }
                Err(RecvTimeoutError::Disconnected) => return Err(broken(thread)),
                Err(RecvTimeoutError::Timeout) => {}
            }
            if let Some(progress) = relay.take() {
                asked.tell(progress);
            }
            let wished = asked.is_stopped();
            let elapsed = clock.look();
            if stopping.is_none() && (wished || elapsed >= self.limit) {
                relay.stop();
                stopping = Some(elapsed);
            }
            let waited = stopping.map_or(Duration::ZERO, |since| elapsed - since);
            if wished && waited >= PATIENCE {
                return Err(SolveError::Stopped);
            }
            if waited >= self.grace {
                tracing::error!("a solve did not heed its stop flag; its thread is left behind");
                return Err(self.over_time(true));
            }
        }
    }

    fn over_time(&self, left_behind: bool) -> SolveError {
        SolveError::OverTime {
            limit_s: self.limit.as_secs_f64(),
            left_behind,
        }
    }
}

/// A thread that is gone without an answer has panicked; the caller is to hear of it as if it had solved itself.
fn broken(thread: JoinHandle<()>) -> SolveError {
    match thread.join() {
        Err(panic) => resume_unwind(panic),
        Ok(()) => SolveError::Broken {
            detail: "its thread ended without an answer".to_owned(),
        },
    }
}

impl Solver for Watched {
    fn version(&self) -> String {
        self.solver.version()
    }

    inner_tells!();

    fn solve(&self, request: &SolveRequest<'_>) -> SolveResult {
        self.watch(request, |solver, request| solver.solve(request))
    }

    fn solve_isolated(&self, request: &SolveRequest<'_>) -> SolveResult {
        self.watch(request, |solver, request| solver.solve_isolated(request))
    }
}

impl Watched {
    /// Has one thread solve, and waits for it.
    fn watch(&self, request: &SolveRequest<'_>, solving: Solving) -> SolveResult {
        let (tell, answers) = sync_channel(1);
        let relay = Arc::new(Relay::new(request.watch.is_stopped()));
        let (solver, watch) = (self.solver.clone(), relay.clone());
        let (scene, readout) = (request.scene.clone(), request.readout.clone());
        let start = request.start.cloned();
        let span = tracing::Span::current();
        let solve = move || {
            let _entered = span.entered();
            let request = SolveRequest {
                scene: &scene,
                readout: &readout,
                start: start.as_ref(),
                watch: &*watch,
            };
            // Nobody listens any more to a solve that was left behind.
            let answer = solving(&*solver, &request);
            let _ = tell.send((answer, cpu_s()));
        };
        match thread::Builder::new().name("solve".to_owned()).spawn(solve) {
            Ok(thread) => self.wait(&answers, thread, request.watch, &relay),
            Err(error) => Err(SolveError::Broken {
                detail: format!("no thread could be started for a solve: {error}"),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::time::Instant;

    use super::*;
    use fem_client::closed_form::ClosedFormSolver;
    use fem_client::scene::Scene;
    use fem_client::solver::Readout;

    /// Takes what it is made to take, heeding its stop flag or not.
    enum Stuck {
        Heeding,
        Deaf,
        Panicking,
    }

    impl Solver for Stuck {
        fn version(&self) -> String {
            "stuck".to_owned()
        }

        fn solve(&self, request: &SolveRequest<'_>) -> SolveResult {
            match self {
                Self::Panicking => panic!("element 3 is inside out"),
                Self::Deaf => loop {
                    thread::park_timeout(Duration::from_secs(3600));
                },
                Self::Heeding => {
                    while !request.watch.is_stopped() {
                        thread::sleep(Duration::from_millis(1));
                    }
                    Err(SolveError::Stopped)
                }
            }
        }
    }

    fn watched(solver: impl Solver + 'static, limit: Duration) -> Watched {
        Watched::new(Arc::new(solver), limit, Duration::from_millis(200))
    }

    fn ask(solver: &dyn Solver, stop: &AtomicBool) -> SolveResult {
        solver.solve(&SolveRequest {
            scene: &Scene::default(),
            readout: &Readout::default(),
            start: None,
            watch: stop,
        })
    }

    const SHORT: Duration = Duration::from_millis(50);
    const LONG: Duration = Duration::from_secs(3600);

    #[test]
    fn an_answer_in_time_is_the_solver_s_own() {
        let go = AtomicBool::new(false);
        let plain = ask(&ClosedFormSolver::new(), &go).expect("answers");
        let guarded = ask(&watched(ClosedFormSolver::new(), LONG), &go).expect("answers");
        assert_eq!(guarded.response, plain.response);
        assert_eq!(guarded.state, plain.state);
    }

    #[test]
    fn a_solve_that_takes_too_long_ends_and_says_whether_it_heeded() {
        let go = AtomicBool::new(false);
        for (solver, left_behind) in [(Stuck::Heeding, false), (Stuck::Deaf, true)] {
            let error = ask(&watched(solver, SHORT), &go).expect_err("too long");
            let limit_s = SHORT.as_secs_f64();
            let expected = SolveError::OverTime {
                limit_s,
                left_behind,
            };
            assert_eq!(error, expected);
        }
    }

    #[test]
    fn the_caller_s_wish_to_stop_is_passed_on() {
        let stop = AtomicBool::new(false);
        thread::scope(|scope| {
            let solve = scope.spawn(|| ask(&watched(Stuck::Heeding, LONG), &stop));
            thread::sleep(SHORT);
            stop.store(true, Ordering::Relaxed);
            let answer = solve.join().expect("no panic");
            assert_eq!(answer.map(|_| ()), Err(SolveError::Stopped));
        });
    }

    #[test]
    fn a_caller_that_wishes_to_stop_waits_for_no_deaf_solve() {
        let stop = AtomicBool::new(true);
        let begun = Instant::now();
        let solver = Watched::new(Arc::new(Stuck::Deaf), LONG, LONG);
        let answer = ask(&solver, &stop);
        assert_eq!(answer.map(|_| ()), Err(SolveError::Stopped));
        assert!(begun.elapsed() >= PATIENCE);
    }

    #[test]
    fn a_panic_reaches_the_caller_with_its_message() {
        let go = AtomicBool::new(false);
        let solver = watched(Stuck::Panicking, LONG);
        let unwound = catch_unwind(AssertUnwindSafe(|| ask(&solver, &go))).expect_err("a panic");
        let message = unwound.downcast_ref::<&str>().copied();
        assert_eq!(message, Some("element 3 is inside out"));
    }
}
