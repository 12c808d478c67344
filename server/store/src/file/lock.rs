//! One process per database.

use std::fs::{File, OpenOptions, TryLockError};
use std::path::{Path, PathBuf};

use crate::store_error::StoreError;

/// Holds the database for this process until it is dropped or the process ends, however it ends.
#[derive(Debug)]
pub struct DatabaseLock {
    _file: File,
}

impl DatabaseLock {
    /// Takes the lock file `<database>.lock`. The file itself stays: removing it would let two processes lock
    /// two files of the same name.
    ///
    /// # Errors
    /// [`StoreError::InUse`] when another process has it, [`StoreError::Open`] when the file can't be made.
    pub fn take(database: &Path) -> Result<Self, StoreError> {
        let open_error = |cause: std::io::Error| StoreError::Open {
            path: database.to_owned(),
            cause: cause.to_string(),
        };
        let mut name = database.as_os_str().to_owned();
        name.push(".lock");
        let file = OpenOptions::new()
            .create(true)
            .truncate(false)
            .write(true)
            .open(PathBuf::from(name))
            .map_err(open_error)?;
        match file.try_lock() {
            Ok(()) => Ok(Self { _file: file }),
            Err(TryLockError::WouldBlock) => Err(StoreError::InUse {
                path: database.to_owned(),
            }),
            Err(TryLockError::Error(cause)) => Err(open_error(cause)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lock_is_taken_once_and_free_again_after_the_drop() {
        let folder = tempfile::tempdir().expect("temp dir");
        let database = folder.path().join("a.db");
        let held = DatabaseLock::take(&database).expect("free");
        assert!(matches!(
            DatabaseLock::take(&database),
            Err(StoreError::InUse { .. })
        ));
        drop(held);
        DatabaseLock::take(&database).expect("free again");
    }
}
