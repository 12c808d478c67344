//! Layouts of films, as a study asks for them.
//!
//! - [`layout_settings`]: what is asked
//! - [`film_rings`]: regular layouts, those of the menu among them
//! - [`film_extent`]: the rectangle that a film covers
//! - [`film_room`]: room between films
//! - [`gluing_limits`]: where no film can be glued; [`ring_turns`]: rings that keep clear of that
//! - [`contact_laws`]: what a contact is beside its angle and depth; [`assumptions`]: what figures rest on, changed
//! - [`reading`], [`film_place_reader`]: read the table `layouts`, whose bounds are in [`layout_bounds`]; `layout_schema` describes it

pub mod assumptions;
pub mod contact_laws;
pub mod film_extent;
pub mod film_place_reader;
pub mod film_rings;
pub mod film_room;
pub mod gluing_limits;
pub mod layout_bounds;
pub(crate) mod layout_schema;
pub mod layout_settings;
pub mod reading;
pub mod ring_turns;
