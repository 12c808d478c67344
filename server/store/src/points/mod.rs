//! Solved points.
//!
//! - [`evaluations`]: solved points and start states
//! - `strain_fields`: their long lists of strains
//! - [`crashes`]: solves that the program died of

pub mod crashes;
pub mod evaluations;
pub(crate) mod strain_fields;
