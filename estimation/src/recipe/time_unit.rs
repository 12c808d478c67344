//! Unit of a column of time.

use document::Choice;

/// Unit of the numbers in a column of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum TimeUnit {
    /// Seconds.
    S,
    /// Milliseconds.
    Ms,
    /// Microseconds.
    Us,
    /// Nanoseconds.
    Ns,
    /// Minutes.
    Min,
}

impl TimeUnit {
    /// Seconds of a number. Divided, so that 50 ms are the number that 0.05 s is.
    pub fn seconds(self, number: f64) -> f64 {
        match self {
            Self::S => number,
            Self::Ms => number / 1e3,
            Self::Us => number / 1e6,
            Self::Ns => number / 1e9,
            Self::Min => number * 60.0,
        }
    }

    /// Name for people.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::S => "seconds",
            Self::Ms => "milliseconds",
            Self::Us => "microseconds",
            Self::Ns => "nanoseconds",
            Self::Min => "minutes",
        }
    }
}
