//! `strainsite force`: forces from recorded signals.
//!
//! - `force_look`: what recordings' columns are taken for; `look_table`: the same, for people
//! - `force_fit`: validates every model on every split, learns the best
//! - `force_apply`: estimates of a recording, or of rows as they come
//! - `force_record`: recordings of a virtual rig on a study's tire
//! - `force_table`: what a fit found, for people; `force_beginnings`: what a begin under load does; `recording_files`: recordings from their files

mod force_apply;
mod force_beginnings;
mod force_fit;
mod force_look;
mod force_record;
mod force_table;
mod look_table;
mod recording_files;

use clap::{Args, Subcommand};

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::help_examples;
use crate::cli::terminal::output::JsonTarget;

/// Learn forces from recorded signals, and estimate them
#[derive(Debug, Args)]
pub struct Force {
    #[command(subcommand)]
    step: Step,
}

#[derive(Debug, Subcommand)]
enum Step {
    /// Say what each column of recordings is taken for and what stands in it, before anything is learnt
    #[command(after_help = help_examples::FORCE_LOOK)]
    Look(force_look::LookAt),
    /// Validate models on rows they didn't learn from, then learn the best from all rows
    #[command(after_help = help_examples::FORCE_FIT)]
    Fit(force_fit::Fit),
    /// Estimate the forces of a recording, with 95 % intervals
    #[command(after_help = help_examples::FORCE_APPLY)]
    Apply(force_apply::Apply),
    /// Let a virtual rig step on a study's tire, and write what the films of a layout record
    #[command(after_help = help_examples::FORCE_RECORD)]
    Record(force_record::Record),
}

impl Force {
    /// Runs the step.
    pub fn execute(&self) -> Result<(), Failure> {
        match &self.step {
            Step::Look(step) => step.execute(),
            Step::Fit(step) => step.execute(),
            Step::Apply(step) => step.execute(),
            Step::Record(step) => step.execute(),
        }
    }

    /// Returns the files that the step reads and writes.
    pub fn files(&self) -> Files {
        match &self.step {
            Step::Look(step) => step.files(),
            Step::Fit(step) => step.files(),
            Step::Apply(step) => step.files(),
            Step::Record(step) => step.files(),
        }
    }

    /// Returns where the step's JSON goes.
    pub fn json(&self) -> Option<JsonTarget> {
        match &self.step {
            Step::Look(step) => step.json.clone(),
            Step::Fit(step) => step.json.clone(),
            Step::Apply(_) | Step::Record(_) => None,
        }
    }
}
