//! Rows of a table of values: the meaning of each column, and the cells of a line.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, entry};

use crate::own_model::csv_cell::text;
use crate::own_model::planned_cells::PlannedCells;
use crate::own_model::printed_number::PrintedNumber;

/// Name of the column that holds the plan's fingerprint.
pub const PLAN_COLUMN: &str = "plan";

/// Meaning of a column behind the id.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Column {
    /// An input by number, as planned.
    Input(usize),
    /// The plan's fingerprint.
    Plan,
    /// An output.
    Output,
}

/// Place of a row in what was read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Place {
    /// Line of a file.
    Line(usize),
    /// Entry of a list.
    Entry(usize),
}

impl Place {
    /// Adds a fault at this place.
    pub(super) fn fault(self, faults: &mut Vec<Fault>, detail: &str) {
        match self {
            Self::Line(line) => fault(faults, line, detail),
            Self::Entry(at) => Fault::add(faults, &entry("/rows", at), detail),
        }
    }
}

/// A row that was read.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ValueRow {
    /// Place that it came from.
    pub(super) place: Place,
    /// Value of each output, NaN where the run failed.
    pub(super) values: Vec<f64>,
    /// Digits of each output's value; `None` where the run failed.
    pub(super) printed: Vec<Option<PrintedNumber>>,
    pub(super) planned: PlannedCells,
}

/// Reads a line into its point's number and its row; faults are told, and leave nothing.
pub(super) fn read(
    line: usize,
    text: &str,
    (names, columns): (&[String], &[Column]),
    faults: &mut Vec<Fault>,
) -> Option<(usize, ValueRow)> {
    let cells = cells(text);
    let Some((id, rest)) = cells
        .split_first()
        .filter(|(_, rest)| rest.len() == columns.len())
    else {
        let detail = format!(
            "has {} cells; the header has {}",
            cells.len(),
            columns.len() + 1
        );
        fault(faults, line, &detail);
        return None;
    };
    let before = faults.len();
    let id = id.parse::<usize>().map_err(|_| {
        let detail = format!("the id must be a point's number, not {id:?}");
        fault(faults, line, &detail);
    });
    let mut row = ValueRow {
        place: Place::Line(line),
        values: Vec::with_capacity(columns.len()),
        printed: Vec::with_capacity(columns.len()),
        planned: PlannedCells::default(),
    };
    for ((cell, name), column) in rest.iter().zip(names).zip(columns) {
        if let Err(detail) = row.take(cell, name, column) {
            fault(faults, line, &detail);
        }
    }
    id.ok()
        .filter(|_| faults.len() == before)
        .map(|id| (id, row))
}

impl ValueRow {
    fn take(&mut self, cell: &str, name: &str, column: &Column) -> Result<(), String> {
        match column {
            Column::Input(input) => {
                let told = PrintedNumber::read(cell).ok_or_else(|| {
                    format!("column {name:?} must repeat the input as it was planned, not {cell:?}; or leave the column out")
                })?;
                self.planned.inputs.push((*input, told));
            }
            Column::Plan => self.planned.fingerprint = Some(cell.to_owned()),
            Column::Output => {
                let value = match cell {
                    "" => f64::NAN,
                    cell => cell
                        .parse::<f64>()
                        .map_err(|_| format!("not a number: {cell:?}"))?,
                };
                self.values.push(value);
                self.printed.push(PrintedNumber::read(cell));
            }
        }
        Ok(())
    }
}

pub(super) fn fault(faults: &mut Vec<Fault>, line: usize, detail: &str) {
    Fault::add(faults, "", format!("line {line}: {detail}"));
}

/// The cells of a line; in quotes a comma is part of the cell and two quotes are one.
pub(super) fn cells(line: &str) -> Vec<String> {
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
