//! A recording from its text: a header, then a row a line.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use ndarray::Array2;
use std::borrow::Cow;

use crate::recipe::Columns;
use crate::recipe::column_names::LONGEST_NAME;
use crate::recording::Recording;
use crate::recording::csv_line::{cells, is_number, number};
use crate::recording::named_columns::NamedColumns;
use crate::recording::recording_fault::{FaultKind, FaultList, RecordingFault};
use crate::recording::row_reader::{Row, RowReader};

/// Most columns of a file.
pub const MOST_COLUMNS: usize = 4096;
const TOO_LONG: usize = LONGEST_NAME + 1;

/// The names in a file's header.
///
/// # Errors
/// A file without a line; a name that is empty or stands twice.
pub fn header(file: &str, text: &str) -> Result<Vec<String>, Vec<RecordingFault>> {
    let mut faults = FaultList::of(file);
    let first = lines(text).next().map(|(_, line)| line).unwrap_or_default();
    let names = header_names(first, &mut faults);
    if faults.is_empty() {
        Ok(names)
    } else {
        Err(faults.into_faults())
    }
}

/// The names in a header's line, with a fault for each that is no name of its own.
pub fn header_names(line: &str, faults: &mut FaultList) -> Vec<String> {
    if line.trim().is_empty() {
        faults.add(
            Some(1),
            None,
            "is missing: the first line names the columns, as time_s,s1,s2,fz_n",
        );
        return Vec::new();
    }
    let names: Vec<String> = match cells(line, MOST_COLUMNS) {
        Ok(cells) => cells.into_iter().map(Cow::into_owned).collect(),
        Err(count) => {
            let detail = format!("has {count} columns; at most {MOST_COLUMNS} are read");
            faults.add(Some(1), None, detail);
            return Vec::new();
        }
    };
    if names.len() < 2 && line.contains([';', '\t']) {
        faults.add(
            Some(1),
            None,
            "has one column: columns are separated by commas",
        );
        return names;
    }
    if names.iter().all(|name| is_number(name)) {
        let detail = "is a row of numbers: write a line above it that names the columns, as time_s,s1,s2,fz_n";
        faults.add(Some(1), None, detail);
        return names;
    }
    let mut seen = std::collections::HashSet::new();
    for (at, name) in names.iter().enumerate() {
        let what = match name.chars().count() {
            0 => "has no name",
            TOO_LONG.. => {
                let detail = format!(
                    "column {} has a name of more than {LONGEST_NAME} characters",
                    at + 1
                );
                faults.add(Some(1), None, detail);
                continue;
            }
            _ if !seen.insert(name) => "stands twice",
            _ => continue,
        };
        faults.add(Some(1), Some(name), format!("column {} {what}", at + 1));
    }
    names
}

/// Lines with their numbers, without those that are blank.
pub fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.trim_start_matches('\u{feff}');
    let numbered = text.lines().enumerate().map(|(at, line)| (at + 1, line));
    numbered.filter(|(_, line)| !line.trim().is_empty())
}

/// Reads a whole file, whose columns were found by [`NamedColumns::find`]. `gaps` lets signals be empty.
///
/// # Errors
/// Every fault with its line and column, up to a bound: missing columns, ragged rows, text, numbers that aren't finite, time that doesn't rise.
pub fn read(
    file: &str,
    text: &str,
    columns: &Columns,
    names: &NamedColumns,
    gaps: bool,
) -> Result<Recording, Vec<RecordingFault>> {
    read_checked(file, text, names, gaps, |header, faults| {
        names.check(columns, header, faults);
    })
}

/// Reads a whole file as [`read`] does, which may lack every force: one that forces are to be estimated of.
///
/// # Errors
/// Every fault, as of [`read`].
pub fn read_for_look(
    file: &str,
    text: &str,
    columns: &Columns,
    names: &NamedColumns,
    gaps: bool,
) -> Result<Recording, Vec<RecordingFault>> {
    read_checked(file, text, names, gaps, |header, faults| {
        if names.among(header).forces.is_empty() {
            names.check_without_forces(columns, header, faults);
        } else {
            names.check(columns, header, faults);
        }
    })
}

