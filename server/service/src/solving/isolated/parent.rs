//! The solver that starts a process for a solve, and waits for it.

use std::io::{self, Read, Write};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use document::visible::visible;
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver, Watch};
use placement::points::usage::credit;

use super::child::ARGUMENT;
use super::ending::{Blame, blame, memory_kills};
use super::messages::{Answer, Order};
use crate::solving::inner_tells;

/// Interval at which it is looked whether the process has ended or is to end.
const LOOK: Duration = Duration::from_millis(10);
/// Bytes of a process's last words that are repeated.
const LAST_WORDS: usize = 500;

/// Starts the process that solves.
type Start = Box<dyn Fn() -> Command + Send + Sync>;
type SolveResult = Result<Solved, SolveError>;

/// Another solver, which is also asked in a process of its own.
pub struct Isolated {
    solver: Arc<dyn Solver>,
    start: Start,
}

impl Isolated {
    /// Solves by `solver`, and in a process of its own by what the command starts: this program with [`ARGUMENT`], or what speaks like it.
    pub fn new(
        solver: Arc<dyn Solver>,
        start: impl Fn() -> Command + Send + Sync + 'static,
    ) -> Self {
        Self {
            solver,
            start: Box::new(start),
        }
    }
}

/// Returns the command of this program, to solve for its parent.
pub(crate) fn own_program() -> Command {
    // Linux knows it even after its file was replaced by another version, whose numbers may be others.
    let program = match cfg!(target_os = "linux") {
        true => PathBuf::from("/proc/self/exe"),
        false => std::env::current_exe().unwrap_or_default(),
    };
    let mut command = Command::new(program);
    command.arg(ARGUMENT);
    command
}

impl Solver for Isolated {
    fn version(&self) -> String {
        self.solver.version()
    }

    inner_tells!();

    fn solve(&self, request: &SolveRequest<'_>) -> SolveResult {
        self.solver.solve(request)
    }

    fn solve_isolated(&self, request: &SolveRequest<'_>) -> SolveResult {
        let order = serde_json::to_string(&Order::of(request)).map_err(broken)?;
        let mut command = (self.start)();
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        // Ctrl-C on a terminal is for the parent, which ends its child itself.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let kills_before = memory_kills();
        let mut child = command.spawn().map_err(unstarted)?;
        let ended = attend(&mut child, &(order + "\n"), request.watch).map_err(broken)?;
        if ended.stopped {
            return Err(SolveError::Stopped);
        }
        ended.result(memory_kills() > kills_before)
    }
}

/// A process that has ended.
struct Ended {
    status: ExitStatus,
    /// Whether the caller wished for it.
    stopped: bool,
    answer: Vec<u8>,
    /// Bytes that it wrote to standard error.
    words: Vec<u8>,
}

impl Ended {
    fn result(&self, lacked_memory: bool) -> SolveResult {
        let words = last_words(&self.words);
        match blame(self.status, lacked_memory) {
            Blame::Itself(cause) => {
                tracing::error!(
                    cause,
                    words,
                    "a solve crashed the process that it was alone in"
                );
                let detail = [cause, &words].join(": ");
                let detail = detail.trim_end_matches(": ").to_owned();
                Err(SolveError::Crashed { detail })
            }
            Blame::Outside(signal) => Err(broken(format!(
                "its process was ended from outside, by signal {signal}"
            ))),
            Blame::Nobody => match serde_json::from_slice::<Answer>(&self.answer) {
                Ok(answer) => {
                    let (result, cpu_s) = answer.outcome();
                    credit(cpu_s);
                    result
                }
                Err(_) => Err(broken(format!(
                    "its process ended without an answer ({}): {words}",
                    self.status
                ))),
            },
        }
    }
}

fn broken(detail: impl std::fmt::Display) -> SolveError {
    SolveError::Broken {
        detail: detail.to_string(),
    }
}

fn unstarted(error: io::Error) -> SolveError {
    broken(format!("no process could be started for a solve: {error}"))
}

