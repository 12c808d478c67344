//! A round: what a sweep lacks, as tasks in a folder of its own, from its making until nothing of it runs.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use crate::engines::Work;
use crate::task_error::TaskError;
use crate::task_folder::{TaskFolder, Tasks};

/// File that says that a round's tasks were taken in, and that nothing of it runs.
const OVER: &str = "over.json";

/// A round of tasks.
pub(super) struct Round {
    pub folder: TaskFolder,
    pub tasks: Tasks,
    /// Name of its jobs.
    name: String,
    /// Size and time of what was handed in and looked at.
    seen: BTreeMap<usize, (u64, SystemTime)>,
}

impl Round {
    /// A round whose tasks lie in a folder.
    pub fn new(folder: TaskFolder, tasks: Tasks, number: usize) -> Self {
        Self {
            name: format!("strainsite-{}-{number}", tasks.sweep),
            folder,
            tasks,
            seen: BTreeMap::new(),
        }
    }

    /// The round that isn't over, where there is one, and how many there were in all.
    pub fn last(sweep: &Path) -> Result<(Option<Self>, usize), TaskError> {
        let mut count = 0;
        while place(sweep, count + 1).exists() {
            count += 1;
        }
        if count == 0 {
            return Ok((None, 0));
        }
        let (folder, tasks) = TaskFolder::open(&place(sweep, count))?;
        let is_over = folder.note::<bool>(OVER)?.is_some();
        let round = Self::new(folder, tasks, count);
        Ok(((!is_over).then_some(round), count))
    }

    /// Tasks for an engine.
    pub fn work(&self) -> Work<'_> {
        Work {
            folder: &self.folder,
            name: &self.name,
            count: self.tasks.tasks.len(),
        }
    }

    /// Designs of its tasks.
    pub fn designs(&self) -> usize {
        self.tasks.tasks.iter().map(|task| task.studies.len()).sum()
    }

    /// Numbers of the tasks that handed something in since the last time.
    pub(super) fn handed_in(&mut self) -> Vec<usize> {
        let mut new = Vec::new();
        for number in 1..=self.tasks.tasks.len() {
            let file = fs::metadata(self.folder.done(number)).ok();
            let state = file.and_then(|file| Some((file.len(), file.modified().ok()?)));
            if let Some(state) = state
                && self.seen.insert(number, state) != Some(state)
            {
                new.push(number);
            }
        }
        new
    }

    /// Notes that nothing of it runs and all of it was taken in.
    pub fn close(&self) -> Result<(), TaskError> {
        self.folder.write_note(OVER, &true)
    }
}

/// Folder of a round.
pub(super) fn place(sweep: &Path, number: usize) -> PathBuf {
    sweep.join(number.to_string())
}
