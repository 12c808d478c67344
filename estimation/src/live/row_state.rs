//! States of rows in a stream.

/// State of a row in a stream: whether it is estimated from, and why not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum RowState {
    /// Row with nothing wrong.
    Ok,
    /// Row whose signals are the zero from here on.
    Zero,
    /// Row whose signals are the zero from here on, though a force acts by the zero of the model.
    Loaded,
    /// First row after a pause: features begin anew.
    Gap,
    /// Row at another rate than that which was learnt from.
    Rate,
    /// The clock was set back: features begin anew.
    ClockReset,
    /// Row with the time of the one before.
    Duplicate,
    /// Row that is earlier than the one before.
    Late,
    /// Row so soon after the one before that a slope between them would mean nothing.
    Early,
    /// A cell that is needed has no number.
    NotANumber,
    /// Row of more or fewer cells than the header.
    Cut,
    /// Header, once more.
    Header,
    /// Row without a finite estimate: features begin anew.
    TooLarge,
}

impl RowState {
    /// The name in answers.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Zero => "zero",
            Self::Loaded => "loaded",
            Self::Gap => "gap",
            Self::Rate => "rate",
            Self::ClockReset => "clock-reset",
            Self::Duplicate => "duplicate",
            Self::Late => "late",
            Self::Early => "early",
            Self::NotANumber => "not-a-number",
            Self::Cut => "cut",
            Self::Header => "header",
            Self::TooLarge => "too-large",
        }
    }

    /// Whether such a row is estimated from.
    pub fn is_estimated(self) -> bool {
        matches!(
            self,
            Self::Ok | Self::Zero | Self::Loaded | Self::Gap | Self::Rate | Self::ClockReset
        )
    }
}
