//! Reads a table within another one.

use serde_json::{Map, Value};

use crate::document::fault::Fault;
use crate::document::fields::Fields;

/// Reads a table; an absent one is read as an empty one, so that defaults are in one place.
pub(super) fn section<T>(
    fields: &Fields<'_>,
    name: &str,
    faults: &mut Vec<Fault>,
    read: fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<T> {
    let empty = Value::Object(Map::new());
    match fields.get(name) {
        Some((value, pointer)) => read(value, &pointer, faults),
        None => read(&empty, &fields.at(name), faults),
    }
}
