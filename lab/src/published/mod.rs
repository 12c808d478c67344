//! The published study's tables of force errors (Sensors 2025, 25, 4026), and a virtual rig that runs under the same conditions.
//!
//! - [`printed_figures`]: what was printed
//! - `contradictions`: which of it can't be true beside the rest
//! - [`published_gaits`]: the conditions, and what is assumed of them
//! - [`published_rows`]: the rows as printed, checked
//! - [`tested_forces`]: a model of one force, and how far off it is
//! - [`rig_tables`]: the rig's figures for each row

pub(crate) mod contradictions;
#[cfg(test)]
pub(crate) mod pressed_wheel;
pub mod printed_figures;
pub mod published_gaits;
pub mod published_rows;
pub mod rig_tables;
pub mod tested_forces;
