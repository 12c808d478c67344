//! What is said, where, and how it looks.
//!
//! - [`exit`]: why a command fails, and its exit code
//! - `paint`, `output`: painted text, plain where paint isn't wanted; documents
//! - `output_place`: files where users want them
//! - `files`: what a command reads and writes, looked at first
//! - `progress`: bars and clocks
//! - `signals`: Ctrl-C
//! - `estimate_text`, `ranked_table`, `layout_table`, `signal_table`: figures as tables
//! - `help_examples`: the examples of `--help`

pub(crate) mod estimate_text;
pub mod exit;
pub(crate) mod files;
pub(crate) mod help_examples;
pub(crate) mod layout_table;
pub(crate) mod output;
pub(crate) mod output_place;
pub(crate) mod paint;
pub(crate) mod progress;
pub(crate) mod ranked_table;
pub(crate) mod signal_table;
pub(crate) mod signals;
