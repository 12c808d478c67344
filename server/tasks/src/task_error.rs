//! Reasons why tasks can't be made, done or taken in.

use store::StoreError;

/// Reason why tasks can't be made, done or taken in.
#[derive(Debug, thiserror::Error)]
pub enum TaskError {
    /// A folder that isn't as it was asked for, a sentence.
    #[error("{0}")]
    Asked(String),
    /// An engine that is missing, full or refuses, in its own words.
    #[error("{0}")]
    Engine(String),
    /// A wish to stop.
    #[error("stopped; what is solved is kept")]
    Stopped,
    /// A database that can't be read or written.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Another failure, a sentence.
    #[error("{0}")]
    Failed(String),
}