/// Tells a process its order and listens until it has ended, or is to end.
fn attend(child: &mut Child, order: &str, watch: &dyn Watch) -> io::Result<Ended> {
    let (input, output, errors) = (child.stdin.take(), child.stdout.take(), child.stderr.take());
    thread::scope(|scope| {
        let telling = scope.spawn(move || {
            let mut input = input;
            // A process that doesn't listen has ended, and how is seen below.
            let _ = input
                .as_mut()
                .map(|input| input.write_all(order.as_bytes()));
            input
        });
        let answer = scope.spawn(|| read(output));
        let words = scope.spawn(|| read(errors));
        let ended = wait(child, watch);
        // Not before: the process ends when nobody holds its input any more.
        drop(telling.join());
        let (status, stopped) = ended?;
        Ok(Ended {
            status,
            stopped,
            answer: answer.join().unwrap_or_default(),
            words: words.join().unwrap_or_default(),
        })
    })
}

fn read(pipe: Option<impl Read>) -> Vec<u8> {
    let mut bytes = Vec::new();
    if let Some(mut pipe) = pipe {
        // What was read before an error tells as much as there is to tell.
        let _ = pipe.read_to_end(&mut bytes);
    }
    bytes
}

/// Waits for the process; returns how it ended, and whether it was for the caller's wish.
fn wait(child: &mut Child, watch: &dyn Watch) -> io::Result<(ExitStatus, bool)> {
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok((status, false));
        }
        if watch.is_stopped() {
            child.kill()?;
            return Ok((child.wait()?, true));
        }
        thread::sleep(LOOK);
    }
}

/// Returns what a process said last, on one line.
fn last_words(words: &[u8]) -> String {
    let from = words.len().saturating_sub(LAST_WORDS);
    let text = String::from_utf8_lossy(&words[from..]);
    let lines: Vec<&str> = text.split_whitespace().collect();
    visible(&lines.join(" "))
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::sync::atomic::AtomicBool;
    use std::time::Instant;

    use super::*;
    use fem_client::closed_form::ClosedFormSolver;
    use fem_client::scene::Scene;
    use fem_client::solver::Readout;

    /// Asks a process that does this instead of solving.
    fn ask(script: &'static str, stop: &AtomicBool) -> SolveResult {
        let shell = move || {
            let mut command = Command::new("sh");
            command.args(["-c", script]);
            command
        };
        let solver = Isolated::new(Arc::new(ClosedFormSolver::new()), shell);
        solver.solve_isolated(&SolveRequest {
            scene: &Scene::default(),
            readout: &Readout::default(),
            start: None,
            watch: stop,
        })
    }

    fn error(script: &'static str) -> SolveError {
        ask(script, &AtomicBool::new(false)).expect_err("it solves nothing")
    }

    #[test]
    fn a_crash_is_told_from_a_kill_and_both_from_an_end_without_an_answer() {
        let crash = error("read order; echo element 3 is inside out >&2; kill -ABRT $$");
        let detail = "SIGABRT: element 3 is inside out".to_owned();
        assert_eq!(crash, SolveError::Crashed { detail });
        let silent = error("kill -SEGV $$");
        let detail = "SIGSEGV".to_owned();
        assert_eq!(silent, SolveError::Crashed { detail });
        let kill = error("kill -TERM $$");
        assert_eq!(
            kill,
            broken("its process was ended from outside, by signal 15")
        );
        let end = error("echo lost >&2; exit 101");
        let detail = "its process ended without an answer (exit status: 101): lost";
        assert_eq!(end, broken(detail));
    }

    #[test]
    fn the_wish_to_stop_ends_the_process() {
        // Far beyond the time that it takes to end a process.
        const PATIENCE: Duration = Duration::from_secs(30);
        let begun = Instant::now();
        let stopped = ask("exec sleep 3600", &AtomicBool::new(true));
        assert_eq!(stopped.map(|_| ()), Err(SolveError::Stopped));
        assert!(begun.elapsed() < PATIENCE);
    }
}
