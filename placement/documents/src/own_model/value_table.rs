//! Values of outputs by point, from a CSV file: header `id,<output names>`, then a row per point in any order. Columns named as inputs repeat
//! the plan, and so does a column `plan` of fingerprints: they are compared with it, and are no outputs.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::BTreeMap;

use document::fault::Fault;
use ndarray::Array2;

use crate::own_model::fingerprint::is_fingerprint;
use crate::own_model::planned_cells;
pub use crate::own_model::planned_cells::Planned;
use crate::own_model::printed_number::half_unit;
pub use crate::own_model::value_row::PLAN_COLUMN;
use crate::own_model::value_row::{Column, Place, ValueRow, cells, fault, read};

/// Points named in one sentence.
const MOST_NAMED: usize = 10;

/// Output names, and their values by point.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueTable {
    outputs: Vec<String>,
    /// rows by id
    rows: BTreeMap<usize, ValueRow>,
}

impl ValueTable {
    /// Makes a table of which nothing was run yet.
    pub fn empty() -> Self {
        Self {
            outputs: Vec::new(),
            rows: BTreeMap::new(),
        }
    }

    /// Makes a table of rows by point, with a value for each output.
    pub(super) fn of_rows(outputs: Vec<String>, rows: BTreeMap<usize, ValueRow>) -> Self {
        Self { outputs, rows }
    }

    /// Reads the text of a file, all of whose columns are outputs. An empty cell, `nan` and infinities are runs that failed.
    ///
    /// # Errors
    /// Every fault, with its line.
    pub fn from_csv(text: &str) -> Result<Self, Vec<Fault>> {
        Self::of_model(text, &[])
    }

