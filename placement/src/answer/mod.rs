//! Answer in a sentence, from ranked locations and layouts: what the program, the exports and the dashboard tell alike.
//!
//! - `figure_words`: figures with their errors, as they stand in sentences
//! - `first_rank`: how sure a first rank is
//! - `best_place`, `best_layout`: the first ranks, their verdicts and reasons
//! - `inputs_that_matter`: the shares of all inputs
//! - `layout_words`: what a layout is, in words
//! - `left_out_words`: what is left out, as a sentence
//! - `whole_answer`: all of it together

mod best_layout;
mod best_place;
mod figure_words;
mod first_rank;
mod inputs_that_matter;
mod layout_words;
mod left_out_words;
mod whole_answer;

pub(crate) use left_out_words::effect_notes;
pub(crate) use whole_answer::answer_of;
