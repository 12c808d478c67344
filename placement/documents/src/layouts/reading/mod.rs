//! Reads the table `layouts` of a study, with every fault at once.
//!
//! - `layout_reader`: the table itself; `search_reader`, `limits_reader`, `contact_reader` and `assumption_reader`: tables in it
//! - `usual_contact`: whether a scene's contact is upright, on ground that isn't dragged
//! - `film_size_reader`: how large films are, and whether they fit; [`overlap_check`]: layouts whose films overlap

mod assumption_reader;
mod contact_reader;
pub(crate) mod film_size_reader;
pub(crate) mod layout_reader;
mod limits_reader;
pub mod overlap_check;
mod search_reader;
mod usual_contact;
