//! A file that is written beside its place, and takes it when it is whole and on the disk.

use std::fs;
#[cfg(unix)]
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use crate::file::lock::FileLock;
use crate::file::place::{Place, beside};
use crate::file::rights;
use crate::store_error::StoreError;

/// Ending of a file's name while it is being written.
pub(crate) const ENDING: &str = ".unfinished";
/// Endings of what SQLite may leave beside a file.
pub(crate) const COMPANIONS: [&str; 3] = ["-wal", "-shm", "-journal"];

/// A file that isn't whole yet; removed when it is dropped before it has its place. What a kill leaves is removed by the next try.
#[derive(Debug)]
pub struct Unfinished {
    target: Place,
    part: Place,
    // Two processes don't write one file.
    lock: FileLock,
    placed: bool,
}

impl Unfinished {
    /// An empty file beside `target`, with the rights of the file `like`.
    ///
    /// # Errors
    /// [`StoreError::InUse`] when another process is writing it, [`StoreError::Copy`] when it can't be made.
    pub fn begin(target: &Place, like: &Place) -> Result<Self, StoreError> {
        let failed = |cause: io::Error| unwritten(target, &cause);
        let name = beside(&target.real, ENDING);
        // Links aren't resolved: nobody but this program has files of this name.
        let part = Place {
            named: name.clone(),
            real: name,
        };
        let begun = Self {
            target: target.clone(),
            lock: fresh(target, &part)?,
            part,
            placed: false,
        };
        begun.remove_companions();
        let like = fs::metadata(&like.real).map_err(failed)?;
        rights::keep(begun.lock.file(), &like).map_err(failed)?;
        Ok(begun)
    }

    /// Returns the path where it is written.
    pub fn path(&self) -> &Path {
        &self.part.real
    }

    /// Returns the path where it is to be.
    pub fn target(&self) -> &Path {
        &self.target.named
    }

    /// Gives it its name, which nothing has yet, when it is on the disk.
    ///
    /// # Errors
    /// [`StoreError::Copy`] when something has the name, or the disk fails.
    pub fn place(mut self) -> Result<(), StoreError> {
        let (from, to) = (&self.part.real, &self.target.real);
        let placed = self
            .lock
            .file()
            .sync_all()
            .and_then(|()| rename_new(from, to));
        self.end(placed)
    }

    /// Gives it the name of another file, which is kept under `kept`, or lost. There is a whole file of that name at every moment.
    ///
    /// # Errors
    /// As [`place`](Self::place).
    pub fn replace(mut self, kept: Option<&Path>) -> Result<(), StoreError> {
        let (from, to) = (&self.part.real, &self.target.real);
        let replaced = self.lock.file().sync_all().and_then(|()| match kept {
            None => fs::rename(from, to),
            Some(kept) => rename_new(from, kept).and_then(|()| exchange(kept, to)),
        });
        self.end(replaced)
    }

    fn end(&mut self, placed: io::Result<()>) -> Result<(), StoreError> {
        let synced = placed.and_then(|()| {
            self.placed = true;
            self.target.real.parent().map_or(Ok(()), sync_folder)
        });
        synced.map_err(|cause| unwritten(&self.target, &cause))
    }

    fn remove_companions(&self) {
        for ending in COMPANIONS {
            // What can't be removed most likely isn't there.
            let _ = fs::remove_file(self.part.beside(ending));
        }
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        if !self.placed {
            self.remove_companions();
            let _ = fs::remove_file(&self.part.real);
        }
    }
}

/// An empty file of our own making, locked; what a kill left under its name goes first.
fn fresh(target: &Place, part: &Place) -> Result<FileLock, StoreError> {
    let failed = |cause: io::Error| unwritten(target, &cause);
    loop {
        let made = rights::private()
            .append(true)
            .create_new(true)
            .open(&part.real);
        if fs::symlink_metadata(&part.real).is_ok_and(|found| found.is_symlink()) {
            let link = format!("{} is a symbolic link: remove it", part.real.display());
            return Err(failed(io::Error::other(link)));
        }
        let Some(lock) = FileLock::take(part)? else {
            // Somebody else's, who was done with it between the two.
            continue;
        };
        match made {
            Ok(_) => return Ok(lock),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                fs::remove_file(&part.real).map_err(failed)?;
            }
            Err(error) => return Err(failed(error)),
        }
    }
}

