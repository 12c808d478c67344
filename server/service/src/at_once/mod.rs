//! Answers at once, beside the queue and stored nowhere.
//!
//! - [`previewer`]: places of a document, for somebody who writes it
//! - [`scene_solver`]: one equilibrium of a scene

pub mod previewer;
pub mod scene_solver;
