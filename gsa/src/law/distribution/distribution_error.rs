//! Errors of laws' parameters.

use thiserror::Error;

/// Shapes that gamma, Weibull and beta laws take: at the least, one draw in two is below 1e-300000; at the largest, the
/// law's relative spread is 1e-6 (gamma) or 1e-12 (Weibull).
const LEAST_SHAPE: f64 = 1e-6;
const LARGEST_SHAPE: f64 = 1e12;

/// Reason why a law cannot be built.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DistributionError {
    /// A parameter is NaN or infinite.
    #[error("{parameter} must be a finite number, not {value}")]
    NotFinite {
        /// name as in [`Distribution::parameters`](super::Distribution::parameters)
        parameter: &'static str,
        /// value that was given
        value: f64,
    },
    /// A scale, rate or shape is zero or negative.
    #[error("{parameter} must be greater than zero, not {value}")]
    NotPositive {
        /// name as in [`Distribution::parameters`](super::Distribution::parameters)
        parameter: &'static str,
        /// value that was given
        value: f64,
    },
    /// A shape so small or large that the law is a point, or two, in double precision.
    #[error("{parameter} must lie between {LEAST_SHAPE:e} and {LARGEST_SHAPE:e}, not at {value}")]
    ShapeOutOfRange {
        /// name as in [`Distribution::parameters`](super::Distribution::parameters)
        parameter: &'static str,
        /// value that was given
        value: f64,
    },
    /// The bounds of a range are equal or swapped.
    #[error("min must be less than max, not {min} and {max}")]
    EmptyRange {
        /// lower bound given
        min: f64,
        /// upper bound given
        max: f64,
    },
    /// The peak of a triangular law is not between its ends.
    #[error("mode must lie between min and max, that is between {min} and {max}, not at {mode}")]
    ModeOutside {
        /// lower bound given
        min: f64,
        /// peak given
        mode: f64,
        /// upper bound given
        max: f64,
    },
    /// The bounds of a truncation are equal or swapped.
    #[error("the lower bound of truncate must be less than the upper one, not {low} and {high}")]
    EmptyTruncation {
        /// lower bound given
        low: f64,
        /// upper bound given
        high: f64,
    },
    /// A truncation keeps nothing of the law.
    #[error(
        "truncate keeps nothing of the law: from {low} to {high} it has no density in double precision"
    )]
    NothingLeft {
        /// lower bound given
        low: f64,
        /// upper bound given
        high: f64,
    },
    /// The law is truncated already.
    #[error("a law is truncated once")]
    TruncatedTwice,
    /// Mean or standard deviation over- or underflow.
    #[error(
        "the mean or the standard deviation of this {kind} law is beyond the range of double precision"
    )]
    MomentOutOfRange {
        /// name as in [`Distribution::kind`](super::Distribution::kind)
        kind: &'static str,
    },
}

impl DistributionError {
    /// The parameter at fault (`truncate` for bounds), if it is one alone.
    pub fn parameter(&self) -> Option<&'static str> {
        match self {
            Self::NotFinite { parameter, .. }
            | Self::NotPositive { parameter, .. }
            | Self::ShapeOutOfRange { parameter, .. } => Some(parameter),
            Self::ModeOutside { .. } => Some("mode"),
            Self::EmptyTruncation { .. } | Self::NothingLeft { .. } | Self::TruncatedTwice => {
                Some("truncate")
            }
            Self::EmptyRange { .. } | Self::MomentOutOfRange { .. } => None,
        }
    }
}

pub(in crate::law) fn finite(parameter: &'static str, value: f64) -> Result<(), DistributionError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(DistributionError::NotFinite { parameter, value })
    }
}

pub(in crate::law) fn positive(
    parameter: &'static str,
    value: f64,
) -> Result<(), DistributionError> {
    finite(parameter, value)?;
    if value > 0.0 {
        Ok(())
    } else {
        Err(DistributionError::NotPositive { parameter, value })
    }
}

pub(super) fn shape(parameter: &'static str, value: f64) -> Result<(), DistributionError> {
    positive(parameter, value)?;
    if (LEAST_SHAPE..=LARGEST_SHAPE).contains(&value) {
        Ok(())
    } else {
        Err(DistributionError::ShapeOutOfRange { parameter, value })
    }
}

/// Both bounds finite, in order, and a width that is a double too.
pub(super) fn range(kind: &'static str, min: f64, max: f64) -> Result<(), DistributionError> {
    finite("min", min)?;
    finite("max", max)?;
    if min >= max {
        return Err(DistributionError::EmptyRange { min, max });
    }
    in_range(kind, min, max - min)
}

/// A mean that is a number and a standard deviation that is above zero, neither over- nor underflown.
pub(super) fn in_range(kind: &'static str, mean: f64, std: f64) -> Result<(), DistributionError> {
    if mean.is_finite() && std.is_normal() {
        Ok(())
    } else {
        Err(DistributionError::MomentOutOfRange { kind })
    }
}
