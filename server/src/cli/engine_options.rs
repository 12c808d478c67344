//! Options of engines: of `sweep`, and of the service.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::config::minutes;
use tasks::engines::engine_name::EngineSettings;
use tasks::task_folder::Kept;

/// Options of engines.
#[derive(Debug, Clone, Args)]
pub(crate) struct EngineOptions {
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
    pub minutes: f64,
    /// Part that is kept of what tasks hand in
    #[arg(
        long,
        env = "STRAINSITE_KEEP",
        value_enum,
        value_name = "PART",
        default_value = "everything"
    )]
    pub keep: Kept,
}

impl EngineOptions {
    /// Settings of the engines.
    pub fn settings(&self) -> EngineSettings {
        EngineSettings {
            slurm_options: self.slurm_options.clone().unwrap_or_default(),
            command: self.engine_command.clone(),
        }
    }

    /// Folder of all tasks of a database.
    pub fn folder(&self, database: &Path) -> PathBuf {
        self.tasks.clone().unwrap_or_else(|| beside(database))
    }

    /// Whether that folder is nobody else's.
    pub fn is_own(&self) -> bool {
        self.tasks.is_none()
    }

    /// Removes the folder beside the database when nothing is left in it; one that the user named stays.
    pub(crate) fn tidy(&self, database: &Path) {
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
