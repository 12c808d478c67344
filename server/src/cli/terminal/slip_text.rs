//! Values that the physics makes unlikely, for people.

use std::fmt::Display;

use super::paint::{WARNING, painted};
use super::wrapping::wrapped;

/// A paragraph for each of them.
pub(crate) fn slip_lines<S: Display>(slips: impl IntoIterator<Item = S>) -> String {
    let note = painted(WARNING, "note:");
    let line = |slip| wrapped(&format!("{note} unlikely value in {slip}"), 6);
    slips.into_iter().map(line).collect()
}
