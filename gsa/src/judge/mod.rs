//! Errors of an index, and what follows from them:
//!
//! - [`index_error`]: the parts of an index's error
//! - [`misses`]: what a form misses at check points, and the error of a difference
//! - `failed_share`, `printed_digits`: what failed runs and printed digits leave open
//! - [`certainty`]: whether a place in a ranking is certain

pub mod certainty;
pub(crate) mod failed_share;
pub mod index_error;
pub mod misses;
pub(crate) mod printed_digits;
