//! Placeholders of NaN and infinities, which JSON hasn't.

use serde_json::{Map, Value};

/// Name of the only member of what stands for a NaN or an infinity: JSON has no such number, and no reader takes a table
/// for one, so that its fault is listed with all others.
const NON_FINITE: &str = "non-finite number";

pub(crate) fn non_finite(number: f64) -> Value {
    Value::Object(Map::from_iter([(
        NON_FINITE.to_owned(),
        Value::String(number.to_string()),
    )]))
}

/// The text of a NaN or an infinity, if that is what the value stands for.
pub(crate) fn as_non_finite(value: &Value) -> Option<&str> {
    value.get(NON_FINITE)?.as_str()
}
