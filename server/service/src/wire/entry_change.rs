//! Changes of a study or a sweep after it was submitted: what lists say of it.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use document::fields::{Fields, shown};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use store::queue::listed::RowChange;
use utoipa::ToSchema;

/// Characters of a name, as in documents.
const LONGEST_NAME: usize = 200;

/// Change of what lists say of a study or a sweep: `name`, `archived` or both. What is left out stays as it is.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct EntryChange {
    /// Another name. The document, its hash and the result keep the one that was submitted.
    #[schema(nullable = false, min_length = 1, max_length = 200)]
    pub name: Option<String>,
    /// Whether lists leave it out.
    #[schema(nullable = false)]
    pub archived: Option<bool>,
}

/// An example.
pub fn example() -> Value {
    json!({"name": "thin wall, first try", "archived": true})
}

/// Reads a change.
///
/// # Errors
/// Every fault: what is neither a name nor true or false, unknown fields, and a document that changes nothing.
pub fn read_change(value: &Value) -> Result<RowChange, Vec<Fault>> {
    let mut faults = Vec::new();
    let Some(fields) = Fields::open(value, "", &["name", "archived"], &mut faults) else {
        return Err(faults);
    };
    let name = fields.get("name");
    let archived = fields.get("archived");
    if name.is_none() && archived.is_none() && faults.is_empty() {
        let detail = "must have a name, archived or both: without them nothing changes";
        Fault::add(&mut faults, "", detail);
    }
    let change = RowChange {
        name: name.and_then(|(value, pointer)| read_name(value, &pointer, &mut faults)),
        archived: archived.and_then(|(value, pointer)| read_flag(value, &pointer, &mut faults)),
    };
    if faults.is_empty() {
        Ok(change)
    } else {
        Err(faults)
    }
}

fn read_name(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<String> {
    let good = |text: &&str| {
        !text.trim().is_empty()
            && text.chars().count() <= LONGEST_NAME
            && !text.chars().any(char::is_control)
    };
    let name = value.as_str().filter(good);
    if name.is_none() {
        let detail = format!(
            "must be a text of 1 to {LONGEST_NAME} characters without control characters; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
    }
    name.map(str::to_owned)
}

fn read_flag(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<bool> {
    let flag = value.as_bool();
    if flag.is_none() {
        let detail = format!("must be true or false; it is {}", shown(value));
        Fault::add(faults, pointer, detail);
    }
    flag
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_says_what_stays_by_leaving_it_out() {
        let read = read_change(&json!({"archived": false})).expect("reads");
        assert_eq!((read.name, read.archived), (None, Some(false)));
        let read: RowChange = read_change(&example()).expect("reads");
        assert_eq!(read.archived, Some(true));
        assert!(serde_json::from_value::<EntryChange>(example()).is_ok());
    }

    #[test]
    fn every_fault_is_named_at_once() {
        let pointers = |value: &Value| -> Vec<String> {
            let faults = read_change(value).expect_err("is refused");
            faults.into_iter().map(|fault| fault.pointer).collect()
        };
        let wrong = json!({"name": " ", "archived": "yes", "state": "done"});
        assert_eq!(pointers(&wrong), ["/state", "/name", "/archived"]);
        for name in [json!(null), json!("a\nb"), json!("x".repeat(201))] {
            assert_eq!(pointers(&json!({"name": name})), ["/name"]);
        }
        for whole in [json!({}), json!([]), json!(null)] {
            assert_eq!(pointers(&whole), [""]);
        }
    }
}
