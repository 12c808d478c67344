//! Colours and emphasis of what people read: always beside a word or a sign that says the same.
//!
//! Where a style begins and ends stands in the text as a character that Unicode keeps for inside a program; [`shown`](super::shown::shown) puts a terminal's commands in
//! their place, and lets no others through. Cells are padded by what is seen of them, so that columns line up either way.

use std::fmt::Display;

use anstyle::{AnsiColor, Reset, Style};

/// A table's header, or a title.
pub(crate) const HEADER: Style = Style::new().bold();
/// Style of what can be relied on: certain ranks, real differences.
pub(crate) const STRONG: Style = Style::new().bold();
/// Style of what can't: uncertain ranks, differences within their error.
pub(crate) const FAINT: Style = Style::new().dimmed();
/// Style of what is done or passed.
pub(crate) const GOOD: Style = AnsiColor::Green.on_default();
/// Style of what failed.
pub(crate) const BAD: Style = AnsiColor::Red.on_default();
/// Style of what is to be looked at.
pub(crate) const WARNING: Style = AnsiColor::Yellow.on_default();

/// Styles, each with the mark where it begins.
const MARKS: [(char, Style); 5] = [
    ('\u{fdd0}', STRONG),
    ('\u{fdd1}', FAINT),
    ('\u{fdd2}', GOOD),
    ('\u{fdd3}', BAD),
    ('\u{fdd4}', WARNING),
];
/// The mark where any of them ends.
const END: char = '\u{fddf}';

/// The text in this style.
pub fn painted(style: Style, text: impl Display) -> String {
    let begin = MARKS.iter().find(|(_, known)| *known == style);
    match begin {
        Some((begin, _)) => format!("{begin}{text}{END}"),
        None => text.to_string(),
    }
}

/// Returns the terminal's command that a mark stands for.
pub(crate) fn command(mark: char) -> Option<String> {
    if mark == END {
        return Some(Reset.to_string());
    }
    let begun = MARKS.iter().find(|(begin, _)| *begin == mark);
    begun.map(|(_, style)| style.to_string())
}

/// The text in this style, at the left of a column.
pub fn left(style: Style, text: &str, width: usize) -> String {
    format!(
        "{}{:rest$}",
        painted(style, text),
        "",
        rest = width.saturating_sub(text.chars().count())
    )
}

/// Each line of a header in its style: a pager that shows a part of them shows it right.
pub fn header(lines: &str) -> String {
    lines
        .split_inclusive('\n')
        .map(|line| match line.strip_suffix('\n') {
            Some(line) => painted(HEADER, line) + "\n",
            None => painted(HEADER, line),
        })
        .collect()
}

/// Returns the style of a study's state.
pub(crate) fn of_state(state: &str) -> Style {
    match state {
        "done" => GOOD,
        "failed" => BAD,
        "cancelled" => WARNING,
        "running" => STRONG,
        _ => FAINT,
    }
}
