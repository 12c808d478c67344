//! The command line.
//!
//! Data goes to standard output, talk to standard error. Exit codes: 0 done, 2 the input is wrong, 3 the physics has
//! no answer, 1 anything else.
//!
//! - [`terminal`]: what is said, where, and how it looks
//! - `settings`, `solver_option`: flags, environment and settings file
//! - `commands`: one file per command
//! - [`entry`]: chooses the command, and the exit code

mod commands;
mod engine_options;
pub mod entry;
mod settings;
mod solver_option;
pub mod terminal;
