//! The cells of one line of a CSV file (RFC 4180, without line breaks in cells).

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::borrow::Cow;

/// Splits a line at its commas; quoted cells keep theirs. Spaces around a cell go.
///
/// # Errors
/// The number of cells, where there are more than `most`: nothing is kept of them.
pub fn cells(line: &str, most: usize) -> Result<Vec<Cow<'_, str>>, usize> {
    let mut found = Vec::new();
    let (mut begin, mut quoted, mut count) = (0, false, 1);
    for (at, byte) in line.bytes().enumerate() {
        match byte {
            b'"' => quoted = !quoted,
            b',' if !quoted => {
                if count <= most {
                    found.push(cell(line.get(begin..at).unwrap_or_default()));
                }
                count += 1;
                begin = at + 1;
            }
            _ => {}
        }
    }
    if count > most {
        return Err(count);
    }
    found.push(cell(line.get(begin..).unwrap_or_default()));
    Ok(found)
}

fn cell(text: &str) -> Cow<'_, str> {
    let text = text.trim();
    match text
        .strip_prefix('"')
        .and_then(|text| text.strip_suffix('"'))
    {
        Some(inner) if inner.contains("\"\"") => Cow::Owned(inner.replace("\"\"", "\"")),
        Some(inner) => Cow::Borrowed(inner),
        None => Cow::Borrowed(text),
    }
}

/// A name as a cell of a header.
pub(super) fn quoted(name: &str) -> Cow<'_, str> {
    if name.contains([',', '"', '\n', '\r']) {
        Cow::Owned(format!("\"{}\"", name.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(name)
    }
}

/// Largest number: beyond, squares and slopes wouldn't be finite.
const LARGEST: f64 = 1e100;

/// Words for what wasn't measured.
const NOTHING: [&str; 7] = ["nan", "na", "n/a", "null", "none", "-", "--"];

/// Whether a cell is a number.
pub(super) fn is_number(cell: &str) -> bool {
    matches!(number(cell), Ok(Some(_)))
}

/// The number of a cell; None where it is empty, or says that nothing was measured.
///
/// # Errors
/// A sentence when it is no finite number, or one beyond 1e100.
pub fn number(cell: &str) -> Result<Option<f64>, String> {
    if cell.is_empty() || NOTHING.iter().any(|word| cell.eq_ignore_ascii_case(word)) {
        return Ok(None);
    }
    match cell.parse::<f64>() {
        Ok(x) if x.abs() <= LARGEST => Ok(Some(x)),
        _ => {
            let shown: String = cell.chars().take(40).collect();
            Err(format!("must be a finite number; it is {shown:?}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_what_stands_between_commas() {
        let cells = |line| cells(line, 4).map(|cells| cells.join("|"));
        assert_eq!(
            cells("a, b ,,\"c, \"\"d\"\"\""),
            Ok("a|b||c, \"d\"".to_owned())
        );
        assert_eq!(cells(""), Ok(String::new()));
        assert_eq!(cells("\"open, 1"), Ok("\"open, 1".to_owned()));
        assert_eq!(cells(",,,,,"), Err(6));
        let name = "c, \"d\"";
        assert_eq!(cells(&quoted(name)), Ok(name.to_owned()));
    }

    #[test]
    fn only_finite_numbers_are_numbers() {
        assert_eq!(number("-1.5e3"), Ok(Some(-1500.0)));
        for nothing in ["", "NaN", "nan", "NA", "null", "None", "-"] {
            assert_eq!(number(nothing), Ok(None), "{nothing}");
        }
        for wrong in ["inf", "1e999", "-1e101", "0x1", "1,5", "one"] {
            assert!(number(wrong).is_err(), "{wrong}");
        }
    }
}
