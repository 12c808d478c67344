//! Answer in a sentence, from ranked locations and layouts: what the program, the exports and the dashboard tell alike.
//!
//! - `figure_words`: figures with their errors, as they stand in sentences
//! - `first_rank`: how sure a first rank is
//! - `best_place`: the first rank of places, its verdict and reason
//! - `film_trade`: the best layout of each number of films, and which of them answers; `trade_words`: the same in words
//! - `picked_layout`: the layout that answers; `rivals`: its verdict against the others, and the reason
//! - `inputs_that_matter`: the shares of all inputs
//! - `strongest_film`: the film that gives most, in volts
//! - `gluing_sheet`: its films, one by one
//! - `layout_figures`: errors of layouts with their claims
//! - `layout_words`: what a layout is, in words
//! - `left_out_words`: what is left out, as a sentence
//! - `whole_answer`: all of it together

mod best_place;
mod figure_words;
mod film_trade;
mod first_rank;
mod gluing_sheet;
mod inputs_that_matter;
mod layout_figures;
mod layout_words;
mod left_out_words;
mod picked_layout;
mod rivals;
mod strongest_film;
mod trade_words;
mod whole_answer;

pub(crate) use figure_words::with_error;
pub(crate) use first_rank::{Standing, judge};
pub(crate) use left_out_words::effect_notes;
pub(crate) use whole_answer::answer_of;
