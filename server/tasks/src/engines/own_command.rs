//! A command of the user's, which ends when all tasks have: GNU parallel, HyperQueue, or what else starts programs.
//!
//! It holds a lock on a file as long as any process of it runs, so that it isn't begun twice. Its group of processes is noted, so that whoever comes later can end it.

use std::fs::{File, OpenOptions, TryLockError};
use std::os::unix::process::CommandExt;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use super::{Engine, Standing, Work, quiet, said};
use crate::task_error::TaskError;

/// Time that a command has to end after it was asked to; tasks hand in what they have.
const PATIENCE: Duration = Duration::from_secs(60);
/// Time that it has to end after it was killed.
const LAST: Duration = Duration::from_secs(5);
/// File of the lock in the folder of the tasks.
const LOCK: &str = "command.lock";
/// File of the group of processes beside it.
const GROUP: &str = "command.json";

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

    fn start(&mut self, work: &Work<'_>, lock: File) -> Result<(), TaskError> {
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
        let child =
            child.map_err(|error| TaskError::Engine(format!("sh can't be started: {error}")))?;
        let group = child.id();
        self.child = Some(child);
        work.folder.write_note(GROUP, &group)
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
    fn asked(&self) -> Result<(), String> {
        Ok(())
    }

    fn begin(&mut self, work: &Work<'_>) -> Result<(), TaskError> {
        match lock(work).map_err(TaskError::Failed)? {
            Some(lock) => self.start(work, lock),
            None => Ok(()),
        }
    }

    fn standing(&mut self, work: &Work<'_>) -> Result<Standing, String> {
        let ended = match &mut self.child {
            Some(child) => child.try_wait().map_err(|error| error.to_string())?,
            None => None,
        };
        if ended.is_some() {
            self.child = None;
        }
        let failed = ended.filter(|status| !status.success());
        let is_at_work = self.child.is_some() || lock(work)?.is_none();
        // Which of the others wait, it alone knows.
        let lacks = (1..=work.count).filter(|number| !work.folder.done(*number).exists());
        Ok(Standing {
            running: match is_at_work {
                true => lacks.count().max(1),
                false => 0,
            },
            news: failed.map(|status| format!("the command of the engine ended with {status}")),
            ..Standing::default()
        })
    }

    fn cancel(&mut self, work: &Work<'_>) -> Result<(), String> {
        let noted = work.folder.note(GROUP).ok().flatten();
        let group: Option<u32> = self.child.as_ref().map(Child::id).or(noted);
        let begun = Instant::now();
        let mut signal = "-TERM";
        while !self.standing(work)?.is_over() {
            let group = group.filter(|_| begun.elapsed() < PATIENCE + LAST);
            let group = group.ok_or_else(|| {
                format!(
                    "the command that does {} may still run",
                    work.folder.path().display()
                )
            })?;
            let is_late = begun.elapsed() > PATIENCE;
            if signal == "-TERM" || is_late {
                // A command that has just ended can't be told.
                let _ = said(quiet("kill").args([signal, "--", &format!("-{group}")]));
                signal = "-KILL";
            }
            std::thread::sleep(Duration::from_millis(50));
        }
        Ok(())
    }
}
