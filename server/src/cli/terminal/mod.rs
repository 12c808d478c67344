//! Terminal: what is said, where, and how it looks.
//!
//! - [`exit`]: why a command fails, and its exit code
//! - `paint`, `shown`: painted text, and what of it a terminal may see
//! - `output`: text for people, plain where paint isn't wanted; documents
//! - `output_place`: files where users want them
//! - `figures`: columns of tables, as results describe them
//! - `files`: what a command reads and writes, looked at first
//! - `progress`: bars and clocks
//! - `signals`: Ctrl-C
//! - `wrapping`: text in lines that fit
//! - `report`: everything of a result; `estimate_text`: what a study costs; `slip_text`: what is unlikely in a document
//! - `help_examples`: the examples of `--help`

pub(crate) mod estimate_text;
pub mod exit;
pub(crate) mod figures;
pub(crate) mod files;
pub(crate) mod help_examples;
pub(crate) mod output;
pub(crate) mod output_place;
pub(crate) mod paint;
pub(crate) mod progress;
pub(crate) mod report;
pub(crate) mod shown;
pub(crate) mod signals;
pub(crate) mod slip_text;
pub(crate) mod wrapping;