fn unwritten(target: &Place, cause: &io::Error) -> StoreError {
    let cause = match cause.kind() {
        io::ErrorKind::AlreadyExists => {
            "there is a file of that name already: name one that isn't there yet".to_owned()
        }
        _ => cause.to_string(),
    };
    StoreError::Copy {
        path: target.named.clone(),
        cause,
    }
}

/// Makes the names of a folder last.
#[cfg(unix)]
fn sync_folder(folder: &Path) -> io::Result<()> {
    File::open(folder)?.sync_all()
}

/// Makes the names of a folder last: nothing to do here.
#[cfg(not(unix))]
fn sync_folder(_folder: &Path) -> io::Result<()> {
    Ok(())
}

/// Renames to a name that nothing has.
fn rename_new(from: &Path, to: &Path) -> io::Result<()> {
    #[cfg(target_os = "linux")]
    {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        let renamed = renameat_with(CWD, from, CWD, to, RenameFlags::NOREPLACE);
        if !is_unknown(&renamed) {
            return Ok(renamed?);
        }
    }
    // The system or its disk knows no better.
    match fs::symlink_metadata(to) {
        Ok(_) => Err(io::ErrorKind::AlreadyExists.into()),
        Err(_) => fs::rename(from, to),
    }
}

/// Exchanges two files.
fn exchange(one: &Path, other: &Path) -> io::Result<()> {
    #[cfg(target_os = "linux")]
    {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        let exchanged = renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE);
        if !is_unknown(&exchanged) {
            return Ok(exchanged?);
        }
    }
    let aside: PathBuf = beside(one, ENDING);
    fs::rename(other, &aside)?;
    fs::rename(one, other)?;
    fs::rename(&aside, one)
}

#[cfg(target_os = "linux")]
fn is_unknown(renamed: &rustix::io::Result<()>) -> bool {
    use rustix::io::Errno;
    matches!(renamed, Err(Errno::INVAL | Errno::NOSYS | Errno::NOTSUP))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn begun(folder: &Path, content: &str) -> Unfinished {
        let target = Place::of(&folder.join("copy.db")).expect("a place");
        let source = Place::of(folder).expect("a place");
        let unfinished = Unfinished::begin(&target, &source).expect("begins");
        fs::write(unfinished.path(), content).expect("writes");
        unfinished
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("lists");
        let name = |entry: io::Result<fs::DirEntry>| entry.expect("reads").file_name();
        let mut names: Vec<String> = entries
            .map(|entry| name(entry).into_string().expect("UTF-8"))
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_has_its_name_when_it_is_whole_and_overwrites_nothing() {
        let folder = tempfile::tempdir().expect("temp dir");
        fs::write(folder.path().join("copy.db.unfinished"), "of a kill").expect("writes");
        let first = begun(folder.path(), "first");
        assert_eq!(names(folder.path()), ["copy.db.unfinished"]);
        let target = Place::of(&folder.path().join("copy.db")).expect("a place");
        let source = Place::of(folder.path()).expect("a place");
        let beside = Unfinished::begin(&target, &source).expect_err("is being written");
        assert!(matches!(beside, StoreError::InUse { .. }), "{beside}");
        first.place().expect("is free");
        let refused = begun(folder.path(), "second")
            .place()
            .expect_err("is taken");
        assert!(refused.to_string().contains("already"), "{refused}");
        assert_eq!(names(folder.path()), ["copy.db"]);
        let read = fs::read_to_string(folder.path().join("copy.db"));
        assert_eq!(read.expect("reads"), "first");
    }

    #[test]
    fn what_is_replaced_is_kept_when_asked_for() {
        let folder = tempfile::tempdir().expect("temp dir");
        let (copy, kept) = (folder.path().join("copy.db"), folder.path().join("kept"));
        let read = |path: &Path| fs::read_to_string(path).expect("reads");
        begun(folder.path(), "first").place().expect("is free");
        let second = begun(folder.path(), "second");
        second.replace(Some(&kept)).expect("replaces");
        assert_eq!(
            (read(&copy), read(&kept)),
            ("second".into(), "first".into())
        );
        begun(folder.path(), "third")
            .replace(None)
            .expect("replaces");
        assert_eq!((read(&copy), read(&kept)), ("third".into(), "first".into()));
        assert_eq!(names(folder.path()), ["copy.db", "kept"]);
    }
}
