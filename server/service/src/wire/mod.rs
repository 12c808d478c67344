//! What goes over the wire beside results: documents, states, estimates, comparisons; with an example of each.

pub mod examples;
pub mod study_wire;
pub mod sweep_examples;
mod sweep_state;
pub mod sweep_wire;
