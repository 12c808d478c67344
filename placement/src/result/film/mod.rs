//! What films read, and what is known of forces by them.

pub mod film_place;
mod film_signals;
pub(crate) mod force_error;
mod force_findings;
mod published_tables;
pub mod signal_words;

pub use film_signals::{
    ClaimRow, FilmPair, SignalCurve, SignalError, SignalRow, Signals, StressWidth,
};
pub use force_error::{
    AskewError, DeadFilmError, ElsewhereError, ForceError, SplitError, TrialError, WorstContact,
};
pub use force_findings::{FilmAnglesReport, ForceFindings, ForcePrice, TableError, TableReport};
pub use published_tables::{
    Contradiction, PrintedFigures, PublishedRow, PublishedTables, RigFigures, TimeConstantRow,
};
