//! Surfaces of a body, in reading order:
//!
//! - [`stretch`]: stretches at a point, and the extremes in a body
//! - [`chart`]: stretches recovered where a film would sit
//! - [`surface_law`], [`membrane`]: fibre families and films embedded in the mesh

pub mod chart;
pub mod membrane;
pub mod stretch;
pub mod surface_law;
