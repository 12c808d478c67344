//! A command of the user's, which ends when all tasks have: GNU parallel, HyperQueue, or what else starts programs.
//!
//! It holds a lock on a file as long as any process of it runs, so that it isn't begun twice.

use std::fs::{File, OpenOptions, TryLockError};
use std::os::unix::process::CommandExt;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use super::engine::{Engine, Standing, Work, quiet, said};
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::warn;

/// Time that a command has to end after it was asked to; tasks hand in what they have.
const PATIENCE: Duration = Duration::from_secs(60);
/// File of the lock in the folder of the tasks.
const LOCK: &str = "command.lock";

/// A command of the user's.
pub(super) struct OwnCommand {
    text: String,
    /// The command, where this process began it.
    child: Option<Child>,
}

impl OwnCommand {
    /// A command for a shell, which finds program, folder and numbers of the tasks in its environment.
    pub fn new(text: &str) -> Self {
        Self {
            text: text.to_owned(),
            child: None,
        }
    }

    fn start(&mut self, work: &Work<'_>, lock: File) -> Result<(), Failure> {
        let numbers: Vec<String> = (1..=work.count).map(|number| number.to_string()).collect();
        let child = quiet("sh")
            .args(["-c", &self.text])
            .env("PROGRAM", work.folder.program())
            .env("FOLDER", work.folder.path())
            .env("TASKS", numbers.join(" "))
            .env("COUNT", work.count.to_string())
            // A lock goes with the last process that has the file open.
            .stdin(lock)
            // What is printed here is the comparison.
            .stdout(Stdio::from(std::io::stderr()))
            .process_group(0)
            .spawn();
        self.child =
            Some(child.map_err(|error| Failure::Other(format!("sh can't be started: {error}")))?);
        Ok(())
    }
}

/// The lock of a folder's command, or none while a process of it runs.
fn lock(work: &Work<'_>) -> Result<Option<File>, String> {
    let path = work.folder.path().join(LOCK);
    let failed = |error: std::io::Error| format!("{} can't be locked: {error}", path.display());
    let mut options = OpenOptions::new();
    let file = options
        .create(true)
        .truncate(false)
        .read(true)
        .write(true)
        .open(&path);
    let file = file.map_err(failed)?;
    match file.try_lock() {
        Ok(()) => Ok(Some(file)),
        Err(TryLockError::WouldBlock) => Ok(None),
        Err(TryLockError::Error(error)) => Err(failed(error)),
    }
}

impl Engine for OwnCommand {
    fn begin(&mut self, work: &Work<'_>) -> Result<(), Failure> {
        match lock(work).map_err(Failure::Other)? {
            Some(lock) => self.start(work, lock),
            None => Ok(()),
        }
    }

    fn standing(&mut self, work: &Work<'_>) -> Result<Standing, String> {
        let ended = match &mut self.child {
            Some(child) => child.try_wait().map_err(|error| error.to_string())?,
            None => None,
        };
        if let Some(status) = ended {
            self.child = None;
            if !status.success() {
                warn(&format!(
                    "the command of --engine-command ended with {status}\n"
                ));
            }
        }
        let running = usize::from(self.child.is_some() || lock(work)?.is_none());
        Ok(Standing {
            running,
            ..Standing::default()
        })
    }

    fn cancel(&mut self, work: &Work<'_>) {
        let Some(mut child) = self.child.take() else {
            warn(&format!(
                "the command that an earlier strainsite began for {} may still run\n",
                work.folder.path().display()
            ));
            return;
        };
        let group = format!("-{}", child.id());
        let send = |signal: &str| said(quiet("kill").args([signal, "--", &group]));
        // A command that has just ended can't be told.
        let _ = send("-TERM");
        let begun = Instant::now();
        while matches!(child.try_wait(), Ok(None)) {
            if begun.elapsed() > PATIENCE {
                let _ = send("-KILL");
            }
            std::thread::sleep(Duration::from_millis(50));
        }
    }
}
