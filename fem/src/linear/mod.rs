//! The linear system of one Newton step, in reading order:
//!
//! - `coupled`, `ordering`, [`sparsity`]: which unknowns are coupled, equation numbers in elimination order, and the pattern of the tangent
//! - `substitution`, `rounding`, [`symbolic`], [`factor`]: the sparse factor and what is solved with it
//! - [`setup`]: what all states of a problem share
//! - [`system`], `face_buffers`, [`assembly`], `condensed_pressures`: residual and tangent of the whole problem

pub mod assembly;
mod condensed_pressures;
mod coupled;
mod face_buffers;
pub mod factor;
pub(crate) mod ordering;
mod rounding;
pub mod setup;
pub mod sparsity;
pub(crate) mod substitution;
pub mod symbolic;
pub mod system;
