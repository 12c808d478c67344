//! Layouts moved by hand: scored from what a finished study has stored, by what scores its own layouts. Nothing is solved.
//!
//! - [`stored_solves`]: stored points in a solver's place
//! - [`film_fields`]: what films read, as scores follow from it
//! - [`hand_layout_reader`]: reads them
//! - [`scored_by_hand`]: scores of any layouts of the study's kinds of film

pub mod film_fields;
pub mod hand_layout_reader;
pub mod scored_by_hand;
pub mod stored_solves;
