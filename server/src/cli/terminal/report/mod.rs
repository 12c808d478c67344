//! Everything that `run` and `show` print of a result: the answer first, then tables, then what to know of them. No line is longer than
//! [`COLUMNS`](super::wrapping::COLUMNS).
//!
//! - `answer_text`: the answer, how sure it is, what could overturn it
//! - `ranked_table`, `layout_table`, `signal_table`: places, layouts, films' signals
//! - `forces_known`: what a virtual rig shows of layouts
//! - `published_forces`: the same beside the published tables
//! - `paper_table`: beside the published figures, where the study is the paper's
//! - `study_notes`: what to know, by what it does to the answer
//! - `study_figures`: the way to the accuracy asked for, and what it all took
//! - `shared_rank`: `2=`

mod answer_text;
mod forces_known;
mod layout_table;
mod paper_table;
mod published_forces;
mod ranked_table;
mod shared_rank;
mod signal_table;
mod study_figures;
mod study_notes;

use placement::result::StudyResult;

use crate::cli::terminal::estimate_text::comparison;

/// Everything that is printed of a result.
pub fn report(result: &StudyResult) -> String {
    [
        answer_text::answer,
        ranked_table::ranked,
        layout_table::layouts,
        paper_table::beside_the_paper,
        signal_table::signals,
        forces_known::forces,
        published_forces::published_forces,
        study_notes::notes,
        study_figures::climb,
        study_figures::cost,
        comparison,
    ]
    .map(|part| part(result))
    .concat()
}
