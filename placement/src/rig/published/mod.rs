//! The published study's tables of force errors, and a rig that runs under the same conditions.
//!
//! - [`printed_figures`]: what was printed
//! - [`contradictions`]: which of it can't be true beside the rest
//! - [`published_gaits`]: the conditions, and what is assumed of them
//! - [`published_rows`]: the rows as printed, checked
//! - [`rig_tables`]: the rig's figures for each row

pub mod contradictions;
pub mod printed_figures;
pub mod published_gaits;
pub mod published_rows;
pub mod rig_tables;
