//! Where solved points are kept, so that none is solved twice.

use fem_client::solver::{Cost, Response, StartState};

/// Keeps responses and start states by content key. Called from the solving threads.
pub trait Archive: Sync {
    /// The stored response under this key, with what it once took; the study needs it as the point with this ordinal.
    ///
    /// # Errors
    /// When the archive can't be read, or what it holds fails its own hash.
    fn load(&self, key: &str, ordinal: usize) -> Result<Option<(Response, Cost)>, ArchiveError>;

    /// Stores a response for good; storing under a present key is not an error and changes nothing.
    ///
    /// # Errors
    /// When the archive can't be written.
    fn save(&self, point: &PointRecord<'_>) -> Result<(), ArchiveError>;

    /// The stored start state under this key.
    ///
    /// # Errors
    /// As for [`Archive::load`].
    fn load_start(&self, key: &str) -> Result<Option<StartState>, ArchiveError>;
}

/// One solved point, to be stored as a whole.
#[derive(Debug, Clone, Copy)]
pub struct PointRecord<'a> {
    /// Content key: hash of all that determines the response.
    pub key: &'a str,
    /// Ordinal of the point in its study's plan.
    pub ordinal: usize,
    /// Scene of the point as canonical JSON.
    pub scene: &'a str,
    /// The answer.
    pub response: &'a Response,
    /// What it took.
    pub cost: Cost,
    /// Its equilibrium, when other points start from it.
    pub start: Option<&'a StartState>,
}

/// The archive failed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the archive failed: {detail}")]
pub struct ArchiveError {
    /// What happened.
    pub detail: String,
}
