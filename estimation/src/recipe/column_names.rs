//! Names of columns.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Value;
use document::fault::Fault;
use document::fields::shown;

/// Most names or patterns of a list.
const MOST_NAMES: usize = 4096;
/// Characters of a column's name.
pub(crate) const LONGEST_NAME: usize = 200;
/// Most patterns of a list: each is held against every column.
const MOST_PATTERNS: usize = 50;

/// Whether a name stands for others: `*` for any characters, `?` for one.
pub(crate) fn is_pattern(name: &str) -> bool {
    name.contains(['*', '?'])
}

fn name(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<String> {
    let fits = |text: &&str| {
        (1..=LONGEST_NAME).contains(&text.chars().count()) && !text.contains(['\n', '\r'])
    };
    let found = value.as_str().filter(fits);
    if found.is_none() {
        let detail = format!(
            "must be a column's name of 1 to {LONGEST_NAME} characters; it is {}",
            shown(value)
        );
        Fault::add(faults, at, detail);
    }
    found.map(str::to_owned)
}

fn name_schema() -> Value {
    serde_json::json!({"type": "string", "minLength": 1, "maxLength": LONGEST_NAME, "pattern": "^[^\\n\\r]*$"})
}

/// A name that may be left out.
pub mod one {
    use document::json_schema::Schemas;

    use super::*;

    pub fn read(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<Option<String>> {
        name(value, at, faults).map(Some)
    }

    pub fn write(name: &Option<String>) -> Option<Value> {
        name.as_deref().map(Value::from)
    }

    pub fn schema(_: &mut Schemas) -> Value {
        name_schema()
    }
}

/// A name, or a list of names and patterns, that may be left out.
pub mod several {
    use document::fault::entry;
    use document::json_schema::Schemas;

    use super::*;

    pub fn read(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<Option<Vec<String>>> {
        if value.is_string() {
            return name(value, at, faults).map(|name| Some(vec![name]));
        }
        let lengths = 1..=MOST_NAMES;
        let items = value
            .as_array()
            .filter(|items| lengths.contains(&items.len()));
        let Some(items) = items else {
            let detail = format!(
                "must be a list of 1 to {MOST_NAMES} entries; it is {}",
                shown(value)
            );
            Fault::add(faults, at, detail);
            return None;
        };
        let of = |(i, item)| name(item, &entry(at, i), faults);
        let names: Vec<Option<String>> = items.iter().enumerate().map(of).collect();
        let names: Vec<String> = names.into_iter().collect::<Option<_>>()?;
        let patterns = names.iter().filter(|name| is_pattern(name)).count();
        if patterns > MOST_PATTERNS {
            let detail = format!(
                "has {patterns} patterns with * or ?; at most {MOST_PATTERNS} are looked for"
            );
            Fault::add(faults, at, detail);
            return None;
        }
        Some(Some(names))
    }

    pub fn write(names: &Option<Vec<String>>) -> Option<Value> {
        names
            .as_ref()
            .map(|names| names.iter().map(String::as_str).collect())
    }

    pub fn schema(_: &mut Schemas) -> Value {
        let list = serde_json::json!({"type": "array", "minItems": 1, "maxItems": MOST_NAMES, "items": name_schema()});
        serde_json::json!({"anyOf": [name_schema(), list]})
    }
}
