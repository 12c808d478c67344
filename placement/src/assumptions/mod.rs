//! Assumptions that the figures of the layout that answers rest on, changed one at a time.
//!
//! - `changed`: the assumptions and their changed values, in words
//! - `changed_scenes`: scenes in which one is changed, and contacts as films feel them there
//! - `changed_films`: layouts with films of another model
//! - `changed_errors`: the layout's errors then, beside those of layouts that could answer in its place
//! - `measuring_assumptions`: solves, and fills in a study's result

mod changed;
mod changed_errors;
mod changed_films;
pub(crate) mod changed_scenes;
pub(crate) mod measuring_assumptions;
