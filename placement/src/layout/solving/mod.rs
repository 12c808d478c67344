//! Solves for layouts, and what becomes of them:
//!
//! - `study_layouts`: layouts, kinds of film and places of the search, as a study asks for them
//! - [`layout_scenes`]: a flat ground at every load
//! - [`layout_fields`]: solved loads as fields; `glued`: what glued films make of the bare wall's strains, and beside the contact
//! - [`shear_fields`]: what a shift of the ground changes; [`mirror_parts`]: a field's parts that are even or odd in it
//! - `contact_scenes`: contacts as they come; `contact_fields`: the response surface that they make
//! - `searched_layouts`: the best layouts of so many films
//! - `judged_layouts`: fields of two meshes to ranked layouts, on all threads
//! - `input_shifts`: what the study's inputs do to the signals, and so to the angle
//! - `menu_words`: what was tried, in words
//! - `measuring_layouts`: solves and fills in a study's result
//! - `layout_workload`: what all that takes

pub(crate) mod contact_fields;
pub(crate) mod contact_scenes;
pub(crate) mod glued;
mod input_shifts;
pub(crate) mod judged_layouts;
pub mod layout_fields;
pub mod layout_scenes;
pub(crate) mod layout_workload;
pub(crate) mod measuring_layouts;
mod menu_words;
pub mod mirror_parts;
pub(crate) mod searched_layouts;
pub mod shear_fields;
pub(crate) mod study_layouts;