    /// Reads as [`ValueTable::from_csv`] does, of a model with these inputs: columns named as they are repeat the plan.
    ///
    /// # Errors
    /// As [`ValueTable::from_csv`].
    pub fn of_model(text: &str, inputs: &[String]) -> Result<Self, Vec<Fault>> {
        let mut faults = Vec::new();
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(i, line)| (i + 1, line.trim_start_matches('\u{feff}')))
            .filter(|(_, line)| !line.trim().is_empty())
            .peekable();
        let Some((number, header)) = lines.next() else {
            fault(
                &mut faults,
                1,
                "the file is empty; its first line is the header id,<output names>",
            );
            return Err(faults);
        };
        let mut names = cells(header);
        if names.first().map(String::as_str) != Some("id") || names.len() < 2 {
            fault(&mut faults, number, "the header must be id,<output names>");
            return Err(faults);
        }
        names.remove(0);
        let first = lines.peek().map_or("", |(_, line)| line);
        let columns = columns(&names, inputs, &cells(first));
        check_names((&names, &columns), number, &mut faults);
        let mut rows = BTreeMap::new();
        for (number, line) in lines {
            let Some((id, row)) = read(number, line, (&names, &columns), &mut faults) else {
                continue;
            };
            if let Some(Place::Line(line)) = rows.insert(id, row).map(|before| before.place) {
                let detail = format!("point {id} was given on line {line} already");
                fault(&mut faults, number, &detail);
            }
        }
        let pairs = names.into_iter().zip(columns);
        let outputs = pairs.filter(|(_, column)| *column == Column::Output);
        if faults.is_empty() {
            Ok(Self {
                outputs: outputs.map(|(name, _)| name).collect(),
                rows,
            })
        } else {
            Err(faults)
        }
    }

    /// Names of the outputs.
    pub fn outputs(&self) -> &[String] {
        &self.outputs
    }

    /// Counts the points that have values.
    pub fn points(&self) -> usize {
        self.rows.len()
    }

    /// Whether a point has its values.
    pub fn has(&self, id: usize) -> bool {
        self.rows.contains_key(&id)
    }

    /// The rows of points 0, 1, .. up to the first that is missing.
    pub fn leading_rows(&self) -> Array2<f64> {
        let leading = self.rows.iter().enumerate();
        let rows: Vec<&Vec<f64>> = leading
            .take_while(|(at, (id, _))| at == *id)
            .map(|(_, (_, row))| &row.values)
            .collect();
        // Every row has a value for each output.
        let mut table = Array2::from_elem((rows.len(), self.outputs.len()), f64::NAN);
        for (cell, value) in table.iter_mut().zip(rows.into_iter().flatten()) {
            *cell = *value;
        }
        table
    }

    /// Half a unit of the last digit that each output's values were printed with, where that is most; zero where they have all of a double's.
    pub fn half_units(&self) -> Vec<f64> {
        let of_output = |output: usize| {
            let rows = self.rows.values();
            let printed = rows.filter_map(|row| *row.printed.get(output)?);
            half_unit(&printed.collect::<Vec<_>>())
        };
        (0..self.outputs.len()).map(of_output).collect()
    }

    /// Points that nobody asked for are faults, and so are those that were run with other inputs or planned by another plan.
    ///
    /// # Errors
    /// Each of them, with its line and column; the first ones of a column.
    pub(super) fn check_plan(&self, plan: &Planned<'_>) -> Result<(), Vec<Fault>> {
        let mut faults = Vec::new();
        let points = plan.points.len();
        for (id, row) in self.rows.range(points..) {
            let detail = if points > 0 {
                format!(
                    "there is no point {id}: the plan has points 0 to {}",
                    points - 1
                )
            } else {
                format!("there is no point {id}")
            };
            row.place.fault(&mut faults, &detail);
        }
        // Lists have nothing but outputs.
        let repeated = self.rows.iter().filter_map(|(id, row)| match row.place {
            Place::Line(line) => Some((line, *id, &row.planned)),
            Place::Entry(_) => None,
        });
        faults.extend(planned_cells::faults(repeated, plan));
        if faults.is_empty() {
            Ok(())
        } else {
            Err(faults)
        }
    }

    /// Returns what is to be done about a table that lacks some of so many points.
    pub(super) fn missing_words(&self, points: usize) -> String {
        let missing: Vec<usize> = (0..points).filter(|id| !self.has(*id)).collect();
        let named: Vec<String> = missing
            .iter()
            .take(MOST_NAMED)
            .map(usize::to_string)
            .collect();
        let more = match missing.len().saturating_sub(MOST_NAMED) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        format!(
            "no values for points {}{more}: run them, or give nan for a run that failed",
            named.join(", ")
        )
    }
}

/// Meanings of the columns behind the id, of which `first` is the first row. A column `plan` without a fingerprint is an output of that name. One that is
/// named as an input is an output only where the file has nothing else and not all inputs: whoever keeps the plan's columns keeps all of them.
fn columns(names: &[String], inputs: &[String], first: &[String]) -> Vec<Column> {
    let cells = first
        .iter()
        .skip(1)
        .map(Some)
        .chain(std::iter::repeat(None));
    let of_name = |(name, cell): (&String, Option<&String>)| {
        if let Some(input) = inputs.iter().position(|input| input == name) {
            return Column::Input(input);
        }
        let planned = cell.is_some_and(|cell| is_fingerprint(cell));
        if name == PLAN_COLUMN && planned {
            return Column::Plan;
        }
        Column::Output
    };
    let columns: Vec<Column> = names.iter().zip(cells).map(of_name).collect();
    let repeats_all = (0..inputs.len()).all(|input| columns.contains(&Column::Input(input)));
    if repeats_all || columns.contains(&Column::Output) {
        return columns;
    }
    let as_output = |column| match column {
        Column::Input(_) => Column::Output,
        other => other,
    };
    columns.into_iter().map(as_output).collect()
}

