//! `strainsite gsa`: sensitivity analysis of a model that others run.
//!
//! - [`gsa_plan`]: prints the points to run; with the values so far those that are still to be run, which an adaptive method asks for
//! - [`gsa_analyse`]: reads their outputs back
//! - [`gsa_run`]: both in one, with a model that a server runs
//! - `run_outputs`: names and values of its outputs
//! - `own_values`: inputs and values as files have them
//! - `told_indices`: the indices, told

mod gsa_analyse;
mod gsa_plan;
mod gsa_run;
mod own_values;
mod run_outputs;
mod told_indices;

use clap::{Args, Subcommand};

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::help_examples;
use crate::cli::terminal::output::JsonTarget;

/// Analyse a model of your own: print the points to run, then read their outputs back; or have a server run them
#[derive(Debug, Args)]
pub struct Gsa {
    #[command(subcommand)]
    step: Step,
}

#[derive(Debug, Subcommand)]
enum Step {
    /// Print the points to run, one row each
    #[command(after_help = help_examples::GSA_PLAN)]
    Plan(gsa_plan::Plan),
    /// Turn the outputs at the points into sensitivity indices
    #[command(after_help = help_examples::GSA_ANALYSE)]
    Analyse(gsa_analyse::Analyse),
    /// Plan, run a model that a server has by UM-Bridge's protocol, and analyse; given again it goes on where it was
    #[command(after_help = help_examples::GSA_RUN)]
    Run(gsa_run::Run),
}

impl Gsa {
    /// Runs the step.
    pub fn execute(&self) -> Result<(), Failure> {
        match &self.step {
            Step::Plan(step) => step.execute(),
            Step::Analyse(step) => step.execute(),
            Step::Run(step) => step.execute(),
        }
    }

    /// Returns the files that the step reads and writes.
    pub fn files(&self) -> Files {
        match &self.step {
            Step::Plan(step) => step.files(),
            Step::Analyse(step) => step.files(),
            Step::Run(step) => step.files(),
        }
    }

    /// Returns where the step's JSON goes.
    pub fn json(&self) -> Option<JsonTarget> {
        match &self.step {
            Step::Plan(_) => None,
            Step::Analyse(step) => step.json.clone(),
            Step::Run(step) => step.json.clone(),
        }
    }
}
