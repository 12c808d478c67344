//! The CalculiX program: where it is, which version, and one run of it.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use fem_client::solver::Watch;

/// Name of the deck and of all files that a run writes, without their extensions.
const JOB: &str = "scene";
/// Time between looks at the stop flag and at the clock.
const PATIENCE: Duration = Duration::from_millis(20);
/// Lines of the log that an error quotes.
const QUOTED_LINES: usize = 12;
/// Words that are printed when no increment, however small, converges.
const GAVE_UP: &str = "increment size smaller than minimum";

/// The solver's program isn't there, or isn't CalculiX.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "CalculiX can't be used: {}: {cause}; install it (Debian: apt-get install calculix-ccx) or name the program in \
     STRAINSITE_CCX",
    program.display()
)]
pub struct NotInstalled {
    /// The program that was tried.
    pub program: PathBuf,
    /// Cause, in words.
    pub cause: String,
}

/// An installed CalculiX.
#[derive(Debug, Clone, PartialEq)]
pub struct Program {
    path: PathBuf,
    version: String,
    /// Longest time of one run.
    pub time_limit: Duration,
}

/// Files that a run left behind.
#[derive(Debug, Clone, PartialEq)]
pub struct Files {
    /// Whether it found no increment that converges.
    pub gave_up: bool,
    /// Printed node values.
    pub dat: String,
    /// Attempts of increments, a line each.
    pub sta: String,
    /// Iterations, a line each.
    pub cvg: String,
    /// Last lines of what it said.
    pub log: String,
}

/// A run that left nothing to read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RunError {
    /// The caller asked to stop.
    #[error("stopped on request")]
    Stopped,
    /// A run that took too long.
    #[error("CalculiX was ended after {seconds} s; its last lines:\n{log}")]
    TimedOut {
        /// The limit, s.
        seconds: u64,
        /// Last lines of its log.
        log: String,
    },
    /// A run that failed for a reason other than the increment's size.
    #[error("CalculiX ended with {status}; its last lines:\n{log}")]
    Failed {
        /// Exit status of the program.
        status: String,
        /// Last lines of its log.
        log: String,
    },
    /// A file or the program couldn't be used.
    #[error("{what}: {cause}")]
    System {
        /// The call that failed.
        what: String,
        /// The system's words.
        cause: String,
    },
}

impl Program {
    /// Asks a program for its version.
    ///
    /// # Errors
    /// [`NotInstalled`] when it doesn't start or doesn't answer as CalculiX does.
    pub fn new(path: &Path, time_limit: Duration) -> Result<Self, NotInstalled> {
        let not_installed = |cause: String| NotInstalled {
            program: path.to_owned(),
            cause,
        };
        let output = Command::new(path)
            .arg("-v")
            .stdin(Stdio::null())
            .output()
            .map_err(|error| not_installed(error.to_string()))?;
        let text = String::from_utf8_lossy(&output.stdout);
        let version = text
            .split_once("Version ")
            .and_then(|(_, rest)| rest.split_ascii_whitespace().next())
            .ok_or_else(|| not_installed("it doesn't say its version".to_owned()))?;
        Ok(Self {
            path: path.to_owned(),
            version: version.to_owned(),
            time_limit,
        })
    }

    /// The program's version, as in 2.20.
    pub fn version(&self) -> &str {
        &self.version
    }

    /// Runs a deck in an empty folder, on one thread: the caller runs a solve on each core.
    ///
    /// # Errors
    /// See [`RunError`]. A run that gave up because its increments became too small is no error here.
    pub fn run(&self, folder: &Path, deck: &str, watch: &dyn Watch) -> Result<Files, RunError> {
        let file = |extension: &str| folder.join(format!("{JOB}.{extension}"));
        std::fs::write(file("inp"), deck).map_err(|error| system("the deck", &error))?;
        let log = File::create(file("log")).map_err(|error| system("the log", &error))?;
        let errors = log.try_clone().map_err(|error| system("the log", &error))?;
        let mut command = Command::new(&self.path);
        // Ctrl-C on the terminal is for the caller, who then asks to stop; CalculiX would die of it as if it had crashed.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command
            .arg(JOB)
            .current_dir(folder)
            .env("OMP_NUM_THREADS", "1")
            .stdin(Stdio::null())
            .stdout(log)
            .stderr(errors)
            .spawn()
            .map_err(|error| system(&self.path.display().to_string(), &error))?;
        let ended = self.wait(&mut child, watch);
        let log = std::fs::read(file("log")).unwrap_or_default();
        let log = String::from_utf8_lossy(&log);
        let status = match ended? {
            Ended::Itself(status) => status,
            Ended::OutOfTime => {
                return Err(RunError::TimedOut {
                    seconds: self.time_limit.as_secs(),
                    log: last_lines(&log),
                });
            }
        };
        let gave_up = log.contains(GAVE_UP);
        // It ends with 0 after some errors in the deck, and with 201 when it gives up.
        if !gave_up && (!status.success() || log.contains("*ERROR")) {
            return Err(RunError::Failed {
                status: status.to_string(),
                log: last_lines(&log),
            });
        }
        let read = |extension: &str| {
            std::fs::read_to_string(file(extension))
                .map_err(|error| system(&format!("CalculiX's .{extension} file"), &error))
        };
        Ok(Files {
            gave_up,
            dat: read("dat")?,
            sta: read("sta")?,
            cvg: read("cvg")?,
            log: last_lines(&log),
        })
    }

