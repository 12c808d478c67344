//! Text as it may reach a terminal: all that people read of the program passes here, and nothing in it can command the terminal.
//!
//! Names come from documents, recordings, databases and other machines. Whatever is hidden in them is written out, but for the ends of lines, of which most are ours:
//! what lays out a line of names that may hold one calls [`visible`](document::visible::visible).

use document::visible::push_visible;

use crate::cli::terminal::paint::command;

/// The text with its styles as a terminal's commands, and with no other.
pub(crate) fn shown(text: &str) -> String {
    rendered(text, command)
}

/// The text without its styles.
pub(crate) fn plain(text: &str) -> String {
    rendered(text, |mark| command(mark).map(|_| String::new()))
}

fn rendered(text: &str, style: impl Fn(char) -> Option<String>) -> String {
    let mut rendered = String::with_capacity(text.len());
    for c in text.chars() {
        match style(c) {
            Some(command) => rendered.push_str(&command),
            None if c == '\n' => rendered.push(c),
            None => push_visible(&mut rendered, c),
        }
    }
    rendered
}

#[cfg(test)]
mod tests {
    use anstyle::Style;

    use super::*;
    use crate::cli::terminal::paint::{BAD, header, left, painted};

    #[test]
    fn no_command_passes_but_those_of_styles() {
        let name = "F\u{1b}]0;x\u{7}\u{1b}[1m\u{9b}2J\u{202e}z\r\u{2066}";
        let seen = shown(&format!("{}\n{name}", painted(BAD, name)));
        let (first, second) = seen.split_once('\n').expect("two lines");
        let inner = first.strip_prefix("\u{1b}[31m").expect("red");
        let inner = inner.strip_suffix("\u{1b}[0m").expect("until its end");
        for text in [inner, second] {
            assert_eq!(
                text,
                "F\\u{1b}]0;x\\u{7}\\u{1b}[1m\\u{9b}2J\\u{202e}z\\u{d}\\u{2066}"
            );
        }
        assert_eq!(plain(&painted(BAD, name)), second);
    }

    #[test]
    fn columns_are_as_wide_as_what_is_seen_of_them() {
        let cell = left(BAD, "Größe", 8);
        assert_eq!(shown(&cell), "\u{1b}[31mGröße\u{1b}[0m   ");
        assert_eq!(plain(&cell), "Größe   ");
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
            painted
                .lines()
                .all(|line| shown(line).ends_with("\u{1b}[0m")),
            "{painted:?}"
        );
        assert_eq!(plain(&painted), "a\nb\n");
    }
}
