//! Surfaces of a body, in reading order:
//!
//! - [`stretch`]: stretches at a point, and the extremes in a body
//! - [`chart`]: stretches recovered where a film would sit
//! - [`surface_law`], [`membrane`]: fibre families embedded in the mesh
//! - [`sheet`]: a thin film glued on, with displacements of its own

pub mod chart;
pub mod membrane;
pub mod sheet;
mod small_system;
pub mod stretch;
pub mod surface_law;
