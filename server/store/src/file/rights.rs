//! Rights of the files that this program makes, and links that it doesn't follow.
//!
//! A database holds what its owner let nobody else read: a new one is its owner's alone, and a copy is whose its source is. SQLite gives what it keeps beside a file the
//! rights of the file.

use std::fs::{File, Metadata, OpenOptions};
use std::io;

/// Options of a file that is its owner's alone where it is made.
pub(crate) fn private() -> OpenOptions {
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options
}

/// Options that open no symbolic link: a name of ours that somebody made one of leads to a file of theirs, or of others.
pub(crate) fn unlinked() -> OpenOptions {
    let mut options = private();
    #[cfg(target_os = "linux")]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(rustix::fs::OFlags::NOFOLLOW.bits().cast_signed());
    }
    options
}

/// Gives a file the owner and the rights of another one.
///
/// # Errors
/// When the system refuses the rights.
#[cfg(unix)]
pub(crate) fn keep(file: &File, like: &Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
    // Only the system's administrator can give files away; anyone else's new file is their own.
    let _ = fchown(file, Some(like.uid()), Some(like.gid()));
    let mode = like.permissions().mode() & 0o777;
    file.set_permissions(std::fs::Permissions::from_mode(mode))
}

/// Gives a file the rights of another one: nothing to do here.
#[cfg(not(unix))]
pub(crate) fn keep(_file: &File, _like: &Metadata) -> io::Result<()> {
    Ok(())
}