/// Every column has a name of its own, and one of them is an output.
fn check_names((names, columns): (&[String], &[Column]), line: usize, faults: &mut Vec<Fault>) {
    for (i, name) in names.iter().enumerate() {
        if name.is_empty() || names.iter().take(i).any(|other| other == name) {
            let detail = format!("output {} has no name of its own: {name:?}", i + 1);
            fault(faults, line, &detail);
        }
    }
    if !columns.contains(&Column::Output) {
        let detail =
            "there is no output, only what was planned: the header must be id,<output names>";
        fault(faults, line, detail);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::own_model::csv_cell::cell;

    #[test]
    fn what_repeats_the_plan_is_no_output() {
        let inputs = ["a".to_owned(), "b".to_owned()];
        let text = "id,b,y,plan\n0,0.5,1.25,p01234567\n1,0.9,1.5,p01234567\n";
        let table = ValueTable::of_model(text, &inputs).unwrap();
        assert_eq!(table.outputs(), ["y"]);
        assert_eq!(table.leading_rows().dim(), (2, 1));
        assert!((table.half_units()[0] - 0.005).abs() < 1e-17);
        let points = [vec![0.1, 0.5], vec![0.1, 0.95]];
        let plan = |fingerprint| Planned {
            inputs: &inputs,
            points: &points,
            fingerprint,
        };
        assert!(table.check_plan(&plan("p01234567")).is_ok());
        assert_eq!(table.check_plan(&plan("p89abcdef")).unwrap_err().len(), 2);
        let numbers = ValueTable::of_model("id,plan\n0,1\n", &inputs).unwrap();
        assert_eq!(numbers.outputs(), ["plan"]);
        let faults = ValueTable::of_model("id,a,b\n0,1,1\n1,,1\n", &inputs).unwrap_err();
        let details: Vec<&str> = faults.iter().map(|fault| &fault.detail[..20]).collect();
        assert_eq!(details, ["line 1: there is no ", "line 3: column \"a\" m"]);
        let alone = ValueTable::of_model("id,a\n0,1\n1,\n", &inputs).unwrap();
        assert_eq!(alone.outputs(), ["a"]);
    }

    #[test]
    fn rows_come_in_any_order_and_failed_runs_are_kept() {
        let table =
            ValueTable::from_csv("id,\"force, N\",b\r\n2,1.5,\n0,nan,-2e-300\n\n1, 3 ,inf\n")
                .unwrap();
        assert_eq!(table.outputs(), ["force, N", "b"]);
        let rows = table.leading_rows();
        assert_eq!(rows.dim(), (3, 2));
        assert!(rows[[0, 0]].is_nan() && rows[[2, 1]].is_nan());
        assert_eq!((rows[[0, 1]], rows[[1, 0]]), (-2e-300, 3.0));
        let check = |points: &[Vec<f64>]| {
            table.check_plan(&Planned {
                inputs: &[],
                points,
                fingerprint: "",
            })
        };
        assert!(check(&vec![Vec::new(); 3]).is_ok());
        let faults = check(&vec![Vec::new(); 2]).unwrap_err();
        assert!(faults[0].detail.starts_with("line 2: there is no point 2"));
        for name in ["a,\"b\"", "=1+1", "'=1", "'a'", "-x,y"] {
            assert_eq!(cells(&cell(name)), [name]);
        }
    }

    #[test]
    fn every_fault_is_given_with_its_line() {
        let faults =
            ValueTable::from_csv("id,a,a\n0,1\nx,1,2\n1,2,three\n1,1,1\n1,1,1\n").unwrap_err();
        let lines: Vec<&str> = faults.iter().map(|f| &f.detail[..7]).collect();
        assert_eq!(
            lines,
            ["line 1:", "line 2:", "line 3:", "line 4:", "line 6:"]
        );
        for text in ["", "\n", "a,b\n0,1\n", "id\n0\n"] {
            assert!(ValueTable::from_csv(text).is_err(), "{text:?}");
        }
        let gap = ValueTable::from_csv("id,y\n0,1\n2,1\n").unwrap();
        assert_eq!(gap.leading_rows().nrows(), 1);
        assert!(gap.missing_words(4).contains("points 1, 3:"));
    }
}
