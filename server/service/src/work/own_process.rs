//! The parent of a process that works: starts it, listens to it, and waits for its end.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::Duration;

use document::visible::visible;
use rustix::process::{Pid, Signal, kill_process};

use super::ending::{Blame, blame, memory_kills};
use super::{ANSWER, TOLD};

/// Interval at which it is looked whether the process has ended or is to end.
const LOOK: Duration = Duration::from_millis(10);
/// Bytes of a process's last words that are repeated.
const LAST_WORDS: usize = 500;

/// Starts a process that works.
pub type Start = Box<dyn Fn() -> Command + Send + Sync>;

/// Wish of those who wait for the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wish {
    /// Work on.
    GoOn,
    /// Rest: others have their turn.
    Rest,
    /// End at once.
    Stop,
}

/// Reason why a process gave no answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Unanswered {
    /// The wish to stop.
    Stopped,
    /// End by what it worked on: how.
    Crashed(String),
    /// Another reason, a sentence.
    Broken(String),
}

/// Returns the command of this program, to work for its parent on what the argument names.
pub fn own_program(argument: &str) -> Command {
    // Linux knows it even after its file was replaced by another version, whose numbers may be others.
    let program = match cfg!(target_os = "linux") {
        true => PathBuf::from("/proc/self/exe"),
        false => std::env::current_exe().unwrap_or_default(),
    };
    let mut command = Command::new(program);
    command.arg(argument);
    command
}

/// Has a process work on an order, and returns its answer; `heard` is told how far it is.
pub(crate) fn ask(
    mut command: Command,
    order: &str,
    wish: &dyn Fn() -> Wish,
    heard: &(dyn Fn(&str) + Sync),
) -> Result<String, Unanswered> {
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    // Ctrl-C on a terminal is for the parent, which ends its child itself.
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    let kills_before = memory_kills();
    let broken = |error: io::Error| Unanswered::Broken(error.to_string());
    let unstarted =
        |error| Unanswered::Broken(format!("no process could be started for it: {error}"));
    let mut child = command.spawn().map_err(unstarted)?;
    let ended = attend(&mut child, order, wish, heard).map_err(broken)?;
    if ended.stopped {
        return Err(Unanswered::Stopped);
    }
    ended.answer(memory_kills() > kills_before)
}

/// A process that has ended.
struct Ended {
    status: ExitStatus,
    /// Whether the caller wished for it.
    stopped: bool,
    answer: Option<String>,
    /// Bytes that it wrote to standard error.
    words: Vec<u8>,
}

impl Ended {
    fn answer(self, lacked_memory: bool) -> Result<String, Unanswered> {
        let words = last_words(&self.words);
        match blame(self.status, lacked_memory) {
            Blame::Itself(cause) => {
                tracing::error!(
                    cause,
                    words,
                    "work crashed the process that it was alone in"
                );
                let detail = [cause, &words].join(": ");
                let detail = detail.trim_end_matches(": ").to_owned();
                Err(Unanswered::Crashed(detail))
            }
            Blame::Outside(signal) => Err(Unanswered::Broken(format!(
                "its process was ended from outside, by signal {signal}"
            ))),
            Blame::Nobody => self.answer.ok_or_else(|| {
                Unanswered::Broken(format!(
                    "its process ended without an answer ({}): {words}",
                    self.status
                ))
            }),
        }
    }
}

