//! Archive of solved points, so that none is solved twice.

use std::collections::HashMap;

use fem_client::solver::{Cost, Response, StartState};
use results::Unsolved;

/// Outcome of a solve. That a load has no equilibrium is as good an answer as a response: the same for the same request, and kept like one. A solver
/// that broke has found neither.
pub type Outcome = Result<Response, Unsolved>;

/// Keeps outcomes and start states by content key. Called from the solving threads.
pub trait Archive: Sync {
    /// The stored outcomes under these keys, each with what it once took, in their order; the study needs them as the points with ordinals
    /// from `first` on.
    ///
    /// # Errors
    /// When the archive can't be read, or what it holds fails its own hash.
    fn load(
        &self,
        keys: &[String],
        first: usize,
    ) -> Result<Vec<Option<(Outcome, Cost)>>, ArchiveError>;

    /// Notes that a solve begins. Should the program die before it is saved or given up, this key is suspect.
    ///
    /// # Errors
    /// When the archive can't be written.
    fn begin(&self, _key: &str) -> Result<(), ArchiveError> {
        Ok(())
    }

    /// Notes that a solve that began has ended without an outcome.
    ///
    /// # Errors
    /// When the archive can't be written.
    fn give_up(&self, _key: &str) -> Result<(), ArchiveError> {
        Ok(())
    }

    /// The suspect keys, whichever study they belong to: the program died while they were being solved, of whatever cause.
    ///
    /// # Errors
    /// When the archive can't be read.
    fn crashes(&self) -> Result<HashMap<String, Crashes>, ArchiveError> {
        Ok(HashMap::new())
    }

    /// Counts a crash of the process in which this key was solved alone, and returns how many there were.
    ///
    /// # Errors
    /// When the archive can't be written.
    fn crashed(&self, _key: &str, _cause: &str) -> Result<usize, ArchiveError> {
        Ok(1)
    }

    /// Stores an outcome for good; storing under a present key is not an error and changes nothing.
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

/// Crashes of a suspect point.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Crashes {
    /// Number of crashes of its own process, in which it was solved alone.
    pub own: usize,
    /// Cause of that process's last end.
    pub cause: String,
}

/// A point and its outcome, to be stored as a whole.
#[derive(Debug, Clone, Copy)]
pub struct PointRecord<'a> {
    /// Content key: hash of all that determines the outcome.
    pub key: &'a str,
    /// Ordinal of the point in its study's plan.
    pub ordinal: usize,
    /// Scene of the point as canonical JSON.
    pub scene: &'a str,
    /// The answer.
    pub outcome: &'a Outcome,
    /// Cost of the solve.
    pub cost: Cost,
    /// Equilibrium of the point, when other points start from it.
    pub start: Option<&'a StartState>,
}

/// The archive failed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the archive failed: {detail}")]
pub struct ArchiveError {
    /// Cause, in words.
    pub detail: String,
}
