//! How far an index may be off, and what follows from that:
//!
//! - [`index_error`]: the parts of an index's error
//! - [`misses`]: what a form misses at check points, and the error of a difference
//! - [`certainty`]: whether a place in a ranking is certain

pub mod certainty;
pub mod index_error;
pub mod misses;
