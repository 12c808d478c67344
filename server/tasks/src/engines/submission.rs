//! Submission of tasks to Slurm: the arrays that it was asked for, each written down before it is asked, so that a program killed at any moment finds them again by their names.

use serde::{Deserialize, Serialize};

use super::Work;
use crate::task_error::TaskError;
use crate::task_folder::TaskFolder;

/// File of the submission in the folder of the tasks.
const FILE: &str = "submitted.json";

/// Arrays of jobs, which take the tasks one after the other.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Submission {
    pub arrays: Vec<JobArray>,
}

/// Array of jobs, one for each of some tasks in a row.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct JobArray {
    /// Name of the jobs, which no others have.
    pub name: String,
    /// Number of its first task.
    pub first: usize,
    /// Tasks that it has.
    pub count: usize,
    /// Whether Slurm said that it has it.
    pub is_known: bool,
}

impl Submission {
    /// The submission of a folder's tasks, empty where there was none.
    pub fn of(folder: &TaskFolder) -> Result<Self, TaskError> {
        let found = folder.note(FILE)?;
        Ok(found.unwrap_or_default())
    }

    /// Writes it down.
    pub fn keep(&self, folder: &TaskFolder) -> Result<(), TaskError> {
        folder.write_note(FILE, self)
    }

    /// The next array, of so many tasks at most; none when all tasks are taken.
    pub fn next(&self, work: &Work<'_>, most: usize) -> Option<JobArray> {
        let first = self.arrays.last().map_or(1, |last| last.first + last.count);
        let left = (work.count + 1)
            .checked_sub(first)
            .filter(|left| *left > 0)?;
        Some(JobArray {
            name: format!("{}.{first}", work.name),
            first,
            count: left.min(most),
            is_known: false,
        })
    }

    /// Names of its arrays, as Slurm lists them.
    pub fn names(&self) -> String {
        let names: Vec<&str> = self
            .arrays
            .iter()
            .map(|array| array.name.as_str())
            .collect();
        names.join(",")
    }
}
