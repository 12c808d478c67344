//! Lock of a database, for one process.
//!
//! The lock is on the database file itself, so that links and mounts don't lead around it: `flock`, which doesn't meet SQLite's own locks (those
//! are `fcntl`'s). A process loses all of `fcntl`'s locks on a file when it closes any descriptor of it. So the descriptor of the lock
//! is opened before SQLite's and closed after them, and nobody opens the file otherwise while this process holds it.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read, Seek, SeekFrom};
use std::sync::{Mutex, PoisonError};

use crate::file::identity::FileId;
use crate::file::place::Place;
use crate::file::rights;
use crate::store_error::StoreError;

/// Number of times that a file may be replaced between a look at it and its lock; on disks that number their files anew at every look, always.
const TRIES: usize = 100;

/// Files that this process holds.
static HELD: Mutex<Vec<FileId>> = Mutex::new(Vec::new());

/// Holds a database for this process until it is dropped or the process ends, however it ends.
#[derive(Debug)]
pub(crate) struct DatabaseLock {
    _file: FileLock,
    _name: NameLock,
}

impl DatabaseLock {
    /// Joins what holds the file, and what keeps others from making or replacing it under its name.
    pub fn new(file: FileLock, name: NameLock) -> Self {
        Self {
            _file: file,
            _name: name,
        }
    }
}

/// Holds a file, whatever name it is opened by.
#[derive(Debug)]
pub struct FileLock {
    // In this order: the file is closed before another part of this process may open it.
    file: File,
    _claim: Claim,
}

impl FileLock {
    /// Locks the file that is there; none when there is none.
    ///
    /// # Errors
    /// [`StoreError::InUse`] when somebody has it, [`StoreError::Open`] when it can't be written.
    pub fn take(place: &Place) -> Result<Option<Self>, StoreError> {
        for _ in 0..TRIES {
            place.check()?;
            let Some(id) = FileId::at(&place.real) else {
                return Ok(None);
            };
            let claim = Claim::of(id).ok_or_else(|| in_use(place, Some(std::process::id())))?;
            let opened = rights::unlinked().read(true).write(true).open(&place.real);
            let file = match opened {
                Ok(file) => file,
                Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
                Err(error) => return Err(refused(place, &error)),
            };
            lock_whole(&file, place, id)?;
            let metadata = file.metadata().map_err(|error| place.failed(error))?;
            // Another file may have taken the name between the first look and the lock.
            if FileId::of(&metadata) == id && FileId::at(&place.real) == Some(id) {
                return Ok(Some(Self {
                    file,
                    _claim: claim,
                }));
            }
        }
        Err(place.failed("another file takes its name again and again"))
    }

    /// The open file, which must not be opened otherwise.
    pub fn file(&self) -> &File {
        &self.file
    }

    /// The first bytes of the file, without closing a descriptor of it.
    ///
    /// # Errors
    /// When they can't be read.
    pub fn head(&mut self, bytes: &mut Vec<u8>) -> std::io::Result<()> {
        self.file.seek(SeekFrom::Start(0))?;
        (&self.file).take(100).read_to_end(bytes)?;
        Ok(())
    }
}

/// Whether this process holds the file.
pub(crate) fn is_held(id: FileId) -> bool {
    let held = HELD.lock().unwrap_or_else(PoisonError::into_inner);
    held.contains(&id)
}

/// A place in the list of held files.
#[derive(Debug)]
struct Claim {
    id: FileId,
}

impl Claim {
    fn of(id: FileId) -> Option<Self> {
        let mut held = HELD.lock().unwrap_or_else(PoisonError::into_inner);
        if held.contains(&id) {
            return None;
        }
        held.push(id);
        Some(Self { id })
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        let mut held = HELD.lock().unwrap_or_else(PoisonError::into_inner);
        held.retain(|&id| id != self.id);
    }
}

/// Holds the name `<database>.lock`: two processes can't make or replace one file at once. The file stays: removing it would let two processes lock two files of one name.
#[derive(Debug)]
pub struct NameLock {
    _file: File,
}

impl NameLock {
    /// Takes it.
    ///
    /// # Errors
    /// [`StoreError::InUse`] when another process has it, [`StoreError::Open`] when the file can't be made.
    pub fn take(place: &Place) -> Result<Self, StoreError> {
        let name = place.beside(".lock");
        let file = OpenOptions::new()
            .create(true)
            .truncate(false)
            .write(true)
            .open(&name)
            .map_err(|error| refused(place, &error))?;
        let metadata = file.metadata().map_err(|error| place.failed(error))?;
        lock_whole(&file, place, FileId::of(&metadata))?;
        Ok(Self { _file: file })
    }
}

fn lock_whole(file: &File, place: &Place, id: FileId) -> Result<(), StoreError> {
    match file.try_lock() {
        Ok(()) => Ok(()),
        Err(TryLockError::WouldBlock) => Err(in_use(place, id.locked_by())),
        Err(TryLockError::Error(cause)) => Err(place.failed(cause)),
    }
}

fn in_use(place: &Place, process: Option<u32>) -> StoreError {
    StoreError::InUse {
        path: place.named.clone(),
        process,
    }
}

/// Returns what to say when a file can't be opened for writing.
fn refused(place: &Place, error: &std::io::Error) -> StoreError {
    match error.kind() {
        ErrorKind::ReadOnlyFilesystem | ErrorKind::PermissionDenied => place.failed(format!(
            "it is read-only here ({error}), and what was asked for writes to it: copy it with db backup to a disk that can be written, or make \
             this one writable; list, show, compare, export, db check and db backup read it as it is"
        )),
        _ => place.failed(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn taken(path: &Path) -> Result<Option<FileLock>, StoreError> {
        FileLock::take(&Place::of(path).expect("a place"))
    }

    #[test]
    fn a_file_is_locked_once_by_whatever_name_and_free_again_after_the_drop() {
        let folder = tempfile::tempdir().expect("temp dir");
        let database = folder.path().join("a.db");
        assert!(taken(&database).expect("nothing there").is_none());
        std::fs::write(&database, "").expect("writes");
        let (link, hard) = (folder.path().join("link.db"), folder.path().join("hard.db"));
        std::fs::hard_link(&database, &hard).expect("links");
        #[cfg(unix)]
        std::os::unix::fs::symlink(&database, &link).expect("links");
        let held = taken(&database).expect("free");
        for name in [&database, &link, &hard] {
            let refused = taken(name).expect_err("held");
            assert!(matches!(refused, StoreError::InUse { .. }), "{refused}");
        }
        drop(held);
        assert!(taken(&hard).expect("free again").is_some());
    }

    #[test]
    fn what_is_no_file_is_not_opened() {
        let folder = tempfile::tempdir().expect("temp dir");
        let refused = taken(folder.path()).expect_err("a folder");
        assert!(refused.to_string().contains("name a file"), "{refused}");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn the_process_that_holds_a_file_is_known() {
        let folder = tempfile::tempdir().expect("temp dir");
        let database = folder.path().join("a.db");
        std::fs::write(&database, "").expect("writes");
        let _held = taken(&database).expect("free").expect("there");
        let id = FileId::at(&database).expect("there");
        assert_eq!(id.locked_by(), Some(std::process::id()));
    }
}
