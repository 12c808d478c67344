//! Answer in a sentence, from ranked locations and layouts: what the program, the exports and the dashboard tell alike.
//!
//! - `figure_words`: figures with their errors, as they stand in sentences
//! - `first_rank`: how sure a first rank is
//! - `best_place`: the first rank of places, its verdict and reason
//! - `trade`: the best layout of each number of films, the one that answers, and its verdict
//! - `inputs_that_matter`: the shares of all inputs in the strain; `inputs_beside`: in volts and in a layout's error
//! - `strongest_film`: the film that gives most, in volts
//! - `gluing_sheet`: its films, one by one
//! - `layout_figures`: errors of layouts with their claims
//! - `layout_words`: what a layout is, in words
//! - `brief_words`: the answer in few characters, for lists
//! - `assumption_words`: what its figures rest on
//! - `left_out_words`: what is left out, as a sentence
//! - `whole_answer`: all of it together

mod assumption_words;
mod best_place;
mod brief_words;
mod figure_words;
mod first_rank;
mod gluing_sheet;
mod inputs_beside;
mod inputs_that_matter;
mod layout_figures;
mod layout_words;
mod left_out_words;
mod strongest_film;
mod trade;
mod whole_answer;

pub(crate) use first_rank::{Standing, judge};
pub(crate) use layout_figures::{Figure, Figures};
pub(crate) use left_out_words::effect_notes;
pub(crate) use whole_answer::{answer_of, contenders};
