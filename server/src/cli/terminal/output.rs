//! Where results are written.

use std::convert::Infallible;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use serde::Serialize;

use crate::cli::terminal::exit::Failure;

/// Where `--json` goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JsonTarget {
    /// Standard output, which then holds this document and nothing else.
    Stdout,
    /// A file.
    File(PathBuf),
}

impl FromStr for JsonTarget {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Infallible> {
        Ok(if text == "-" {
            Self::Stdout
        } else {
            Self::File(PathBuf::from(text))
        })
    }
}

impl JsonTarget {
    /// Writes one JSON document.
    ///
    /// # Errors
    /// When it can't be written.
    pub fn write<T: Serialize>(&self, document: &T) -> Result<(), Failure> {
        let mut text = serde_json::to_string_pretty(document).map_err(Failure::other)?;
        text.push('\n');
        match self {
            Self::Stdout => print(&text),
            Self::File(path) => write_whole(path, &text),
        }
    }
}

/// Prints to standard output. A reader that went away is no failure of ours.
///
/// # Errors
/// When standard output can't be written.
pub fn print(content: &(impl AsRef<[u8]> + ?Sized)) -> Result<(), Failure> {
    write_to(std::io::stdout().lock(), content.as_ref())
}

fn write_to(mut out: impl Write, content: &[u8]) -> Result<(), Failure> {
    let written = out.write_all(content);
    match written.and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::other(error)),
        _ => Ok(()),
    }
}

/// Prints painted text where people look: on standard output, unless a JSON document goes there. The paint stays on a terminal alone, or
/// where `CLICOLOR_FORCE` asks for it, and comes off where `NO_COLOR` does.
///
/// # Errors
/// When standard output can't be written.
pub fn tell(text: &str, json: Option<&JsonTarget>) -> Result<(), Failure> {
    if json == Some(&JsonTarget::Stdout) {
        warn(text);
        return Ok(());
    }
    write_to(anstream::stdout().lock(), text.as_bytes())
}

/// Prints painted text on standard error, as [`tell`] does.
pub fn warn(text: &str) {
    anstream::eprint!("{text}");
}

/// Whether what is told goes to a terminal.
pub fn is_seen(json: Option<&JsonTarget>) -> bool {
    match json {
        Some(JsonTarget::Stdout) => std::io::stderr().is_terminal(),
        _ => std::io::stdout().is_terminal(),
    }
}

/// Writes a file so that it is either there whole or as it was before.
///
/// # Errors
/// When it can't be written.
pub fn write_whole(path: &Path, content: &(impl AsRef<[u8]> + ?Sized)) -> Result<(), Failure> {
    let mut name = path.as_os_str().to_owned();
    name.push(format!(".{}.part", std::process::id()));
    let part = PathBuf::from(name);
    let written = std::fs::write(&part, content).and_then(|()| std::fs::rename(&part, path));
    written.map_err(|error| {
        // What can't be removed was most likely never made.
        let _ = std::fs::remove_file(&part);
        Failure::Other(format!("{} can't be written: {error}", path.display()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_leaves_no_part_behind() {
        let folder = tempfile::tempdir().expect("temp dir");
        let path = folder.path().join("result.json");
        write_whole(&path, "first").expect("writes");
        write_whole(&path, "second").expect("writes");
        assert_eq!(std::fs::read_to_string(&path).expect("reads"), "second");
        assert_eq!(std::fs::read_dir(folder.path()).expect("lists").count(), 1);
        assert!(write_whole(&folder.path().join("absent/result.json"), "x").is_err());
    }
}
