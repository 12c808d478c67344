//! Layouts of films, as a study asks for them.
//!
//! - [`layout_settings`]: what is asked
//! - [`film_rings`]: regular layouts, those of the menu among them
//! - [`film_extent`]: the rectangle that a film covers
//! - [`film_room`]: room between films; `overlap_check`: layouts whose films overlap
//! - [`gluing_limits`]: where no film can be glued; [`ring_turns`]: rings that keep clear of that
//! - `layout_reader`, `film_size_reader`, [`film_place_reader`], `limits_reader`, `search_reader`: read the table `layouts`, whose bounds are in [`layout_bounds`]; `layout_schema` describes it

pub mod film_extent;
pub mod film_place_reader;
pub mod film_rings;
pub mod film_room;
pub(crate) mod film_size_reader;
pub mod gluing_limits;
pub mod layout_bounds;
pub(crate) mod layout_reader;
pub(crate) mod layout_schema;
pub mod layout_settings;
mod limits_reader;
pub mod overlap_check;
pub mod ring_turns;
mod search_reader;
