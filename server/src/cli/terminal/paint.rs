//! Colours and emphasis of what people read: always beside a word or a sign that says the same.
//!
//! Text is painted as if for a terminal; [`tell`](super::output::tell) and [`warn`](super::output::warn) take the paint off where it goes elsewhere. Cells are padded
//! by what is seen of them, so that columns line up either way.

use std::fmt::Display;

use anstyle::{AnsiColor, Style};

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

/// The text in this style.
pub fn painted(style: Style, text: impl Display) -> String {
    format!("{style}{text}{style:#}")
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_what_is_seen_of_them() {
        let cell = left(BAD, "Größe", 8);
        assert!(
            cell.starts_with('\u{1b}') && cell.ends_with("   "),
            "{cell:?}"
        );
        assert_eq!(anstream::adapter::strip_str(&cell).to_string(), "Größe   ");
        assert_eq!(
            left(Style::new(), "a", 3),
            "a  ",
            "what has no style has no escapes"
        );
        assert_eq!(left(BAD, "long", 2), painted(BAD, "long"));
    }

    #[test]
    fn every_line_of_a_header_ends_its_own_style() {
        let painted = header("a\nb\n");
        assert_eq!(painted.lines().count(), 2);
        assert!(
            painted.lines().all(|line| line.ends_with("\u{1b}[0m")),
            "{painted:?}"
        );
        assert_eq!(anstream::adapter::strip_str(&painted).to_string(), "a\nb\n");
    }
}
