//! The log: on standard error, for people or for programs, one line an event.

use std::io::{self, IsTerminal, Write};
use std::panic;
use std::str::FromStr;

use clap::ValueEnum;
use document::visible::is_hidden;
use tracing_subscriber::EnvFilter;
use tracing_subscriber::filter::ParseError;
use tracing_subscriber::fmt::MakeWriter;

/// Format of the log.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LogFormat {
    /// Text for people.
    Text,
    /// JSON, an object a line.
    Json,
}

/// Filter of the log: a level, or levels of parts of the program, as in `info,server::queue=debug`.
#[derive(Debug, Clone)]
pub(crate) struct LogFilter(String);

impl FromStr for LogFilter {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        EnvFilter::try_new(text)?;
        Ok(Self(text.to_owned()))
    }
}

/// Starts the log of a command: what the environment variable STRAINSITE_LOG says, or else warnings.
pub fn start() {
    let filter =
        EnvFilter::try_from_env("STRAINSITE_LOG").unwrap_or_else(|_| EnvFilter::new("warn"));
    write_text(filter);
}

/// Starts the log of the service; a panic anywhere becomes a line of it, with what was being done.
pub(crate) fn start_service(filter: &LogFilter, format: LogFormat) {
    let filter = EnvFilter::new(&filter.0);
    match format {
        LogFormat::Text => write_text(filter),
        LogFormat::Json => write_json(filter),
    }
    panic::set_hook(Box::new(|panic| {
        let said = panic.payload_as_str().unwrap_or_default();
        let place = panic
            .location()
            .map(ToString::to_string)
            .unwrap_or_default();
        tracing::error!(?said, place, "a panic");
    }));
}

/// A log that can't be written isn't told of on standard error either, which is where it goes: that would end in a panic.
const UNTOLD: bool = false;

fn write_text(filter: EnvFilter) {
    let log = tracing_subscriber::fmt()
        .with_env_filter(filter)
        .with_writer(Lines)
        .log_internal_errors(UNTOLD)
        .with_ansi(io::stderr().is_terminal());
    // A second start in one process, as in tests, keeps the first.
    let _ = log.try_init();
}

fn write_json(filter: EnvFilter) {
    let log = tracing_subscriber::fmt()
        .json()
        .flatten_event(true)
        .with_current_span(false)
        .with_env_filter(filter)
        .with_writer(io::stderr)
        .log_internal_errors(UNTOLD);
    let _ = log.try_init();
}

/// Writes each event as one line to standard error. What a client sends may hold line breaks, and must not look like a line of ours.
struct Lines;

impl<'a> MakeWriter<'a> for Lines {
    type Writer = Line;

    fn make_writer(&'a self) -> Line {
        Line
    }
}

struct Line;

impl Write for Line {
    /// Is called once an event, with all of its text.
    fn write(&mut self, event: &[u8]) -> io::Result<usize> {
        io::stderr().write_all(one_line(event).as_bytes())?;
        Ok(event.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        io::stderr().flush()
    }
}

/// The text with its control characters and line breaks of every kind spelled out, but for its end and for colours: those of a client's text are spelled out before
/// they come here.
fn one_line(event: &[u8]) -> String {
    let text = String::from_utf8_lossy(event);
    let mut line = String::with_capacity(text.len() + 1);
    for c in text.trim_end_matches('\n').chars() {
        if is_hidden(c) && c != '\x1b' {
            line.extend(c.escape_default());
        } else {
            line.push(c);
        }
    }
    line.push('\n');
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_event_is_one_line_whatever_a_client_sent() {
        let forged = "a study called x\n2026-11-22 ERROR all is lost\r\u{85}\u{2028}\n";
        let line = one_line(forged.as_bytes());
        assert_eq!(
            line,
            "a study called x\\n2026-11-22 ERROR all is lost\\r\\u{85}\\u{2028}\n"
        );
        assert_eq!(
            one_line(b"\x1b[32m INFO\x1b[0m ready\n"),
            "\x1b[32m INFO\x1b[0m ready\n"
        );
        assert_eq!(one_line(&[0xff, b'\n']), "\u{fffd}\n");
    }

    #[test]
    fn filters_that_can_not_be_read_are_refused() {
        for text in ["info", "warn,server::queue=debug", "off"] {
            assert!(text.parse::<LogFilter>().is_ok(), "{text}");
        }
        for text in ["server=loud", "info,=x="] {
            assert!(text.parse::<LogFilter>().is_err(), "{text}");
        }
    }
}
