//! A place that a user named for a file: what stands there, and how it is written.
//!
//! A regular file, or one that isn't there yet, is written beside its place and renamed, so that it is there whole or as it was before. Symbolic links stay and what they
//! lead to is replaced. Devices, pipes and what the shell has opened are opened and written: a new file in their place would help nobody.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use crate::cli::terminal::exit::Failure;

/// File or stream that a path leads to.
#[derive(Debug, PartialEq, Eq)]
enum Standing {
    /// A regular file or nothing yet, all links followed.
    File(PathBuf),
    /// The program's own standard output.
    Stdout,
    /// A device, a pipe, or a file that is open already.
    Stream,
}

/// Linux follows as many.
const MOST_LINKS: usize = 40;

fn standing(path: &Path) -> io::Result<Standing> {
    if path.as_os_str().as_encoded_bytes().ends_with(b"/") {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let found = match fs::symlink_metadata(&path) {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                if path.file_name().is_none() {
                    return Err(io::Error::new(io::ErrorKind::NotFound, "it names no file"));
                }
                return Ok(Standing::File(path));
            }
            Err(error) => return Err(error),
        };
        if found.is_dir() {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        if found.is_file() {
            return Ok(Standing::File(path));
        }
        if !found.is_symlink() {
            return Ok(Standing::Stream);
        }
        if let Some(open) = open_already(&path) {
            return Ok(open);
        }
        path = folder_of(&path).join(fs::read_link(&path)?);
    }
    Err(io::Error::other("its symbolic links lead in a circle"))
}

/// Finds what a link to a descriptor of Linux leads to, such as `/dev/stdout`: its file may have been opened by a shell, which goes on writing there.
fn open_already(link: &Path) -> Option<Standing> {
    let folder = folder_of(link).canonicalize().ok()?;
    if !folder.starts_with("/proc") || !folder.ends_with("fd") {
        return None;
    }
    let own = folder
        == Path::new("/proc")
            .join(std::process::id().to_string())
            .join("fd");
    let stdout = own && link.file_name().is_some_and(|name| name == "1");
    Some(if stdout {
        Standing::Stdout
    } else {
        Standing::Stream
    })
}

/// Whether the path names the program's own standard output.
pub(crate) fn is_stdout(path: &Path) -> bool {
    matches!(standing(path), Ok(Standing::Stdout))
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

/// Identity that tells files apart, whatever they are called; none for what is no regular file.
#[derive(Debug, PartialEq, Eq)]
pub enum Identity {
    /// Device and number.
    #[cfg(unix)]
    Node(u64, u64),
    /// Name of a file that isn't there yet.
    Name(PathBuf),
}

impl Identity {
    /// Returns the identity of the regular file that the path leads to, or will.
    pub fn of(path: &Path) -> Option<Self> {
        let Ok(Standing::File(file)) = standing(path) else {
            return None;
        };
        #[cfg(unix)]
        if let Ok(found) = fs::metadata(&file) {
            use std::os::unix::fs::MetadataExt;
            return Some(Self::Node(found.dev(), found.ino()));
        }
        let folder = folder_of(&file);
        // One that isn't there has no links yet.
        let folder = folder
            .canonicalize()
            .or_else(|_| std::path::absolute(folder));
        Some(Self::Name(folder.ok()?.join(file.file_name()?)))
    }
}

/// The regular file that the path leads to, all links followed.
pub fn followed(path: &Path) -> Option<PathBuf> {
    match standing(path) {
        Ok(Standing::File(file)) => Some(file),
        _ => None,
    }
}

/// Tries whether a file can be written there, and leaves all as it was.
///
/// # Errors
/// A sentence that says why it can't.
pub fn check(path: &Path) -> Result<(), Failure> {
    let checked = standing(path).and_then(|standing| {
        let Standing::File(file) = standing else {
            return Ok(());
        };
        if file.exists() {
            refuse_database(&file)?;
            OpenOptions::new().write(true).open(&file)?;
        }
        probe(folder_of(&file))
    });
    checked.map_err(|error| Failure::input(unwritable(path, &error)))
}

/// Tries whether a folder is there, or can be made, and can be written to.
///
/// # Errors
/// A sentence that says why it can't.
pub(crate) fn check_folder(folder: &Path) -> Result<(), Failure> {
    let there = folder.ancestors().find(|ancestor| ancestor.exists());
    probe(there.unwrap_or(Path::new(".")))
        .map_err(|error| Failure::input(unwritable(folder, &error)))
}

/// No output is meant to end a database, of this command or of another.
fn refuse_database(file: &Path) -> io::Result<()> {
    const SQLITE: &[u8; 16] = b"SQLite format 3\0";
    let mut begins = [0; SQLITE.len()];
    match File::open(file).and_then(|mut file| file.read_exact(&mut begins)) {
        Ok(()) if begins == *SQLITE => Err(io::Error::other("it is a database; name another file")),
        _ => Ok(()),
    }
}

fn probe(folder: &Path) -> io::Result<()> {
    if !folder.is_dir() {
        let missing = format!("there is no folder {}", folder.display());
        return Err(io::Error::new(io::ErrorKind::NotFound, missing));
    }
    let part = part_in(folder);
    fresh(&part)?;
    fs::remove_file(&part)
}

fn unwritable(path: &Path, error: &io::Error) -> String {
    format!("{} can't be written: {error}", path.display())
}

fn part_in(folder: &Path) -> PathBuf {
    folder.join(format!(".strainsite.{}.part", std::process::id()))
}

/// A file of our own; what a program of the same number left behind goes first.
fn fresh(part: &Path) -> io::Result<File> {
    let _ = fs::remove_file(part);
    OpenOptions::new().write(true).create_new(true).open(part)
}

/// Writes the content where the path leads.
///
/// # Errors
/// When it can't be written.
pub fn write(path: &Path, content: &[u8]) -> Result<(), Failure> {
    let written = standing(path).and_then(|standing| match standing {
        Standing::File(file) => replace(&file, content),
        Standing::Stdout => write_to(io::stdout().lock(), content),
        Standing::Stream => {
            let stream = OpenOptions::new().append(true).open(path)?;
            write_to(stream, content)
        }
    });
    written.map_err(|error| Failure::Other(unwritable(path, &error)))
}

/// Writes all of it. A reader that went away is no failure of ours.
///
/// # Errors
/// Anything else that the system says.
pub(crate) fn write_to(mut out: impl Write, content: &[u8]) -> io::Result<()> {
    let written = out.write_all(content).and_then(|()| out.flush());
    written.or_else(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Ok(()),
        _ => Err(error),
    })
}

