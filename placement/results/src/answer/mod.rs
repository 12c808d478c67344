//! The answer in a sentence with its verdict, and what the reader must know beside it, graded.

mod assumption_findings;
mod certainty_word;
mod film_sheet;
mod graded_note;
mod study_answer;
mod trade_answer;

pub use assumption_findings::{AssumptionChange, AssumptionFindings, RestsOn};
pub use certainty_word::Certainty;
pub use film_sheet::SheetFilm;
pub use graded_note::{Grade, GradedNote, Topic};
pub use study_answer::{
    Answer, InputShare, InputsAnswer, InputsBeside, LayoutAnswer, LeftOut, PlaceAnswer,
    SignalsAnswer, Surer,
};
pub use trade_answer::{TradeAnswer, TradeRow};
