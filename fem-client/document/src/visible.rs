//! Texts of users, safe to show.

/// A text whose hidden characters are written out: they could forge lines of a log, or make a terminal or a page show another text than is there.
pub fn visible(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        push_visible(&mut shown, c);
    }
    shown
}

/// Adds a character, written out where it is hidden.
pub fn push_visible(shown: &mut String, c: char) {
    if is_hidden(c) {
        shown.extend(c.escape_unicode());
    } else {
        shown.push(c);
    }
}

/// Whether a character isn't seen itself and changes how others are: controls, ends of lines, what turns the direction of a text or hides in it, and what Unicode
/// keeps for inside a program. Joiners, which some scripts and emoji need, change no order and stay.
pub fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{61c}' | '\u{200b}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
            | '\u{fdd0}'..='\u{fdef}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_seen_stays_and_what_hides_is_written_out() {
        for seen in ["Größe μm · 轮胎", "e\u{301}", "क्\u{200d}ष", "a\u{a0}b"] {
            assert_eq!(visible(seen), seen);
        }
        for (hidden, shown) in [
            ("a\u{1b}[2J", "a\\u{1b}[2J"),
            ("\u{9b}31m\u{7f}", "\\u{9b}31m\\u{7f}"),
            ("a\u{202e}cba\u{2066}", "a\\u{202e}cba\\u{2066}"),
            ("a\nb\u{2028}c", "a\\u{a}b\\u{2028}c"),
            ("\u{fdd1}\u{e0041}", "\\u{fdd1}\\u{e0041}"),
        ] {
            assert_eq!(visible(hidden), shown);
        }
    }
}