fn replace(file: &Path, content: &[u8]) -> io::Result<()> {
    let part = part_in(folder_of(file));
    let written = fresh(&part).and_then(|mut out| {
        if let Ok(before) = fs::metadata(file) {
            keep_owner(&part, &before);
            // Before the content, which others may have no right to read.
            out.set_permissions(before.permissions())?;
        }
        out.write_all(content)?;
        fs::rename(&part, file)
    });
    written.inspect_err(|_| {
        // What can't be removed was most likely never made.
        let _ = fs::remove_file(&part);
    })
}

/// Only the system's administrator can give files away; anyone else's new file is their own.
#[cfg(unix)]
fn keep_owner(part: &Path, before: &fs::Metadata) {
    use std::os::unix::fs::{MetadataExt, chown};
    let _ = chown(part, Some(before.uid()), Some(before.gid()));
}

#[cfg(not(unix))]
fn keep_owner(_: &Path, _: &fs::Metadata) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_leaves_no_part_behind() {
        let folder = tempfile::tempdir().expect("temp dir");
        let path = folder.path().join("result.json");
        write(&path, b"first").expect("writes");
        check(&path).expect("can be written");
        write(&path, b"second").expect("writes");
        assert_eq!(fs::read(&path).expect("reads"), b"second");
        assert_eq!(fs::read_dir(folder.path()).expect("lists").count(), 1);
        for absent in [
            PathBuf::new(),
            folder.path().join("x".repeat(300)),
            folder.path().join("absent/result.json"),
            folder.path().to_owned(),
        ] {
            assert!(check(&absent).is_err_and(|refused| refused.code() == 2));
            assert!(write(&absent, b"x").is_err());
        }
        check_folder(&folder.path().join("a/b")).expect("can be made");
        assert!(check_folder(&path.join("a")).is_err(), "below a file");
        assert_eq!(fs::read_dir(folder.path()).expect("lists").count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn links_stay_and_rights_are_kept() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().expect("temp dir");
        let [target, link, dangling, circle] =
            ["target", "link", "dangling", "circle"].map(|name| folder.path().join(name));
        fs::write(&target, "before").expect("writes");
        fs::set_permissions(&target, fs::Permissions::from_mode(0o600)).expect("sets");
        for (to, from) in [("target", &link), ("new", &dangling), ("circle", &circle)] {
            symlink(to, from).expect("links");
        }
        write(&link, b"after").expect("writes");
        write(&dangling, b"after").expect("writes");
        assert!(write(&circle, b"after").is_err());
        assert!(link.is_symlink() && dangling.is_symlink());
        assert_eq!(fs::read(&target).expect("reads"), b"after");
        assert_eq!(
            fs::read(folder.path().join("new")).expect("reads"),
            b"after"
        );
        let mode = fs::metadata(&target).expect("there").permissions().mode();
        assert_eq!(mode & 0o777, 0o600);
        assert_eq!(Identity::of(&link), Identity::of(&target));
        fs::hard_link(&target, folder.path().join("twin")).expect("links");
        assert_eq!(
            Identity::of(&folder.path().join("twin")),
            Identity::of(&target)
        );
    }

    #[test]
    fn a_database_is_never_replaced() {
        let folder = tempfile::tempdir().expect("temp dir");
        let path = folder.path().join("other.db");
        fs::write(&path, b"SQLite format 3\0 and pages").expect("writes");
        let refused = check(&path).expect_err("a database");
        assert!(
            refused.to_string().contains("it is a database"),
            "{refused}"
        );
    }
}
