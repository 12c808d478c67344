//! Report of a result, as `run` and `show` print it: the answer first, then tables, then what to know of them. No line is longer than
//! [`COLUMNS`](super::wrapping::COLUMNS).
//!
//! - `answer_text`: the answer, how sure it is, what could overturn it
//! - `film_table`: films against errors
//! - `ranked_table`, `layout_table`, `signal_table`: places, layouts, films' signals
//! - `contact_table`: what contacts as they come do to the best layout
//! - `glued_films`: how far glued films' signals are off
//! - `forces_known`: what a virtual rig shows of layouts
//! - `study_notes`: what to know, by what it does to the answer
//! - `study_figures`: the way to the accuracy asked for, and what it all took
//! - `next_steps`: commands that may come next
//! - `shared_rank`: `2=`

mod answer_text;
mod contact_table;
mod film_table;
mod forces_known;
mod glued_films;
mod layout_table;
pub(crate) mod next_steps;
mod ranked_table;
mod shared_rank;
mod signal_table;
mod study_figures;
mod study_notes;

use results::StudyResult;

use crate::cli::terminal::estimate_text::comparison;

/// Returns all that is printed of a result.
pub fn report(result: &StudyResult) -> String {
    [
        answer_text::answer,
        film_table::trade,
        ranked_table::ranked,
        layout_table::layouts,
        contact_table::contacts,
        signal_table::signals,
        forces_known::forces,
        study_notes::notes,
        study_figures::climb,
        study_figures::cost,
        comparison,
    ]
    .map(|part| part(result))
    .concat()
}
