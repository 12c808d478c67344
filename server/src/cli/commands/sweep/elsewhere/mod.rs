//! `strainsite sweep --engine`: other machines solve the designs, as tasks, before what is left is solved here.
//!
//! - `engine`: what starts programs on other machines; `slurm` and `own_command` are such
//! - `submission`: what Slurm was asked for, kept beside the tasks
//! - `round`: one folder of tasks, from its making until nothing of it runs
//! - `rounds`: one after the other, until nothing is lacking

pub(crate) mod engine;
mod own_command;
mod round;
mod rounds;
mod slurm;
mod submission;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::cli::commands::sweep::tasks::packing::packed;
use crate::cli::terminal::exit::Failure;
use crate::config::minutes;
use engine::Engine;
use own_command::OwnCommand;
pub(super) use rounds::Rounds;
use slurm::Slurm;

/// Numbers of machines of which a dry run speaks.
const MACHINES: [usize; 4] = [1, 4, 16, 64];

/// Machines that solve designs, as the command line names them.
#[derive(Debug, Args)]
pub(super) struct Elsewhere {
    /// Have other machines solve the designs before what is left is solved here
    #[arg(long, value_enum, value_name = "NAME")]
    engine: Option<EngineName>,
    /// Options of sbatch, separated by spaces, as in "--partition=short --mem=2G"
    #[arg(
        long,
        env = "STRAINSITE_SLURM_OPTIONS",
        value_name = "OPTIONS",
        allow_hyphen_values = true
    )]
    slurm_options: Option<String>,
    /// Command of --engine command, for a shell: it does every task of "$TASKS" by "$PROGRAM" tasks run "$FOLDER" N, anywhere, and ends when all have
    #[arg(long, env = "STRAINSITE_ENGINE_COMMAND", value_name = "COMMAND")]
    engine_command: Option<String>,
    /// Folder in which the tasks are kept meanwhile, and which all machines see; beside the database when absent
    #[arg(long, env = "STRAINSITE_TASKS", value_name = "FOLDER")]
    tasks: Option<PathBuf>,
    /// Time that a task should take on this machine's threads, minutes
    #[arg(long, value_name = "N", default_value = "10", value_parser = minutes)]
    minutes: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum EngineName {
    /// Job arrays of a Slurm cluster
    Slurm,
    /// The command of --engine-command
    Command,
}

impl Elsewhere {
    /// Whether other machines are to solve anything.
    pub(super) fn is_asked(&self) -> bool {
        self.engine.is_some()
    }

    /// The engine that is asked for.
    pub(super) fn engine(&self) -> Result<Option<Box<dyn Engine>>, Failure> {
        let Some(name) = self.engine else {
            return Ok(None);
        };
        let engine: Box<dyn Engine> = match (name, &self.engine_command) {
            (EngineName::Slurm, _) => Box::new(Slurm::new(
                self.slurm_options.as_deref().unwrap_or_default(),
            )),
            (EngineName::Command, Some(command)) => Box::new(OwnCommand::new(command)),
            (EngineName::Command, None) => {
                return Err(Failure::input(
                    "--engine command needs --engine-command, as in 'parallel -S node1,node2 \"$PROGRAM\" tasks run \"$FOLDER\" ::: $TASKS'",
                ));
            }
        };
        Ok(Some(engine))
    }

    /// A line about the tasks of designs that take so long each on this machine, s, one after the other, and about machines like this one; none where no engine is asked for.
    pub(super) fn foreseen(&self, designs_s: &[f64]) -> String {
        if !self.is_asked() {
            return String::new();
        }
        let alone = (0..designs_s.len()).map(|design| vec![design]).collect();
        let tasks = packed(alone, |design| designs_s[design], 60.0 * self.minutes);
        let tasks_s: Vec<f64> = tasks
            .iter()
            .map(|task| task.iter().map(|&design| designs_s[design]).sum())
            .collect();
        let longest_s = tasks_s.iter().copied().fold(0.0, f64::max);
        let all_s: f64 = tasks_s.iter().sum();
        // No machine is done before a task of it is, nor all of them before the work is.
        let by_machines = MACHINES.map(|count| {
            let time_s = (all_s / count as f64).max(longest_s);
            format!("{count}: {time_s:.0} s")
        });
        format!(
            "tasks for other machines: {}, the longest {longest_s:.0} s; on so many like this one they take {}, and what they wait for\n",
            tasks_s.len(),
            by_machines.join(", ")
        )
    }

    /// Time that a task should take, minutes.
    pub(super) fn minutes(&self) -> f64 {
        self.minutes
    }

    /// Folder of a sweep's rounds.
    pub(super) fn folder(&self, database: &Path, sweep: &str) -> PathBuf {
        let tasks = self.tasks.clone();
        tasks.unwrap_or_else(|| beside(database)).join(sweep)
    }

    /// Removes the folder beside the database when nothing is left in it; one that the user named stays.
    pub(super) fn tidy(&self, database: &Path) {
        // What holds rounds isn't empty.
        let _ = std::fs::remove_dir(beside(database));
    }
}

/// Folder of all tasks of a database, where the user names none.
fn beside(database: &Path) -> PathBuf {
    let mut name = database.as_os_str().to_owned();
    name.push(".tasks");
    PathBuf::from(name)
}