fn read_checked(
    file: &str,
    text: &str,
    names: &NamedColumns,
    gaps: bool,
    check: impl FnOnce(&[String], &mut FaultList),
) -> Result<Recording, Vec<RecordingFault>> {
    let header = header(file, text)?;
    let mut faults = FaultList::of(file);
    check(&header, &mut faults);
    if faults.is_full() {
        return Err(faults.into_faults());
    }
    // Rows are read without the columns that are missing: all faults are told at once.
    rows(text, &names.among(&header), &header, gaps, faults)
}

/// Reads the rows below a header that has all of these columns. `gaps` lets signals be empty.
///
/// # Errors
/// Every fault, as of [`read`].
pub fn read_rows(
    file: &str,
    text: &str,
    names: &NamedColumns,
    header: &[String],
    gaps: bool,
) -> Result<Recording, Vec<RecordingFault>> {
    rows(text, names, header, gaps, FaultList::of(file))
}

fn rows(
    text: &str,
    names: &NamedColumns,
    header: &[String],
    gaps: bool,
    mut faults: FaultList,
) -> Result<Recording, Vec<RecordingFault>> {
    let Some(reader) = RowReader::new(names, header, gaps) else {
        return Err(faults.into_faults());
    };
    let mut rows = GatheredRows::default();
    let mut before: Option<f64> = None;
    for (number, line) in lines(text).skip(1) {
        if faults.is_full() {
            break;
        }
        let Some(row) = reader.row(number, line, &mut faults) else {
            continue;
        };
        check_time(row.time_s, before, number, &names.time, &mut faults);
        before = Some(row.time_s);
        // Of a file with faults nothing is kept.
        if faults.is_empty() {
            rows.push(row);
        }
    }
    if rows.time_s.is_empty() && faults.is_empty() {
        faults.add(None, None, "has no row below its header");
    }
    let file = faults.file().to_owned();
    faults.or(|| rows.recording(&file, names))
}

/// The number in the first row's column of time, as it stands; `None` of a date or a clock's time, or where there is none.
pub fn first_time(text: &str, header: &[String], names: &NamedColumns) -> Option<f64> {
    let at = header.iter().position(|name| *name == names.time)?;
    let (_, line) = lines(text).nth(1)?;
    number(cells(line, MOST_COLUMNS).ok()?.get(at)?).ok()?
}

/// Counts the rows below a header, those that are faulty too.
pub fn rows_below_header(text: &str) -> usize {
    lines(text).skip(1).count()
}

/// Shortest time between rows, s: slopes over less mean nothing.
pub const SHORTEST_S: f64 = 1e-9;

/// A fault where time doesn't rise.
pub fn check_time(
    time_s: f64,
    before: Option<f64>,
    line: usize,
    column: &str,
    faults: &mut FaultList,
) {
    if let Some(before) = before.filter(|before| time_s - before < SHORTEST_S) {
        let mend = if (time_s - before).abs() < SHORTEST_S {
            "delete one of the two rows"
        } else {
            "sort the rows, or, where the clock began anew, give what follows as a file of its own"
        };
        let detail = format!("time must rise from row to row; {time_s} follows {before}: {mend}");
        faults.add_like(FaultKind::Time, line, Some(column), detail);
    }
}

/// Numbers of cycles: one more with each change of the column that tells them apart.
#[derive(Debug, Clone, Default)]
pub struct CycleNumbers {
    number: usize,
    last: Option<String>,
}

impl CycleNumbers {
    /// Returns the number of the next row's cycle.
    pub fn next(&mut self, name: String) -> usize {
        if self.last.as_ref().is_some_and(|last| *last != name) {
            self.number += 1;
        }
        self.last = Some(name);
        self.number
    }
}

/// Rows side by side, with no list of their own for each.
#[derive(Default)]
struct GatheredRows {
    time_s: Vec<f64>,
    signals: Vec<f64>,
    forces: Vec<f64>,
    /// Cycle of each row: a number that grows where the column of cycles changes. Empty without such a column.
    cycle: Vec<usize>,
    cycles: CycleNumbers,
}

impl GatheredRows {
    fn push(&mut self, row: Row) {
        self.time_s.push(row.time_s);
        self.signals.extend(row.signals);
        self.forces.extend(row.forces);
        if let Some(name) = row.cycle {
            self.cycle.push(self.cycles.next(name));
        }
    }

