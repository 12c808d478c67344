//! Films: what they read, and what is known of forces by them.

mod film_signals;
pub mod force_error;
mod force_findings;
mod signal_words;

pub use film_signals::{
    ClaimRow, FilmPair, SignalCurve, SignalError, SignalRow, Signals, StressWidth,
};
pub use force_error::{
    AlikeError, AskewError, DeadFilmError, DriftError, ElsewhereError, ForceError, SplitError,
    TrialError, WorstContact,
};
pub use force_findings::{FilmAnglesReport, ForceFindings, ForcePrice, TableError, TableReport};
pub use signal_words::{Claim, Holds, SignalAxis, Trend};
