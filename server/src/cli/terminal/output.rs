//! Outputs of commands, and where they are written.

use std::convert::Infallible;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use anstream::{AutoStream, ColorChoice};
use serde::Serialize;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output_place::{is_stdout, write, write_to};
use crate::cli::terminal::shown::{plain, shown};

/// Target of `--json`.
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
        Ok(if text == "-" || is_stdout(Path::new(text)) {
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
            Self::File(path) => write(path, text.as_bytes()),
        }
    }
}

/// Prints data to standard output, byte for byte: what people read is [told](tell). A reader that went away is no failure of ours.
///
/// # Errors
/// When standard output can't be written.
pub fn print(content: &(impl AsRef<[u8]> + ?Sized)) -> Result<(), Failure> {
    write_to(std::io::stdout().lock(), content.as_ref()).map_err(Failure::other)
}

/// Prints text where people look: on standard output, unless a JSON document goes there. Its paint is seen on a terminal alone, or where `CLICOLOR_FORCE` asks for
/// it, and not where `NO_COLOR` does.
///
/// # Errors
/// When standard output can't be written.
pub fn tell(text: &str, json: Option<&JsonTarget>) -> Result<(), Failure> {
    if json == Some(&JsonTarget::Stdout) {
        warn(text);
        return Ok(());
    }
    write_to(anstream::stdout().lock(), shown(text).as_bytes()).map_err(Failure::other)
}

/// Prints text on standard error, as [`tell`] does.
pub fn warn(text: &str) {
    // There is nobody left to tell when it can't be.
    let _ = anstream::stderr().lock().write_all(shown(text).as_bytes());
}

/// Returns the text as [`warn`] prints it, for what draws on standard error itself.
pub(crate) fn as_warned(text: &str) -> String {
    match AutoStream::choice(&std::io::stderr()) {
        ColorChoice::Never => plain(text),
        _ => shown(text),
    }
}

/// Whether what is told goes to a terminal.
pub(crate) fn is_seen(json: Option<&JsonTarget>) -> bool {
    match json {
        Some(JsonTarget::Stdout) => std::io::stderr().is_terminal(),
        _ => std::io::stdout().is_terminal(),
    }
}
