//! Cells of CSV files: quoted as RFC 4180 asks, and such that no spreadsheet takes a name for a formula.
//!
//! A spreadsheet computes what begins with one of `STARTS`, and a formula can open addresses and start programs. OWASP's advice is an apostrophe in front, which spreadsheets take
//! for "this is text" and don't show. A number stays one.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

/// Begins of formulas, and white space that a spreadsheet takes off before it looks.
const STARTS: [char; 7] = ['=', '+', '-', '@', '\t', '\r', '\n'];

/// The cell of a text, as it stands in a file.
pub fn cell(text: &str) -> String {
    let shield = if is_formula(text) { "'" } else { "" };
    // Where the comma is the decimal sign, a semicolon parts cells.
    if text.contains([',', ';', '\t', '"', '\n', '\r']) {
        format!("\"{shield}{}\"", text.replace('"', "\"\""))
    } else {
        format!("{shield}{text}")
    }
}

/// The line of these texts, a cell each.
pub fn line<'t>(texts: impl IntoIterator<Item = &'t String>) -> String {
    let cells: Vec<String> = texts.into_iter().map(|text| cell(text)).collect();
    cells.join(",") + "\n"
}

/// The text of a cell, its quotes gone: the other way of [`cell`].
pub(super) fn text(cell: &str) -> &str {
    let shielded = cell.strip_prefix('\'').filter(|text| is_formula(text));
    shielded.unwrap_or(cell)
}

/// Apostrophes in front are left aside, so that a text which has one of its own reads back with it.
fn is_formula(text: &str) -> bool {
    text.trim_start_matches('\'').starts_with(STARTS) && text.parse::<f64>().is_err()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_spreadsheet_would_run_is_text_and_reads_back_the_same() {
        for (name, written) in [
            ("=HYPERLINK(A1)", "'=HYPERLINK(A1)"),
            ("=cmd|'/c calc'!A1,b", "\"'=cmd|'/c calc'!A1,b\""),
            ("+a", "'+a"),
            ("-a", "'-a"),
            ("@sum", "'@sum"),
            ("\t=1", "\"'\t=1\""),
            ("'=1", "''=1"),
            ("a;=1", "\"a;=1\""),
            ("plain", "plain"),
            ("'quoted'", "'quoted'"),
            ("-2.5e-3", "-2.5e-3"),
            ("+1", "+1"),
            ("-inf", "-inf"),
            ("", ""),
        ] {
            assert_eq!(cell(name), written);
            let unquoted = written.trim_matches('"').replace("\"\"", "\"");
            assert_eq!(text(&unquoted), name, "{written}");
        }
    }
}