    fn wait(&self, child: &mut Child, watch: &dyn Watch) -> Result<Ended, RunError> {
        let begin = Instant::now();
        loop {
            let status = child
                .try_wait()
                .map_err(|error| system("CalculiX", &error))?;
            if let Some(status) = status {
                return Ok(Ended::Itself(status));
            }
            let stopped = watch.is_stopped();
            if stopped || begin.elapsed() > self.time_limit {
                // Failure means that it ended just now.
                let _ = child.kill();
                let _ = child.wait();
                return if stopped {
                    Err(RunError::Stopped)
                } else {
                    Ok(Ended::OutOfTime)
                };
            }
            std::thread::sleep(PATIENCE);
        }
    }
}

enum Ended {
    Itself(std::process::ExitStatus),
    OutOfTime,
}

fn system(what: &str, error: &std::io::Error) -> RunError {
    RunError::System {
        what: what.to_owned(),
        cause: error.to_string(),
    }
}

fn last_lines(log: &str) -> String {
    let lines: Vec<&str> = log.lines().filter(|line| !line.trim().is_empty()).collect();
    lines[lines.len().saturating_sub(QUOTED_LINES)..].join("\n")
}

#[cfg(all(test, unix))]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::*;
    use crate::stand_in;

    /// More than a shell needs on the busiest machine: only the run without end is ended by the clock.
    const AMPLE: Duration = Duration::from_secs(60);

    /// Uses a program that answers `-v` as CalculiX does and otherwise runs these shell commands.
    fn with_stand_in<T>(commands: &str, test: impl FnOnce(&Program, &Path) -> T) -> T {
        let folder = tempfile::tempdir().expect("a folder");
        let text = format!(
            "#!/bin/sh\nif [ \"$1\" = -v ]; then echo; echo 'This is Version 9.9'; exit 0; fi\n{commands}\n"
        );
        let path = stand_in::install(folder.path(), &text);
        let program = Program::new(&path, AMPLE).expect("answers");
        test(&program, folder.path())
    }

    fn run(commands: &str, stop: bool) -> Result<Files, RunError> {
        run_within(AMPLE, commands, stop)
    }

    fn run_within(time_limit: Duration, commands: &str, stop: bool) -> Result<Files, RunError> {
        with_stand_in(commands, |program, folder| {
            let program = Program {
                time_limit,
                ..program.clone()
            };
            program.run(folder, "*HEADING\n", &AtomicBool::new(stop))
        })
    }

    const LEAVE_FILES: &str = "for e in dat sta cvg; do cp $1.inp $1.$e; done";

    #[test]
    fn the_version_is_what_the_program_says() {
        let version = with_stand_in("", |program, _| program.version().to_owned());
        assert_eq!(version, "9.9");
    }

    #[test]
    fn a_missing_program_says_what_to_install() {
        let error = Program::new(Path::new("/no/such/ccx"), Duration::ZERO).unwrap_err();
        assert!(error.to_string().contains("apt-get install calculix-ccx"));
        let other = Program::new(Path::new("/bin/true"), Duration::ZERO).unwrap_err();
        assert!(other.cause.contains("version"), "{other}");
    }

    #[test]
    fn a_run_gets_the_deck_on_one_thread_and_gives_its_files_back() {
        let files = run(
            &format!("{LEAVE_FILES}; echo threads $OMP_NUM_THREADS"),
            false,
        )
        .unwrap();
        assert_eq!(files.dat, "*HEADING\n");
        assert_eq!(files.log, "threads 1");
        assert!(!files.gave_up);
    }

    #[test]
    fn giving_up_is_told_from_failing() {
        let gave_up = format!("{LEAVE_FILES}; echo ' *ERROR: {GAVE_UP}'; exit 201");
        assert!(run(&gave_up, false).unwrap().gave_up);
        for failure in [
            "echo out of memory; exit 7".to_owned(),
            "echo ' *ERROR out of memory'; exit 0".to_owned(),
            "echo out of memory; kill -9 $$".to_owned(),
        ] {
            let error = run(&failure, false).unwrap_err();
            assert!(matches!(&error, RunError::Failed { .. }), "{error}");
            assert!(error.to_string().contains("out of memory") || failure.contains("kill"));
        }
        assert!(matches!(run("exit 0", false), Err(RunError::System { .. })));
    }

    #[test]
    fn a_run_without_end_is_ended_in_time_and_on_request() {
        let begin = Instant::now();
        let limit = Duration::from_secs(2);
        let error = run_within(limit, "echo still at it; exec sleep 60", false).unwrap_err();
        assert!(matches!(&error, RunError::TimedOut { log, .. } if log == "still at it"));
        assert_eq!(run("exec sleep 60", true), Err(RunError::Stopped));
        assert!(begin.elapsed() < Duration::from_secs(30));
    }
}
