//! Whether the files of an open database are still those that were opened.
//!
//! SQLite goes on with files that were removed or replaced under it: what it commits then is gone with the process.

use std::path::PathBuf;

use crate::file::identity::FileId;
use crate::file::place::Place;
use crate::store_error::StoreError;

/// The files of an open database.
#[derive(Debug)]
pub(crate) struct Presence {
    files: Vec<(PathBuf, FileId)>,
}

impl Presence {
    /// Notes the files as they are: the database by the name it was asked for, its log and the log's index. They stay as long as a
    /// connection does.
    pub fn note(place: &Place) -> Self {
        let names = [place.named.clone(), place.log(), place.index()];
        let known = names.map(|name| FileId::at(&name).map(|id| (name, id)));
        Self {
            files: known.into_iter().flatten().collect(),
        }
    }

    /// Compares them with what is there now: a question to the system for each, about a microsecond.
    ///
    /// # Errors
    /// [`StoreError::Gone`] that names the first that isn't there any more.
    pub fn check(&self) -> Result<(), StoreError> {
        let gone = self
            .files
            .iter()
            .find(|(name, id)| FileId::at(name) != Some(*id));
        gone.map_or(Ok(()), |(name, _)| {
            Err(StoreError::Gone { file: name.clone() })
        })
    }
}
