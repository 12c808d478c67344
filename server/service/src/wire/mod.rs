//! Documents on the wire beside results: states, estimates, previews, comparisons, indices of models of others; with an example of each.

pub mod analysis_wire;
pub mod described_tables;
pub mod entry_change;
pub mod estimator_examples;
pub mod estimator_wire;
pub mod examples;
pub mod layout_wire;
pub mod look_wire;
pub mod preview_wire;
pub mod scene_wire;
pub mod study_wire;
pub mod sweep_examples;
mod sweep_state;
pub mod sweep_wire;
