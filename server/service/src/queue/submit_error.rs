//! Reasons why something was not taken in.

use documents::sweep::MOST_DESIGNS;

use store::StoreError;

/// Reason why a study was not taken in.
#[derive(Debug, thiserror::Error)]
pub enum SubmitError {
    /// The key stands for another document.
    #[error("the idempotency key was used with another document")]
    KeyTaken,
    /// A queue in which so many wait that another one is not taken in.
    #[error("at most {most} studies may wait: send it again when some are done")]
    TooMany {
        /// Most studies that may wait.
        most: u32,
    },
    /// The sweep would have more designs than one may.
    #[error(transparent)]
    TooManyDesigns(#[from] TooManyDesigns),
    /// A sweep whose designs could not be read.
    #[error("the designs of the sweep could not be read; the log says why")]
    Broken,
    /// The database failed.
    #[error(transparent)]
    Store(#[from] StoreError),
}

/// More designs than a sweep may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "the sweep has {there} designs and would have {more} more; {MOST_DESIGNS} are the most of one sweep"
)]
pub struct TooManyDesigns {
    /// Designs that it has.
    pub there: usize,
    /// Count of the designs to come.
    pub more: usize,
}
