//! Engines: schedulers, or anything else that starts programs on other machines.
//!
//! - `slurm` and `own_command` are such
//! - `submission`: what Slurm was asked for, kept beside the tasks
//! - [`engine_name`]: which of them somebody means, and how it is set

pub mod engine_name;
mod own_command;
mod slurm;
mod submission;

use std::process::{Command, Stdio};

use document::visible::visible;

use crate::task_error::TaskError;
use crate::task_folder::TaskFolder;

/// Variable of a service's secret, which reaches no engine and no job.
const SECRET: &str = "STRAINSITE_TOKEN";

/// Tasks of a folder, of which an engine is to do all.
pub struct Work<'w> {
    pub(crate) folder: &'w TaskFolder,
    /// Name that no other work has.
    pub(crate) name: &'w str,
    /// Tasks, of which the first has number 1.
    pub(crate) count: usize,
}

/// Tasks that haven't ended.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Standing {
    /// Tasks that wait.
    pub waiting: usize,
    /// Tasks that run; of a command of the user's all that it hasn't handed in.
    pub running: usize,
    /// Reason why the first of them waits, in the engine's words.
    pub because: Option<String>,
    /// News for whoever asked, a sentence.
    pub news: Option<String>,
}

impl Standing {
    /// Whether nothing waits or runs any more.
    pub(crate) fn is_over(&self) -> bool {
        self.waiting + self.running == 0
    }
}

/// Scheduler, or anything else that starts programs on other machines.
pub trait Engine: Send {
    /// Asks whether it would take a task, as far as that can be known without giving it one.
    ///
    /// # Errors
    /// When it is missing or refuses, in its words.
    fn asked(&self) -> Result<(), String>;

    /// Has the tasks begun that haven't been, by whatever process of ours that was.
    ///
    /// # Errors
    /// [`TaskError::Engine`] when the engine is missing, full or refuses, in its words.
    fn begin(&mut self, work: &Work<'_>) -> Result<(), TaskError>;

    /// Says what waits and runs.
    ///
    /// # Errors
    /// When the engine doesn't answer, in its words: it may do so later.
    fn standing(&mut self, work: &Work<'_>) -> Result<Standing, String>;

    /// Ends what waits and runs, which hands in what it has.
    ///
    /// # Errors
    /// When something may still run, a sentence.
    fn cancel(&mut self, work: &Work<'_>) -> Result<(), String>;
}

/// A command that knows nothing of our secrets and asks nothing.
fn quiet(program: &str) -> Command {
    let mut command = Command::new(program);
    command.env_remove(SECRET).stdin(Stdio::null());
    command
}

/// Returns what a program prints.
///
/// # Errors
/// Its own words where it fails; a sentence where it isn't there.
fn said(command: &mut Command) -> Result<String, String> {
    let program = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => format!("there is no {program} on this machine's PATH"),
        _ => format!("{program} can't be started: {error}"),
    })?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let words = String::from_utf8_lossy(&output.stderr);
    let words = words.trim();
    let words = words.strip_prefix(&format!("{program}: ")).unwrap_or(words);
    Err(format!(
        "{program}: {}",
        visible(&words.replace('\n', "; "))
    ))
}
