//! A disk of a few megabytes, in memory.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

/// A small disk, unmounted when dropped.
pub struct SmallDisk {
    folder: TempDir,
}

fn done(command: &str, arguments: &[&str]) -> bool {
    let ended = Command::new(command).args(arguments).output();
    ended.is_ok_and(|output| output.status.success())
}

impl SmallDisk {
    /// A disk of this size; none, with a word why, where mounting isn't allowed.
    pub fn mount(megabytes: usize) -> Option<Self> {
        let folder = tempfile::tempdir().expect("temp dir");
        let size = format!("size={megabytes}m");
        let path = folder.path().to_str().expect("UTF-8").to_owned();
        if done("mount", &["-t", "tmpfs", "-o", &size, "tmpfs", &path]) {
            return Some(Self { folder });
        }
        eprintln!("skipped: a small disk can't be mounted here; it takes root");
        None
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    pub fn make_read_only(&self) {
        let path = self.path().to_str().expect("UTF-8");
        assert!(done("mount", &["-o", "remount,ro", path]));
    }

    /// Fills it with one file, but for so many bytes.
    pub fn fill_but(&self, rest: u64) -> PathBuf {
        let path = self.path().join("filler");
        let mut file = std::fs::File::create(&path).expect("creates");
        for size in [1 << 20, 1 << 12, 1] {
            loop {
                match std::io::Write::write(&mut file, &vec![0; size]) {
                    Ok(written) if written > 0 => {}
                    Ok(_) => break,
                    Err(error) if error.kind() == ErrorKind::StorageFull => break,
                    Err(error) => panic!("{error}"),
                }
            }
        }
        let size = file.metadata().expect("has a size").len();
        file.set_len(size - rest).expect("shrinks");
        path
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        // Lazily: a program that a failed test left behind may still have files open.
        done("umount", &["-l", self.path().to_str().expect("UTF-8")]);
    }
}
