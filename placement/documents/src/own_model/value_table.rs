//! Values of outputs by point, from a CSV file: header `id,<output names>`, then a row per point in any order.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::BTreeMap;

use document::fault::Fault;
use ndarray::Array2;

use crate::own_model::csv_cell::text;

/// Points named in one sentence.
const MOST_NAMED: usize = 10;

/// Output names, and their values by point.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueTable {
    outputs: Vec<String>,
    /// values by id, with the line they came from
    rows: BTreeMap<usize, (usize, Vec<f64>)>,
}

impl ValueTable {
    /// Makes a table of which nothing was run yet.
    pub fn empty() -> Self {
        Self {
            outputs: Vec::new(),
            rows: BTreeMap::new(),
        }
    }

    /// Reads the text of a file. An empty cell, `nan` and infinities are runs that failed.
    ///
    /// # Errors
    /// Every fault, with its line.
    pub fn from_csv(text: &str) -> Result<Self, Vec<Fault>> {
        let mut faults = Vec::new();
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(i, line)| (i + 1, line.trim_start_matches('\u{feff}')))
            .filter(|(_, line)| !line.trim().is_empty());
        let Some((number, header)) = lines.next() else {
            fault(
                &mut faults,
                1,
                "the file is empty; its first line is the header id,<output names>",
            );
            return Err(faults);
        };
        let mut outputs = cells(header);
        if outputs.first().map(String::as_str) != Some("id") || outputs.len() < 2 {
            fault(&mut faults, number, "the header must be id,<output names>");
            return Err(faults);
        }
        outputs.remove(0);
        for (i, name) in outputs.iter().enumerate() {
            if name.is_empty() || outputs.iter().take(i).any(|other| other == name) {
                let detail = format!("output {} has no name of its own: {name:?}", i + 1);
                fault(&mut faults, number, &detail);
            }
        }
        let mut rows = BTreeMap::new();
        for (number, line) in lines {
            let Some((id, values)) = row(number, line, outputs.len(), &mut faults) else {
                continue;
            };
            if let Some((first, _)) = rows.insert(id, (number, values)) {
                let detail = format!("point {id} was given on line {first} already");
                fault(&mut faults, number, &detail);
            }
        }
        if faults.is_empty() {
            Ok(Self { outputs, rows })
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
            .map(|(_, (_, (_, values)))| values)
            .collect();
        // Every row has a value for each output.
        let mut table = Array2::from_elem((rows.len(), self.outputs.len()), f64::NAN);
        for (cell, value) in table.iter_mut().zip(rows.into_iter().flatten()) {
            *cell = *value;
        }
        table
    }

    /// Points that nobody asked for are faults.
    ///
    /// # Errors
    /// Each of them, with its line.
    pub fn check_ids(&self, points: usize) -> Result<(), Vec<Fault>> {
        let mut faults = Vec::new();
        for (id, (line, _)) in self.rows.range(points..) {
            let detail = if points > 0 {
                format!(
                    "there is no point {id}: the plan has points 0 to {}",
                    points - 1
                )
            } else {
                format!("there is no point {id}")
            };
            fault(&mut faults, *line, &detail);
        }
        if faults.is_empty() {
            Ok(())
        } else {
            Err(faults)
        }
    }

    /// The fault of a table that lacks points.
    pub fn missing_ids(&self, points: usize) -> Vec<Fault> {
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
        vec![Fault {
            pointer: String::new(),
            detail: format!(
                "no values for points {}{more}: run them, or give nan for a run that failed",
                named.join(", ")
            ),
        }]
    }
}

fn row(
    number: usize,
    line: &str,
    outputs: usize,
    faults: &mut Vec<Fault>,
) -> Option<(usize, Vec<f64>)> {
    let cells = cells(line);
    let Some((id, values_of)) = cells
        .split_first()
        .filter(|(_, rest)| rest.len() == outputs)
    else {
        let detail = format!("has {} cells; the header has {}", cells.len(), outputs + 1);
        fault(faults, number, &detail);
        return None;
    };
    let id = id.parse::<usize>().map_err(|_| {
        let detail = format!("the id must be a point's number, not {id:?}");
        fault(faults, number, &detail);
    });
    let mut values = Vec::with_capacity(outputs);
    for cell in values_of {
        match cell.as_str() {
            "" => values.push(f64::NAN),
            cell => match cell.parse::<f64>() {
                Ok(value) => values.push(value),
                Err(_) => fault(faults, number, &format!("not a number: {cell:?}")),
            },
        }
    }
    Some((id.ok()?, values)).filter(|(_, values)| values.len() == outputs)
}

fn fault(faults: &mut Vec<Fault>, line: usize, detail: &str) {
    Fault::add(faults, "", format!("line {line}: {detail}"));
}

/// The cells of a line; in quotes a comma is part of the cell and two quotes are one.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    let mut characters = line.trim_end_matches('\r').chars().peekable();
    while let Some(c) = characters.next() {
        let cell = cells.last_mut();
        match (c, quoted, cell) {
            ('"', true, Some(cell)) if characters.peek() == Some(&'"') => {
                characters.next();
                cell.push('"');
            }
            ('"', ..) => quoted = !quoted,
            (',', false, _) => cells.push(String::new()),
            (c, _, Some(cell)) => cell.push(c),
            (_, _, None) => {}
        }
    }
    let texts = cells.iter().map(|cell| text(cell.trim()).to_owned());
    texts.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::own_model::csv_cell::cell;

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
        assert!(table.check_ids(3).is_ok());
        let faults = table.check_ids(2).unwrap_err();
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
        assert!(gap.missing_ids(4)[0].detail.contains("points 1, 3:"));
    }
}
