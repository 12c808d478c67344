//! Layouts of films, as a study asks for them.
//!
//! - [`layout_settings`]: what is asked
//! - [`film_rings`]: regular layouts, those of the menu among them
//! - [`film_extent`]: the rectangle that a film covers
//! - [`film_room`]: room between films; `overlap_check`: layouts whose films overlap
//! - `layout_reader`, `film_size_reader`, [`film_place_reader`], `search_reader`: read the table `layouts`, whose bounds are in [`layout_bounds`]; `layout_schema` describes it

pub mod film_extent;
pub mod film_place_reader;
pub mod film_rings;
pub mod film_room;
pub(crate) mod film_size_reader;
pub mod layout_bounds;
pub(crate) mod layout_reader;
pub(crate) mod layout_schema;
pub mod layout_settings;
pub(crate) mod overlap_check;
mod search_reader;
