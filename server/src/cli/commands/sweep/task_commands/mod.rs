//! `strainsite tasks`: designs of a sweep that other machines solve, by whatever starts programs on them.
//!
//! - `making`: has them written, `task_run`: does one, `tasks_gather`: takes in what was done

mod making;
mod task_run;
mod tasks_gather;

use clap::{Args, Subcommand};

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::help_examples;
use crate::cli::terminal::output::JsonTarget;

/// Have designs of a sweep solved by other machines
#[derive(Debug, Args)]
pub struct Tasks {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Write the designs that a sweep still lacks, or the points of a large study, into a folder, as tasks of some minutes each
    #[command(after_help = help_examples::TASKS_MAKE)]
    Make(making::Make),
    /// Do a task on this machine, and hand in what came of it
    #[command(after_help = help_examples::TASKS_RUN)]
    Run(task_run::Run),
    /// Take in what was handed in, once a point of each task gave the same bits here
    #[command(after_help = help_examples::TASKS_GATHER)]
    Gather(tasks_gather::Gather),
}

impl Tasks {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        match &self.task {
            Task::Make(make) => make.files(),
            Task::Run(_) => Files::default(),
            Task::Gather(gather) => gather.files(),
        }
    }

    /// Returns where a failure is told beside standard error.
    pub fn json(&self) -> Option<JsonTarget> {
        match &self.task {
            Task::Make(make) => make.json.clone(),
            Task::Run(_) => None,
            Task::Gather(gather) => gather.json.clone(),
        }
    }

    /// Does what is asked.
    pub fn execute(&self) -> Result<(), Failure> {
        match &self.task {
            Task::Make(make) => make.execute(),
            Task::Run(run) => run.execute(),
            Task::Gather(gather) => gather.execute(),
        }
    }
}
