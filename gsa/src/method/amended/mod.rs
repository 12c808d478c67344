//! Amendments of an analysis, whichever method made it:
//!
//! - `mirrored`: one analysis of two mirror images
//! - `failed_runs`: what the output may do where runs gave no number
//! - `outermost`: how far beyond all others they lie
//! - `printed`: what values of few digits leave open

mod failed_runs;
mod mirrored;
mod outermost;
mod printed;
