//! Global sensitivity analysis for expensive models.

// Private modules in reading order; each imports only those above it.
mod recurrence;

mod golub_welsch;

pub mod rule;

pub mod distribution;

mod grid;

pub mod design;
