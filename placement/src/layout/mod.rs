//! Layouts: what is solved for them, and their scores.
//!
//! - [`solving`]: what is solved for layouts, on a mesh that is fine as far as films see
//! - [`by_hand`]: layouts that somebody moves, from what is stored

pub mod by_hand;
pub mod solving;
