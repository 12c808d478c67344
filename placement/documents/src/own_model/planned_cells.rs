//! Cells of a table of values that repeat its plan: the inputs of each point, and the fingerprint. Both are compared with the plan that it is
//! analysed by, so that values of one plan aren't taken for those of another.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;

use crate::own_model::printed_number::PrintedNumber;

/// Rows named one by one for each column.
const MOST_NAMED: usize = 10;
/// Rounding of a program that reads and writes a double again.
const READ_AGAIN: f64 = 4.0 * f64::EPSILON;
/// Ways out of it.
const REMEDY: &str = "analyse by the inputs and the method that planned these points, or run those that gsa plan prints now";

/// Points as planned now, with the names of their inputs and the fingerprint.
#[derive(Debug, Clone, Copy)]
pub struct Planned<'a> {
    /// Names of the inputs.
    pub inputs: &'a [String],
    /// A coordinate for each input, point after point.
    pub points: &'a [Vec<f64>],
    /// Fingerprint of the plan.
    pub fingerprint: &'a str,
}

/// Cells of a row that repeat its plan.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct PlannedCells {
    /// Number of the input, and what stands there.
    pub(super) inputs: Vec<(usize, PrintedNumber)>,
    pub(super) fingerprint: Option<String>,
}

/// A row of the table: its line, its point, and what it repeats.
pub(super) type Row<'a> = (usize, usize, &'a PlannedCells);

/// The faults of rows that repeat another plan.
pub(super) fn faults<'a>(rows: impl Iterator<Item = Row<'a>>, plan: &Planned<'_>) -> Vec<Fault> {
    let mut columns: Vec<Vec<String>> = vec![Vec::new(); plan.inputs.len() + 1];
    for (line, id, cells) in rows {
        let Some(point) = plan.points.get(id) else {
            continue;
        };
        for &(input, told) in &cells.inputs {
            let of_input = plan.inputs.get(input).zip(point.get(input));
            let differs = of_input.filter(|(_, x)| !is_same(told, **x));
            if let (Some((name, x)), Some(column)) = (differs, columns.get_mut(input)) {
                let told = told.value;
                column.push(format!(
                    "line {line}, column {name:?}: point {id} was run with {told:?}, and has {x:?} in this plan"
                ));
            }
        }
        let other = cells.fingerprint.as_ref();
        if let (Some(other), Some(column)) = (
            other.filter(|other| *other != plan.fingerprint),
            columns.last_mut(),
        ) {
            column.push(format!(
                "line {line}, column \"plan\": point {id} is of the plan {other}, and this one is {}",
                plan.fingerprint
            ));
        }
    }
    columns.into_iter().flat_map(named).collect()
}

/// Whether a number is the plan's, to the digits that it shows.
fn is_same(told: PrintedNumber, x: f64) -> bool {
    (told.value - x).abs() <= told.unit().max(READ_AGAIN * x.abs())
}

/// The first faults of a column, and how many more there are.
fn named(mut details: Vec<String>) -> Vec<Fault> {
    let more = details.len().saturating_sub(MOST_NAMED);
    details.truncate(MOST_NAMED);
    let Some(last) = details.last_mut() else {
        return Vec::new();
    };
    if more > 0 {
        last.push_str(&format!(", and so in {more} more rows"));
    }
    last.push_str(&format!(": {REMEDY}"));
    let fault = |detail| Fault {
        pointer: String::new(),
        detail,
    };
    details.into_iter().map(fault).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_the_plans_to_its_own_digits() {
        let is_same = |text: &str, x| is_same(PrintedNumber::read(text).unwrap(), x);
        let x = 0.046910077030668;
        for text in [
            "0.046910077030668",
            "0.0469",
            "4.691e-2",
            "0.05",
            "0.046910077030668004",
        ] {
            assert!(is_same(text, x), "{text}");
        }
        for text in ["0.46910077", "0.0480", "0.046912", "-0.0469"] {
            assert!(!is_same(text, x), "{text}");
        }
    }

    #[test]
    fn rows_of_another_plan_are_named_with_their_column() {
        let plan = Planned {
            inputs: &["a".to_owned(), "b".to_owned()],
            points: &[vec![1.0, 2.0], vec![3.0, 4.0]],
            fingerprint: "p01234567",
        };
        let cells = |b: &str, fingerprint: &str| PlannedCells {
            inputs: vec![(1, PrintedNumber::read(b).unwrap())],
            fingerprint: Some(fingerprint.to_owned()),
        };
        let (right, wrong) = (cells("2", "p01234567"), cells("4.5", "p89abcdef"));
        let found = faults(
            [(2, 0, &right), (3, 1, &wrong), (4, 7, &wrong)].into_iter(),
            &plan,
        );
        let begins = [
            "line 3, column \"b\": point 1 was run with 4.5, and has 4.0 in this plan: analyse by",
            "line 3, column \"plan\": point 1 is of the plan p89abcdef, and this one is p01234567: ",
        ];
        assert_eq!(found.len(), 2);
        for (fault, begin) in found.iter().zip(begins) {
            assert!(fault.detail.starts_with(begin), "{fault:?}");
        }
        let rows: Vec<Row<'_>> = (0..30).map(|line| (line, 1, &wrong)).collect();
        let found = faults(rows.into_iter(), &plan);
        assert_eq!(found.len(), 2 * MOST_NAMED);
        assert!(found[9].detail.contains("and so in 20 more rows: analyse"));
    }
}
