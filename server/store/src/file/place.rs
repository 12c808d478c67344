//! Place of a database: its file, and what SQLite and this program keep beside it.

use std::path::{Path, PathBuf};

use crate::store_error::StoreError;

/// A database file, there or not.
#[derive(Debug, Clone)]
pub struct Place {
    /// Path as it was asked for, for messages.
    pub named: PathBuf,
    /// Path from the root of the file system, links resolved: no name is special to SQLite then, and what is beside the file is found.
    pub real: PathBuf,
}

impl Place {
    /// The file of this name, plain whatever SQLite would make of it.
    ///
    /// # Errors
    /// [`StoreError::Open`] when the folder isn't there.
    pub fn of(named: &Path) -> Result<Self, StoreError> {
        let resolved: std::io::Result<PathBuf> = named.canonicalize().or_else(|_| {
            let absolute = std::path::absolute(named)?;
            let (folder, name) = (absolute.parent(), absolute.file_name());
            match (folder, name) {
                (Some(folder), Some(name)) => Ok(folder.canonicalize()?.join(name)),
                _ => Ok(absolute),
            }
        });
        match resolved {
            Ok(real) => Ok(Self {
                named: named.to_owned(),
                real,
            }),
            Err(error) => Err(StoreError::Open {
                path: named.to_owned(),
                cause: error.to_string(),
            }),
        }
    }

    /// Refuses folders, devices and pipes, which must not even be opened.
    ///
    /// # Errors
    /// [`StoreError::Open`].
    pub fn check(&self) -> Result<(), StoreError> {
        match std::fs::metadata(&self.real) {
            Ok(metadata) if !metadata.is_file() => {
                Err(self.failed("it is a folder, a device or a pipe: name a file"))
            }
            _ => Ok(()),
        }
    }

    /// The file of this name with something after it.
    pub fn beside(&self, ending: &str) -> PathBuf {
        beside(&self.real, ending)
    }

    /// Returns the path of its write-ahead log.
    pub fn log(&self) -> PathBuf {
        self.beside("-wal")
    }

    /// The index of its write-ahead log, which processes share.
    pub fn index(&self) -> PathBuf {
        self.beside("-shm")
    }

    /// An error of this database.
    pub fn failed(&self, cause: impl ToString) -> StoreError {
        StoreError::Open {
            path: self.named.clone(),
            cause: cause.to_string(),
        }
    }
}

/// A name with something after it.
pub fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}
