//! Folder of a sweep's tasks, which all machines see:
//!
//! - `strainsite`: the program, so that nodes run the head's
//! - `tasks.json`: what the tasks are
//! - `asked/N.db`: the designs of a task, in the queue
//! - `done/N.db`: what came of it; `done/N.refused.json`: why a node handed in nothing; `done/N.refused.db`: what the head refused

use std::fs::{self, DirBuilder};
use std::os::unix::fs::DirBuilderExt;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use placement::sharing::Part;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use crate::task_error::TaskError;

/// Tasks of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Tasks {
    /// Version of the head's solver, with the fingerprint of its numerics.
    pub version: String,
    /// Identifier of the sweep.
    pub sweep: String,
    /// Extent of what machines hand in.
    #[serde(default)]
    pub kept: Kept,
    /// The tasks, of which the first has number 1.
    pub tasks: Vec<Task>,
}

/// Extent of what is kept of what a task solves.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Kept {
    /// Points and results
    #[default]
    Everything,
    /// Results alone, a quarter of the room: what a design needs that hasn't ended is solved again
    Results,
}

/// Designs that one machine solves, or a part of the points of one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Task {
    /// Identifiers of their studies.
    pub studies: Vec<String>,
    /// Part of the points of its only study; all that is asked of them when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<Part>,
    /// Time that they are expected to take on the head's threads, s.
    pub expected_s: Option<f64>,
}

/// Reason why a node handed in nothing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub struct Refusal {
    /// Name of the node.
    pub node: String,
    /// A sentence.
    pub because: String,
}

/// The folder.
#[derive(Debug, Clone)]
pub struct TaskFolder {
    path: PathBuf,
}

impl TaskFolder {
    /// A new folder, which nobody else may look into.
    pub fn new(path: &Path) -> Result<Self, TaskError> {
        let failed = |error: std::io::Error| {
            TaskError::Asked(format!("{} can't be made: {error}", path.display()))
        };
        DirBuilder::new().mode(0o700).create(path).map_err(failed)?;
        let path = path.canonicalize().map_err(failed)?;
        for part in ["asked", "done"] {
            fs::create_dir(path.join(part)).map_err(failed)?;
        }
        Ok(Self { path })
    }

    /// The folder of this name, with its tasks.
    pub fn open(path: &Path) -> Result<(Self, Tasks), TaskError> {
        let found = path.canonicalize().map_err(|error| {
            TaskError::Asked(format!("{} can't be read: {error}", path.display()))
        })?;
        let folder = Self { path: found };
        let tasks = read(&folder.tasks())?;
        Ok((folder, tasks))
    }

    /// Place of the program.
    pub fn program(&self) -> PathBuf {
        self.path.join("strainsite")
    }

    /// Copies this program into the folder, and returns its path there.
    pub(crate) fn with_program(&self) -> Result<PathBuf, TaskError> {
        let program = self.program();
        let own = std::env::current_exe().map_err(|error| TaskError::Failed(error.to_string()))?;
        fs::copy(&own, &program).map_err(|error| unwritten(&program, &error))?;
        Ok(program)
    }

    /// Writes what the tasks are, when all else is there.
    pub fn write(&self, tasks: &Tasks) -> Result<(), TaskError> {
        write(&self.tasks(), tasks)
    }

    /// Returns the path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Makes a further folder in it, where that isn't there.
    pub fn part(&self, name: &str) -> Result<(), TaskError> {
        let part = self.path.join(name);
        fs::create_dir_all(&part).map_err(|error| unwritten(&part, &error))
    }

    /// A document of this name beside the tasks, where there is one.
    pub fn note<T: DeserializeOwned>(&self, name: &str) -> Result<Option<T>, TaskError> {
        let path = self.path.join(name);
        path.exists().then(|| read(&path)).transpose()
    }

    /// Writes a document of this name beside the tasks.
    pub(crate) fn write_note<T: Serialize>(
        &self,
        name: &str,
        document: &T,
    ) -> Result<(), TaskError> {
        write(&self.path.join(name), document)
    }

    fn tasks(&self) -> PathBuf {
        self.path.join("tasks.json")
    }

    /// The designs of a task.
    pub fn asked(&self, number: usize) -> PathBuf {
        self.path.join(format!("asked/{number}.db"))
    }

    /// Place of what comes of a task.
    pub fn done(&self, number: usize) -> PathBuf {
        self.path.join(format!("done/{number}.db"))
    }

    /// Puts what a task handed in aside, so that it begins anew when it is given once more; returns where it is kept.
    pub(crate) fn set_aside(&self, number: usize) -> Result<PathBuf, TaskError> {
        let aside = self.path.join(format!("done/{number}.refused.db"));
        let moved = fs::rename(self.done(number), &aside);
        moved.map_err(|error| unwritten(&aside, &error))?;
        Ok(aside)
    }

    /// Says why a task wasn't done.
    pub fn refuse(&self, number: usize, refusal: &Refusal) -> Result<(), TaskError> {
        write(&self.refused(number), refusal)
    }

    /// Takes that back, when the task was done after all.
    pub fn accept(&self, number: usize) {
        // Most tasks were never refused.
        let _ = fs::remove_file(self.refused(number));
    }

    /// Reason why a task wasn't done, where a node said so.
    pub fn refusal(&self, number: usize) -> Option<Refusal> {
        let path = self.refused(number);
        path.exists().then(|| read(&path).ok()).flatten()
    }

    fn refused(&self, number: usize) -> PathBuf {
        self.path.join(format!("done/{number}.refused.json"))
    }
}

/// Largest file that is read as text, bytes: tasks of a hundred thousand designs take 4 MB.
const MOST_BYTES: u64 = 64_000_000;

fn read<T: DeserializeOwned>(path: &Path) -> Result<T, TaskError> {
    let failed =
        |cause: String| TaskError::Asked(format!("{} can't be read: {cause}", path.display()));
    let bytes = fs::metadata(path)
        .map_err(|error| failed(error.to_string()))?
        .len();
    if bytes > MOST_BYTES {
        return Err(failed(format!("it has {bytes} bytes")));
    }
    let text = fs::read_to_string(path).map_err(|error| failed(error.to_string()))?;
    serde_json::from_str(&text).map_err(|error| failed(error.to_string()))
}

/// Writes a document that is whole at every moment.
fn write<T: Serialize>(path: &Path, document: &T) -> Result<(), TaskError> {
    let failed = |error: std::io::Error| unwritten(path, &error);
    let text = serde_json::to_string_pretty(document);
    let text = text.map_err(|error| TaskError::Failed(error.to_string()))?;
    let part = path.with_extension(format!("{}.unfinished", std::process::id()));
    fs::write(&part, text + "\n").map_err(failed)?;
    fs::rename(&part, path).map_err(failed)
}

fn unwritten(path: &Path, error: &std::io::Error) -> TaskError {
    TaskError::Failed(format!("{} can't be written: {error}", path.display()))
}
