//! Files as loggers write them, brought to the one form that is read: commas between cells, points in numbers, a header above the rows.
//!
//! Lines keep their numbers, so that a fault says where it is in the file: what goes leaves a blank line.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::borrow::Cow;

use crate::recording::csv_line::quoted;
use crate::recording::csv_recording::MOST_COLUMNS;

/// Rows below a header that show a file's form.
const SHOWN: usize = 8;
/// Separators, the usual one first. Spaces count as one, and only where nothing else separates: names and dates have them, too.
const SEPARATORS: [char; 4] = [',', ';', '\t', ' '];
/// Name of a column without one that numbers the rows.
const INDEX: &str = "index";

/// Form of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Form {
    separator: char,
    /// Whether numbers have a comma for their point.
    has_decimal_commas: bool,
    /// Whether each row ends with a separator that no column follows.
    has_trailing: bool,
    /// Whether the first row below the header names units.
    has_units: bool,
}

/// Text of a file in the usual form; the text itself where that is its form.
pub fn usual(text: &str) -> Cow<'_, str> {
    let text = text.trim_start_matches('\u{feff}');
    let has_usual_ends = text.contains('\n');
    let end = if has_usual_ends { '\n' } else { '\r' };
    // The end of the last line begins no other one.
    let whole = text.strip_suffix(end).unwrap_or(text);
    let lines = || whole.split(end).map(|line| line.trim_end_matches('\r'));
    let is_comment = |line: &&str| line.trim_start().starts_with(['#', '%']);
    let is_data = |line: &&str| !line.trim().is_empty() && !is_comment(line);
    let shown: Vec<&str> = lines().filter(is_data).take(SHOWN).collect();
    let Some((header, rows)) = shown.split_first() else {
        return Cow::Borrowed(text);
    };
    // What has so many cells is refused as it stands.
    if shown.iter().any(|line| is_long(line)) {
        return Cow::Borrowed(text);
    }
    let Some(form) = Form::of(header, rows) else {
        return Cow::Borrowed(text);
    };
    let is_plain = form == Form::USUAL && !header.starts_with(',');
    if is_plain && has_usual_ends && !lines().any(|line| is_comment(&line)) {
        return Cow::Borrowed(text);
    }
    let mut below = 0;
    let mut usual = String::with_capacity(text.len());
    for line in lines() {
        if is_data(&line) {
            match below {
                0 => usual.push_str(&form.header(line)),
                1 if form.has_units => {}
                _ if is_long(line) => usual.push_str(line),
                _ => usual.push_str(&form.row(line)),
            }
            below += 1;
        }
        usual.push('\n');
    }
    Cow::Owned(usual)
}

impl Form {
    const USUAL: Self = Self {
        separator: ',',
        has_decimal_commas: false,
        has_trailing: false,
        has_units: false,
    };

    /// The form in which header and rows have the same number of cells, two or more; `None` where none does.
    fn of(header: &str, rows: &[&str]) -> Option<Self> {
        let forms = SEPARATORS.iter().filter_map(|separator| {
            let width = split(header, *separator).len();
            let widths = || rows.iter().map(|row| split(row, *separator).len());
            let ends_empty = |row: &&str| {
                let cells = split(row, *separator);
                cells.last().is_some_and(|cell| cell.is_empty())
            };
            let is_even = widths().all(|found| found == width);
            let all_end_empty = rows.iter().all(ends_empty);
            let header_ends_empty = ends_empty(&header);
            let has_trailing = all_end_empty
                && !rows.is_empty()
                && (header_ends_empty && is_even || widths().all(|found| found == width + 1));
            (width > 1 && (is_even || has_trailing)).then_some((*separator, has_trailing))
        });
        let (separator, has_trailing) = forms.into_iter().next()?;
        let cells = |row: &&str| split(row, separator);
        let numeric = |row: &&str| cells(row).iter().filter(|cell| is_number(cell)).count();
        let has_units = match rows {
            [first, second, ..] => numeric(first) == 0 && numeric(second) > 0,
            _ => false,
        };
        let data = rows.iter().skip(usize::from(has_units));
        let all: Vec<String> = data.flat_map(cells).collect();
        let has_decimal_commas = all.iter().any(|cell| is_comma_number(cell))
            && !all.iter().any(|cell| cell.contains('.') && is_number(cell));
        Some(Self {
            separator,
            has_decimal_commas,
            has_trailing,
            has_units,
        })
    }

    fn cells(&self, line: &str) -> Vec<String> {
        let mut cells = split(line, self.separator);
        if self.has_trailing && cells.last().is_some_and(String::is_empty) {
            cells.pop();
        }
        cells
    }

    fn header(&self, line: &str) -> String {
        let mut names = self.cells(line);
        if let Some(first) = names.first_mut().filter(|first| first.is_empty()) {
            INDEX.clone_into(first);
        }
        joined(&names)
    }

