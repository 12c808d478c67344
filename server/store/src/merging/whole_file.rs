//! Files that another database may take in, read whole.

use std::path::{Path, PathBuf};

use sqlx::SqliteConnection;

use crate::file::copies::{self, Tables};
use crate::file::identity::FileId;
use crate::file::opening;
use crate::file::place::{Place, beside};
use crate::file::unfinished::{ENDING, Unfinished};
use crate::store_error::StoreError;

/// Private copies that a database may have beside it at once.
const MOST_COPIES: usize = 100;

/// File that was read whole: a private copy of it, which goes with this value.
#[derive(Debug)]
pub struct WholeFile {
    named: PathBuf,
    copy: Unfinished,
}

impl WholeFile {
    /// The file, as it was asked for.
    pub(super) fn named(&self) -> &Path {
        &self.named
    }

    /// Path of the copy.
    pub(super) fn path(&self) -> &Path {
        self.copy.path()
    }

    /// A connection that reads the copy.
    ///
    /// # Errors
    /// When it can't be opened.
    pub async fn open(&self) -> Result<SqliteConnection, StoreError> {
        opening::to_read(self.copy.path()).await
    }
}

/// Does something with each item in order, once that was read; the next one is read meanwhile.
///
/// # Errors
/// The first that there is; what comes after it isn't done.
pub async fn read_ahead<I, R, T, E>(
    items: &[I],
    read: impl AsyncFn(&I) -> R,
    mut take: impl AsyncFnMut(&I, R) -> Result<T, E>,
) -> Result<Vec<T>, E> {
    let read_at = async |place: usize| match items.get(place) {
        Some(item) => Some(read(item).await),
        None => None,
    };
    let mut taken = Vec::new();
    let mut next = read_at(0).await;
    for item in items {
        let Some(found) = next.take() else { break };
        let (one, following) = tokio::join!(take(item, found), read_at(taken.len() + 1));
        taken.push(one?);
        next = following;
    }
    Ok(taken)
}

/// Reader of files for a database, which may be at something else meanwhile.
#[derive(Debug)]
pub struct FileReader {
    place: Place,
}

impl FileReader {
    /// A reader for the database at a place, beside which nothing is left that a kill left there.
    pub(super) fn new(place: Place) -> Self {
        let reader = Self { place };
        for number in 1..=MOST_COPIES {
            if reader.unfinished(number).exists() {
                // It goes with the value, unless somebody is at work on it.
                drop(reader.begun(number));
            }
        }
        reader
    }

    /// Reads a file whole from a private copy. Tells `seen` how many of its rows were read, and of how many.
    ///
    /// # Errors
    /// [`StoreError::Open`] when it isn't whole, or has other tables; [`StoreError::Merge`] when it is the database itself.
    pub async fn read(
        &self,
        file: &Path,
        seen: &dyn Fn(usize, usize),
    ) -> Result<WholeFile, StoreError> {
        let source = Place::of(file)?;
        let id = FileId::at(&source.real);
        if id.is_some() && id == FileId::at(&self.place.real) {
            return Err(StoreError::Merge {
                path: file.to_owned(),
                cause: "it is the database itself".to_owned(),
            });
        }
        let copy = copies::whole(&source, self.copy()?, Tables::Ours, seen).await?;
        Ok(WholeFile {
            named: file.to_owned(),
            copy,
        })
    }

    /// An empty copy beside the database; others of this process may be at work on theirs.
    fn copy(&self) -> Result<Unfinished, StoreError> {
        let mut number = 1;
        loop {
            match self.begun(number) {
                Err(StoreError::InUse { .. }) if number < MOST_COPIES => number += 1,
                begun => return begun,
            }
        }
    }

    fn begun(&self, number: usize) -> Result<Unfinished, StoreError> {
        Unfinished::begin(&Place::of(&self.named(number))?, &self.place)
    }

    /// Name of a copy, which it never gets.
    fn named(&self, number: usize) -> PathBuf {
        self.place.beside(&format!(".merging{number}"))
    }

    fn unfinished(&self, number: usize) -> PathBuf {
        beside(&self.named(number), ENDING)
    }
}
