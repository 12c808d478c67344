//! Solved points.
//!
//! - [`evaluations`]: solved points and start states
//! - [`study_points`]: which of them answer for the points of a study
//! - `strain_fields`: their long lists of strains
//! - [`crashes`]: solves that the program died in, and those that crash by themselves
//! - [`model_runs`]: runs of models that other programs serve

pub mod crashes;
pub mod evaluations;
pub mod model_runs;
pub(crate) mod strain_fields;
pub mod study_points;