    fn recording(self, file: &str, names: &NamedColumns) -> Option<Recording> {
        let rows = self.time_s.len();
        let shape = |columns: &Vec<String>| (rows, columns.len());
        Some(Recording {
            name: file.to_owned(),
            signals: Array2::from_shape_vec(shape(&names.signals), self.signals).ok()?,
            forces: Array2::from_shape_vec(shape(&names.forces), self.forces).ok()?,
            time_s: self.time_s,
            cycle: names.cycle.as_ref().map(|_| self.cycle),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> NamedColumns {
        NamedColumns {
            time: "t".to_owned(),
            signals: vec!["a".to_owned(), "b".to_owned()],
            forces: vec!["fz".to_owned()],
            cycle: Some("c".to_owned()),
            time_unit: None,
            converted: Vec::new(),
        }
    }

    fn whole(text: &str, gaps: bool) -> Result<Recording, Vec<RecordingFault>> {
        read("r.csv", text, &Columns::default(), &names(), gaps)
    }

    #[test]
    fn a_recording_is_read_with_its_gaps_and_cycles() {
        let text =
            "\u{feff}t,b,note,a,fz,c\r\n0,1,x,2,,one\r\n\r\n0.5,3,y,4,-1.5,one\r\n1,5,,6,2,two\r\n";
        let read = whole(text, false).expect("reads");
        assert_eq!(read.time_s, [0.0, 0.5, 1.0]);
        assert_eq!(
            read.signals,
            ndarray::array![[2.0, 1.0], [4.0, 3.0], [6.0, 5.0]]
        );
        assert!(read.forces[[0, 0]].is_nan());
        assert_eq!(read.forces[[1, 0]], -1.5);
        assert_eq!(read.cycle, Some(vec![0, 0, 1]));
        assert_eq!(read.labelled(), 2);
        assert_eq!(read.interval_s(), Some(0.5));
    }

    #[test]
    fn every_fault_has_its_line_and_column() {
        let text = "t,a,b,fz,c\n0,1,2,3,1\n0,1,2,3,1\n1,1,2\n2,x,nan,inf,1\n3,,2,,1\n";
        let faults = whole(text, false).expect_err("faults");
        let told: Vec<String> = faults.iter().map(ToString::to_string).collect();
        let expected = [
            "r.csv, line 3, column t: time must rise",
            "r.csv, line 4: has 3 cells; the header has 5",
            "r.csv, line 5, column a: must be a finite number; it is \"x\"; text is left out by not_signals = [\"a\"]",
            "r.csv, line 5, column b: is empty",
            "r.csv, line 5, column fz: must be a finite number; it is \"inf\"",
            "r.csv, line 6, column a: is empty",
        ];
        assert_eq!(told.len(), expected.len(), "{told:?}");
        for (told, expected) in told.iter().zip(expected) {
            assert!(told.starts_with(expected), "{told}");
        }
        let gaps = "t,a,b,fz,c\n3,,2,,1\n";
        assert!(whole(gaps, true).expect("reads").signals[[0, 0]].is_nan());
    }

    #[test]
    fn headers_are_checked() {
        for (text, part) in [
            ("", "is missing"),
            ("a;b\n1;2", "separated by commas"),
            ("t,,a\n", "column 2 has no name"),
            ("t,a,a\n", "column 3 stands twice"),
        ] {
            let faults = header("r.csv", text).expect_err(text);
            assert!(faults[0].detail.contains(part), "{}", faults[0].detail);
        }
        let empty = whole("t,a,b,fz,c\n", false).expect_err("no row");
        assert!(empty[0].detail.contains("no row"));
        let missing = whole("t,a,fz,c\n0,1,2,3\n", false).expect_err("missing");
        assert!(
            missing[0].to_string().contains("column b"),
            "{}",
            missing[0]
        );
        let many = format!("t,a,b,fz,c\n{}", "x\n".repeat(1000));
        let alike = whole(&many, false).expect_err("many");
        assert_eq!(alike.len(), 1);
        assert!(
            alike[0]
                .to_string()
                .ends_with("(also lines 3, 4, 5, 6 and 995 more)"),
            "{}",
            alike[0]
        );
        let numbers = header("r.csv", "0.0,1.5\n0.1,2.5\n").expect_err("no names");
        assert!(
            numbers[0].detail.contains("is a row of numbers"),
            "{}",
            numbers[0]
        );
    }
}
