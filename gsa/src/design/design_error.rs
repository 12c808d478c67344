//! Errors of designs.

use thiserror::Error;

use crate::law::rule::RuleError;

/// Most check points a design takes; far beyond what an error estimate gains from, and well within memory.
pub const MAX_CHECK_POINTS: usize = 100_000;

/// Reason why a design cannot be built. Fields count inputs from 0, messages from 1.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DesignError {
    /// A design without inputs.
    #[error("a design needs at least one input")]
    NoInputs,
    /// An input's Gauss rule does not exist.
    #[error("input {}: {source}", input + 1)]
    Rule {
        /// number of the input
        input: usize,
        /// error of its rule
        source: RuleError,
    },
    /// The cut point has another number of coordinates than there are inputs.
    #[error("the cut point has {found} coordinates for {inputs} inputs")]
    CutLength {
        /// number of inputs
        inputs: usize,
        /// coordinates given
        found: usize,
    },
    /// A coordinate of the cut point is NaN or infinite.
    #[error("coordinate {} of the cut point must be finite, not {value}", input + 1)]
    CutNotFinite {
        /// number of the input
        input: usize,
        /// value that was given
        value: f64,
    },
    /// More check points than [`MAX_CHECK_POINTS`].
    #[error("{asked} check points are more than the {MAX_CHECK_POINTS} a design takes")]
    TooManyCheckPoints {
        /// check points asked for
        asked: usize,
    },
}
