//! Names of engines, and their settings.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::Engine;
use super::own_command::OwnCommand;
use super::slurm::Slurm;
use crate::task_error::TaskError;

/// Name of an engine.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, ValueEnum, Serialize, Deserialize, ToSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum EngineName {
    /// Job arrays of a Slurm cluster
    Slurm,
    /// The command of --engine-command
    Command,
}

impl EngineName {
    /// The name as it is written.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Slurm => "slurm",
            Self::Command => "command",
        }
    }
}

/// Settings of the engines.
#[derive(Debug, Clone, Default)]
pub struct EngineSettings {
    /// Options of sbatch, separated by spaces.
    pub slurm_options: String,
    /// Command of [`EngineName::Command`], for a shell.
    pub command: Option<String>,
}

impl EngineSettings {
    /// The engine of a name.
    ///
    /// # Errors
    /// [`TaskError::Asked`] when it isn't set.
    pub fn engine(&self, name: EngineName) -> Result<Box<dyn Engine>, TaskError> {
        Ok(match (name, &self.command) {
            (EngineName::Slurm, _) => Box::new(Slurm::new(&self.slurm_options)),
            (EngineName::Command, Some(command)) => Box::new(OwnCommand::new(command)),
            (EngineName::Command, None) => {
                return Err(TaskError::Asked(
                    "--engine command needs --engine-command, as in 'parallel -S node1,node2 \"$PROGRAM\" tasks run \"$FOLDER\" ::: $TASKS'".to_owned(),
                ));
            }
        })
    }
}