    fn row(&self, line: &str) -> String {
        let mut cells = self.cells(line);
        for cell in &mut cells {
            if self.has_decimal_commas && is_comma_number(cell) {
                *cell = cell.replacen(',', ".", 1);
            }
        }
        joined(&cells)
    }
}

/// Whether a line has more separators than a file may have columns.
fn is_long(line: &str) -> bool {
    line.matches(SEPARATORS).nth(MOST_COLUMNS).is_some()
}

fn joined(cells: &[String]) -> String {
    let cells: Vec<Cow<'_, str>> = cells.iter().map(|cell| quoted(cell)).collect();
    cells.join(",")
}

/// Cells of a line, without the spaces around them and their quotes.
fn split(line: &str, separator: char) -> Vec<String> {
    let (mut cells, mut cell, mut is_quoted) = (Vec::new(), String::new(), false);
    let mut letters = line.chars().peekable();
    let is_spaced = separator == ' ';
    while let Some(letter) = letters.next() {
        match letter {
            '"' if is_quoted && letters.peek() == Some(&'"') => {
                cell.push('"');
                letters.next();
            }
            '"' => is_quoted = !is_quoted,
            ' ' if is_spaced && !is_quoted && (cell.is_empty() || letters.peek() == Some(&' ')) => {
            }
            letter if letter == separator && !is_quoted => {
                cells.push(std::mem::take(&mut cell).trim().to_owned());
            }
            letter => cell.push(letter),
        }
    }
    if !(is_spaced && cell.trim().is_empty()) {
        cells.push(cell.trim().to_owned());
    }
    cells
}

fn is_number(cell: &str) -> bool {
    cell.parse::<f64>().is_ok() || is_comma_number(cell)
}

/// `0,050`, `-1,5e3`: a number with one comma between digits, and no point.
fn is_comma_number(cell: &str) -> bool {
    let Some((whole, part)) = cell.split_once(',') else {
        return false;
    };
    let digits = whole.trim_start_matches(['-', '+']);
    let is_whole = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    let begins = part
        .bytes()
        .next()
        .is_some_and(|byte| byte.is_ascii_digit());
    is_whole
        && begins
        && !part.contains(['.', ','])
        && format!("{whole}.{part}").parse::<f64>().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "time_s,s1,fz_n\n0.0,1.5,2.5\n0.1,-1.25,3.0\n";

    #[test]
    fn other_forms_become_the_usual_one() {
        assert!(matches!(usual(GOOD), Cow::Borrowed(GOOD)));
        let cases = [
            ("semicolons", "time_s;s1;fz_n\n0.0;1.5;2.5\n0.1;-1.25;3.0\n"),
            (
                "decimal commas",
                "time_s;s1;fz_n\n0,0;1,5;2,5\n0,1;-1,25;3,0\n",
            ),
            (
                "quoted ones",
                "time_s,s1,fz_n\n\"0,0\",\"1,5\",\"2,5\"\n\"0,1\",\"-1,25\",\"3,0\"\n",
            ),
            ("tabs", "time_s\ts1\tfz_n\n0.0\t1.5\t2.5\n0.1\t-1.25\t3.0\n"),
            (
                "spaces",
                "time_s s1 fz_n\n0.0   1.5 2.5\n 0.1 -1.25  3.0 \n",
            ),
            ("old Macs", "time_s,s1,fz_n\r0.0,1.5,2.5\r0.1,-1.25,3.0"),
            (
                "a comma more",
                "time_s,s1,fz_n\n0.0,1.5,2.5,\n0.1,-1.25,3.0,\n",
            ),
            (
                "in the header, too",
                "time_s,s1,fz_n,\n0.0,1.5,2.5,\n0.1,-1.25,3.0,\n",
            ),
        ];
        for (what, text) in cases {
            assert_eq!(usual(text), GOOD, "{what}");
        }
    }

    #[test]
    fn what_goes_leaves_its_line() {
        let text = "# rig 3\ntime_s,s1,fz_n\ns,V,N\n0.0,1.5,NaN\n\n0.1,-1.25,n/a\n";
        assert_eq!(
            usual(text),
            "\ntime_s,s1,fz_n\n\n0.0,1.5,NaN\n\n0.1,-1.25,n/a\n"
        );
        assert_eq!(usual(",a,b\n0,1,2\n1,2,3\n"), "index,a,b\n0,1,2\n1,2,3\n");
    }

    #[test]
    fn what_has_no_form_or_two_stays() {
        // Thousands or decimals, ragged rows, a name with a comma.
        for text in [
            "",
            "one\n",
            "a;b\n1.234,5;2\n",
            "a,b\n1,2,3\n",
            "\"a, V\",b\n1,2\n",
        ] {
            assert_eq!(
                usual(text).trim_end(),
                text.trim_end()
                    .replace("a;b\n1.234,5;2", "a,b\n\"1.234,5\",2")
            );
        }
    }
}
