//! Values of outputs as lists of numbers: every digit of them counts, where a CSV file may show a few.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::collections::{BTreeMap, BTreeSet};

use document::fault::{Fault, entry};
use document::fields::{Fields, integer, shown};
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use serde_json::{Value, json};

use crate::own_model::planned_cells::PlannedCells;
use crate::own_model::value_row::{Place, ValueRow};
use crate::own_model::value_table::ValueTable;

/// Longest name of an output, characters.
const LONGEST_NAME: usize = 100;
/// Greatest number of a point, of which its reader knows how many there are.
const LAST_POINT: u64 = 1_000_000;

/// Reads `{"outputs": ["y"], "ids": [0, 1], "rows": [[1.5], [null]]}`. Pointers of faults begin in this table.
pub(super) fn read(value: &Value) -> Result<ValueTable, Vec<Fault>> {
    let mut faults = Vec::new();
    let read = read_lists(value, &mut faults);
    read.filter(|_| faults.is_empty()).ok_or(faults)
}

fn read_lists(value: &Value, faults: &mut Vec<Fault>) -> Option<ValueTable> {
    let fields = Fields::open(value, "", &["outputs", "ids", "rows"], faults)?;
    let outputs = outputs(&fields, faults);
    let lists = list(&fields, "rows", "the values of each point", faults)?;
    let ids = ids(&fields, lists.len(), faults)?;
    let outputs = outputs?;
    let mut rows = BTreeMap::new();
    for ((at, list), id) in lists.iter().enumerate().zip(ids) {
        let Some(values) = numbers(list, &entry("/rows", at), outputs.len(), faults) else {
            continue;
        };
        let row = ValueRow {
            place: Place::Entry(at),
            printed: vec![None; values.len()],
            values,
            planned: PlannedCells::default(),
        };
        rows.insert(id, row);
    }
    Some(ValueTable::of_rows(outputs, rows))
}

fn list<'v>(
    fields: &Fields<'v>,
    name: &str,
    what: &str,
    faults: &mut Vec<Fault>,
) -> Option<&'v Vec<Value>> {
    let (value, at) = fields.required(name, &format!("a list: {what}"), faults)?;
    let items = value.as_array();
    if items.is_none() {
        let detail = format!("must be a list: {what}; it is {}", shown(value));
        Fault::add(faults, &at, detail);
    }
    items
}

fn outputs(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Vec<String>> {
    let items = list(fields, "outputs", "the outputs' names", faults)?;
    if items.is_empty() {
        Fault::add(faults, "/outputs", "must name at least one output");
        return None;
    }
    let mut names: Vec<String> = Vec::new();
    for (at, item) in items.iter().enumerate() {
        let pointer = entry("/outputs", at);
        let name = String::read(item, &pointer, &LONGEST_NAME, faults)?;
        if names.contains(&name) {
            Fault::add(faults, &pointer, "is the name of an output before it");
        }
        names.push(name);
    }
    Some(names)
}

/// Points of the rows: as said, or else 0, 1, 2 and so on.
fn ids(fields: &Fields<'_>, rows: usize, faults: &mut Vec<Fault>) -> Option<Vec<usize>> {
    if fields.get("ids").is_none() {
        return Some((0..rows).collect());
    }
    let items = list(fields, "ids", "the point of each row", faults)?;
    if items.len() != rows {
        let detail = format!(
            "must have an entry for each of the {rows} rows; it has {}",
            items.len()
        );
        Fault::add(faults, "/ids", detail);
        return None;
    }
    let (mut ids, mut known) = (Vec::new(), BTreeSet::new());
    for (at, item) in items.iter().enumerate() {
        let pointer = entry("/ids", at);
        let Some(id) = integer(item, &pointer, 0, LAST_POINT, faults) else {
            continue;
        };
        if !known.insert(id) {
            Fault::add(faults, &pointer, format!("point {id} has a row already"));
        }
        ids.extend(usize::try_from(id));
    }
    (ids.len() == rows).then_some(ids)
}

/// The numbers of a row; null is a run that failed.
fn numbers(row: &Value, at: &str, outputs: usize, faults: &mut Vec<Fault>) -> Option<Vec<f64>> {
    let Some(items) = row.as_array().filter(|items| items.len() == outputs) else {
        let detail = format!(
            "must be a list of {outputs} numbers, one an output; it is {}",
            shown(row)
        );
        Fault::add(faults, at, detail);
        return None;
    };
    let number = |(k, item): (usize, &Value)| match item {
        Value::Null => Some(f64::NAN),
        item => {
            let number = item.as_f64();
            if number.is_none() {
                let detail = format!(
                    "must be a number, or null where the run failed; it is {}",
                    shown(item)
                );
                Fault::add(faults, &entry(at, k), detail);
            }
            number
        }
    };
    items.iter().enumerate().map(number).collect()
}

/// The schema of such a table.
pub(super) fn listed_schema(schemas: &mut Schemas) -> Value {
    schemas.define("ListedValues", |schemas| {
        let mut table = Properties::default();
        let name = String::schema(&LONGEST_NAME, schemas);
        let outputs = json!({"type": "array", "minItems": 1, "items": name, "uniqueItems": true});
        table.add_required("outputs", "Names of the outputs.", outputs);
        let id = u64::schema(&(0, LAST_POINT), schemas);
        let ids = json!({"type": "array", "items": id, "uniqueItems": true});
        let doc = "Point of each row; 0, 1, 2 and so on when left out.";
        table.add("ids", doc, ids, None, false);
        let number = json!({"type": ["number", "null"], "minimum": -f64::MAX, "maximum": f64::MAX});
        let rows =
            json!({"type": "array", "items": {"type": "array", "minItems": 1, "items": number}});
        let doc = "Values of each point, one an output, null where the run failed.";
        table.add_required("rows", doc, rows);
        table.table("Values of outputs by point; every digit of them counts.")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_read_in_any_order_and_are_exact() {
        let value =
            json!({"outputs": ["y", "z"], "ids": [1, 0], "rows": [[0.5, null], [2, 1e300]]});
        let table = read(&value).unwrap();
        let rows = table.leading_rows();
        assert_eq!(
            (rows[[0, 0]], rows[[0, 1]], rows[[1, 0]]),
            (2.0, 1e300, 0.5)
        );
        assert!(rows[[1, 1]].is_nan());
        assert_eq!(table.half_units(), [0.0, 0.0]);
        let numbered = read(&json!({"outputs": ["y"], "rows": [[1], [2]]})).unwrap();
        assert!(numbered.has(1) && !numbered.has(2));
    }

    #[test]
    fn every_fault_has_its_place() {
        let places = |value: Value| -> Vec<String> {
            let faults = read(&value).unwrap_err();
            faults.into_iter().map(|fault| fault.pointer).collect()
        };
        let faulty =
            json!({"outputs": ["y", "y"], "ids": [0, 0, -1], "rows": [[1, 2], [1], 3], "x": 1});
        assert_eq!(places(faulty), ["/x", "/outputs/1", "/ids/1", "/ids/2"]);
        let faulty = json!({"outputs": ["y"], "rows": [["1"], [1, 2]]});
        assert_eq!(places(faulty), ["/rows/0/0", "/rows/1"]);
        assert_eq!(
            places(json!({"outputs": [], "ids": [1]})),
            ["/outputs", "/rows"]
        );
        assert_eq!(
            places(json!({"outputs": ["y"], "ids": [1], "rows": []})),
            ["/ids"]
        );
        assert_eq!(places(json!([])), [""]);
    }
}