/// Tells a process its order and listens until it has ended, or is to end.
fn attend(
    child: &mut Child,
    order: &str,
    wish: &dyn Fn() -> Wish,
    heard: &(dyn Fn(&str) + Sync),
) -> io::Result<Ended> {
    let (input, output, errors) = (child.stdin.take(), child.stdout.take(), child.stderr.take());
    thread::scope(|scope| {
        let telling = scope.spawn(move || {
            let mut input = input;
            // A process that doesn't listen has ended, and how is seen below.
            let _ = input.as_mut().map(|input| {
                input.write_all(order.as_bytes())?;
                input.write_all(b"\n")
            });
            input
        });
        let answer = scope.spawn(|| listen(output, heard));
        let words = scope.spawn(|| read(errors));
        let ended = wait(child, wish);
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

/// Passes on what is told, and returns the answer.
fn listen(pipe: Option<impl Read>, heard: &(dyn Fn(&str) + Sync)) -> Option<String> {
    let mut answer = None;
    // What was read before an error tells as much as there is to tell.
    let lines = BufReader::new(pipe?).lines().map_while(Result::ok);
    for line in lines {
        if let Some(told) = line.strip_prefix(TOLD) {
            heard(told);
        } else if let Some(text) = line.strip_prefix(ANSWER) {
            answer = Some(text.to_owned());
        }
    }
    answer
}

fn read(pipe: Option<impl Read>) -> Vec<u8> {
    let mut bytes = Vec::new();
    if let Some(mut pipe) = pipe {
        let _ = pipe.read_to_end(&mut bytes);
    }
    bytes
}

/// Waits for the process; returns how it ended, and whether it was for the caller's wish.
fn wait(child: &mut Child, wish: &dyn Fn() -> Wish) -> io::Result<(ExitStatus, bool)> {
    let mut rests = false;
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok((status, false));
        }
        match wish() {
            Wish::Stop => {
                child.kill()?;
                return Ok((child.wait()?, true));
            }
            wish if (wish == Wish::Rest) != rests => {
                rests = !rests;
                let signal = if rests { Signal::STOP } else { Signal::CONT };
                kill_process(Pid::from_child(child), signal)?;
            }
            _ => {}
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
    use std::sync::Mutex;
    use std::time::Instant;

    use super::*;

    /// Asks a process that does this.
    fn told(script: &str, wish: &dyn Fn() -> Wish) -> (Result<String, Unanswered>, Vec<String>) {
        let mut command = Command::new("sh");
        command.args(["-c", script]);
        let told = Mutex::new(Vec::new());
        let heard = |line: &str| told.lock().expect("one thread").push(line.to_owned());
        let answer = ask(command, "{}", wish, &heard);
        (answer, told.into_inner().expect("one thread"))
    }

    fn unanswered(script: &str) -> Unanswered {
        let (answer, _) = told(script, &|| Wish::GoOn);
        answer.expect_err("it answers nothing")
    }

    #[test]
    fn what_it_tells_is_heard_and_its_answer_returned() {
        let (answer, told) = told(
            "read order; echo told 1; echo told 2; echo stray; echo answer $order",
            &|| Wish::GoOn,
        );
        assert_eq!(answer, Ok("{}".to_owned()));
        assert_eq!(told, ["1", "2"]);
    }

    #[test]
    fn a_crash_is_told_from_a_kill_and_both_from_an_end_without_an_answer() {
        let crash = unanswered("read order; echo element 3 is inside out >&2; kill -ABRT $$");
        let detail = "SIGABRT: element 3 is inside out".to_owned();
        assert_eq!(crash, Unanswered::Crashed(detail));
        let silent = unanswered("kill -SEGV $$");
        assert_eq!(silent, Unanswered::Crashed("SIGSEGV".to_owned()));
        let kill = unanswered("kill -TERM $$");
        let detail = "its process was ended from outside, by signal 15".to_owned();
        assert_eq!(kill, Unanswered::Broken(detail));
        let end = unanswered("echo lost >&2; exit 101");
        let detail = "its process ended without an answer (exit status: 101): lost".to_owned();
        assert_eq!(end, Unanswered::Broken(detail));
    }

    #[test]
    fn the_wish_to_stop_ends_the_process() {
        // Far beyond the time that it takes to end a process.
        const PATIENCE: Duration = Duration::from_secs(30);
        let begun = Instant::now();
        let (stopped, _) = told("exec sleep 3600", &|| Wish::Stop);
        assert_eq!(stopped, Err(Unanswered::Stopped));
        assert!(begun.elapsed() < PATIENCE);
    }

    #[test]
    fn a_process_that_rests_goes_on_when_it_is_wished() {
        const REST: Duration = Duration::from_millis(300);
        let begun = Instant::now();
        let wish = || match begun.elapsed() < REST {
            true => Wish::Rest,
            false => Wish::GoOn,
        };
        let (answer, _) = told("sleep 0.05; echo answer late", &wish);
        assert_eq!(answer, Ok("late".to_owned()));
        assert!(begun.elapsed() >= REST);
    }
}
