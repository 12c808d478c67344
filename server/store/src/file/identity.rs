//! Identity of the file that a name stands for, whatever other names it has.

use std::fs::Metadata;
use std::path::Path;

/// Number of times that the list of locks is read before the holder of one counts as unknown.
#[cfg(target_os = "linux")]
const LOOKS: usize = 5;

/// A file of this machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct FileId {
    device: u64,
    number: u64,
}

impl FileId {
    /// Returns the identity of an open file.
    #[cfg(unix)]
    pub fn of(metadata: &Metadata) -> Self {
        use std::os::unix::fs::MetadataExt;
        Self {
            device: metadata.dev(),
            number: metadata.ino(),
        }
    }

    /// Returns the identity of an open file, which its time of birth tells from most others.
    #[cfg(not(unix))]
    pub fn of(metadata: &Metadata) -> Self {
        let born = metadata.created().ok();
        let age = born.and_then(|time| time.duration_since(std::time::UNIX_EPOCH).ok());
        Self {
            device: 0,
            number: age.map_or(0, |age| age.as_nanos() as u64),
        }
    }

    /// Returns the identity of the file at this name now.
    pub fn at(path: &Path) -> Option<Self> {
        std::fs::metadata(path).ok().as_ref().map(Self::of)
    }

    /// The process that locks the file, where the system tells.
    #[cfg(target_os = "linux")]
    pub(crate) fn locked_by(self) -> Option<u32> {
        // The list is read in pieces: when others give a lock back meanwhile, a line may be missed between two of them.
        (0..LOOKS).find_map(|_| self.listed_holder())
    }

    /// The process that the system's list of locks names.
    #[cfg(target_os = "linux")]
    fn listed_holder(self) -> Option<u32> {
        let (major, minor) = (
            rustix::fs::major(self.device),
            rustix::fs::minor(self.device),
        );
        let file = format!("{major:02x}:{minor:02x}:{}", self.number);
        let locks = std::fs::read_to_string("/proc/locks").ok()?;
        let holder = locks.lines().find_map(|line| {
            let mut words = line.split_whitespace().skip(1);
            let whole = words.next() == Some("FLOCK");
            let process = words.nth(2)?;
            (whole && words.next() == Some(&file)).then_some(process)
        });
        // A process of another container is 0.
        holder?.parse().ok().filter(|&process| process > 0)
    }

    /// The process that locks the file: the system doesn't tell.
    #[cfg(not(target_os = "linux"))]
    pub(crate) fn locked_by(self) -> Option<u32> {
        None
    }
}

/// Names of a file; one where the system doesn't count them.
#[cfg(unix)]
pub fn names(metadata: &Metadata) -> u64 {
    std::os::unix::fs::MetadataExt::nlink(metadata)
}

/// Names of a file; one where the system doesn't count them.
#[cfg(not(unix))]
pub fn names(_metadata: &Metadata) -> u64 {
    1
}
