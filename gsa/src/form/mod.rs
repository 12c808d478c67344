//! Surrogates of an output on its lines, in reading order:
//!
//! - `scale`, `spectrum`, `refinement`, `section`: one line and how well it is known
//! - `mdrm`, `shift`, `additive`: product, shifted product and sum
//! - `evidence`: which of them the check points support
//! - `composite`: a form with corrections, whose coefficients give the indices
//! - `factors`, `regression`, `dictionary`, `whole_grid`, `corrected`: corrections at check points, sparse or on the whole grid

pub(crate) mod additive;
pub(crate) mod composite;
pub(crate) mod corrected;
pub(crate) mod dictionary;
pub(crate) mod evidence;
pub(crate) mod factors;
pub(crate) mod mdrm;
pub(crate) mod refinement;
pub(crate) mod regression;
pub(crate) mod scale;
pub(crate) mod section;
pub(crate) mod shift;
pub(crate) mod spectrum;
pub(crate) mod whole_grid;
