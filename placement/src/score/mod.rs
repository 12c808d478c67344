//! From responses to a result, in reading order:
//!
//! - [`indices`]: responses to indices of every output
//! - [`rank`]: indices to ranked locations
//! - `notes`: what the user must know before believing the numbers
//! - [`assemble`]: all of it into the answer

pub mod assemble;
pub mod indices;
pub(crate) mod notes;
pub mod rank;
