//! Studies as their users have them: read, run, failed, answered.

// Clippy takes functions outside of tests for production code.
#![allow(clippy::unwrap_used)]

mod accuracy;
mod answers;
mod assumptions;
mod directions;
mod documents;
mod failing;
mod forces;
mod fuzzed;
mod glued;
mod paper_choice;
mod points;
mod running;
mod signals;
mod support;
