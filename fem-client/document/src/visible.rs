//! Texts of users, safe to show.

/// A text whose control characters are written out: they could forge lines of a log, or move a terminal's cursor.
pub fn visible(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_control() {
            shown.extend(c.escape_unicode());
        } else {
            shown.push(c);
        }
    }
    shown
}
