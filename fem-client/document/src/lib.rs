//! Reads TOML or JSON text into one kind of value, whatever its format, so that one reader serves both.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

pub mod fault;
pub mod fields;
mod json;
pub mod json_schema;
pub(crate) mod non_finite;
pub mod typed;
pub mod visible;

use serde_json::Number;

// Each name is a derive and the trait that it implements.
pub use document_derive::{Choice, Table, Variants};
pub use fields::Map;
pub use serde_json::Value;
pub use typed::kinds::Variants;
pub use typed::named_choice::Choice;
pub use typed::table_fields::Table;
// For what is derived.
pub use {serde, utoipa};

use crate::fault::{Fault, entry, member};
use crate::non_finite::non_finite;
use crate::visible::visible;

/// Longest document that is read, bytes.
pub const MAX_BYTES: usize = 1 << 20;

/// Deepest nesting of a document. Scenes and studies need five levels.
pub(crate) const MAX_DEPTH: usize = 64;

/// Syntax of a document.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// TOML 1.0.
    Toml,
    /// JSON.
    Json,
}

impl Format {
    /// The format that a file's name promises: JSON for `.json`, else TOML.
    pub fn of_path(path: &str) -> Self {
        let extension = path.rsplit_once('.').map_or("", |(_, extension)| extension);
        if extension.eq_ignore_ascii_case("json") {
            Self::Json
        } else {
            Self::Toml
        }
    }
}

/// Parses text into a value in which every number is finite. A NaN or an infinity of TOML becomes a value that every
/// reader refuses.
///
/// # Errors
/// One fault with line and column when the text isn't well-formed, or one that says how it is too large or too deep; the place of every member that stands twice, of every date.
pub fn parse(text: &str, format: Format) -> Result<Value, Vec<Fault>> {
    let fault = |detail| {
        vec![Fault {
            pointer: String::new(),
            detail,
        }]
    };
    if text.len() > MAX_BYTES {
        return Err(fault(format!(
            "the document has {} bytes; at most {MAX_BYTES} are read",
            text.len()
        )));
    }
    match format {
        Format::Json => read_json(text),
        Format::Toml => {
            if longest_key(text) > MAX_KEY_PARTS {
                let detail = format!("a key of the document has more than {MAX_KEY_PARTS} parts");
                return Err(fault(detail));
            }
            let table: toml::Table =
                toml::from_str(text).map_err(|error| fault(toml_detail(text, &error)))?;
            let mut faults = Vec::new();
            let value = from_toml(toml::Value::Table(table), "", 0, &mut faults);
            if faults.is_empty() {
                Ok(value)
            } else {
                Err(faults)
            }
        }
    }
}

/// Parses JSON whose texts may be long; all else of it is bounded as any document is, so that it takes little more memory than its bytes.
///
/// # Errors
/// As [`parse`].
pub fn parse_long_texts(text: &str) -> Result<Value, Vec<Fault>> {
    let bytes = bytes_beside_texts(text);
    if bytes > MAX_BYTES {
        return Err(vec![Fault {
            pointer: String::new(),
            detail: format!(
                "the document has {bytes} bytes beside its texts; at most {MAX_BYTES} are read"
            ),
        }]);
    }
    read_json(text)
}

fn read_json(text: &str) -> Result<Value, Vec<Fault>> {
    match json::read(text) {
        Ok((value, faults)) if faults.is_empty() => Ok(value),
        Ok((_, faults)) => Err(faults),
        Err(error) => Err(vec![Fault {
            pointer: String::new(),
            detail: format!("not well-formed JSON: {error}"),
        }]),
    }
}

/// Bytes outside of quotes, and the quotes.
fn bytes_beside_texts(json: &str) -> usize {
    let (mut quoted, mut escaped, mut bytes) = (false, false, 0);
    for byte in json.bytes() {
        match byte {
            b'"' if !escaped => {
                quoted = !quoted;
                bytes += 1;
            }
            _ if !quoted => bytes += 1,
            _ => {}
        }
        escaped = quoted && byte == b'\\' && !escaped;
    }
    bytes
}

/// A value as typed on a command line: JSON, or else a word. Of a table with a member that stands twice nobody knows what it says: it stays a word, which its reader refuses.
pub fn json_or_word(text: &str) -> Value {
    let text = text.trim();
    match json::read(text) {
        Ok((value, faults)) if faults.is_empty() => value,
        _ => Value::String(text.to_owned()),
    }
}

/// Most parts of a dotted TOML key. Each part nests a table, and tables are dropped recursively; the parser itself
/// bounds how deep brackets and braces nest, not dots.
const MAX_KEY_PARTS: usize = 100;

/// Parts of the longest dotted key, or of what may be one: a string with as many dots counts too.
fn longest_key(text: &str) -> usize {
    let ends_a_key = |c: char| matches!(c, '=' | ',' | '[' | ']' | '{' | '}' | '\n');
    let parts = |key: &str| {
        key.split('.')
            .filter(|part| !part.trim().is_empty())
            .count()
    };
    text.split(ends_a_key).map(parts).max().unwrap_or(0)
}

fn toml_detail(text: &str, error: &toml::de::Error) -> String {
    let message = visible(&error.message().trim_end().replace('\n', "; "));
    match error.span().and_then(|span| text.get(..span.start)) {
        Some(before) => {
            let line = before.matches('\n').count() + 1;
            let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
            format!("not well-formed TOML: {message} at line {line} column {column}")
        }
        None => format!("not well-formed TOML: {message}"),
    }
}

fn from_toml(value: toml::Value, pointer: &str, depth: usize, faults: &mut Vec<Fault>) -> Value {
    if depth > MAX_DEPTH {
        Fault::add(
            faults,
            "",
            format!("the document is nested deeper than {MAX_DEPTH} levels"),
        );
        return Value::Null;
    }
    match value {
        toml::Value::String(text) => Value::String(text),
        toml::Value::Integer(number) => Value::Number(number.into()),
        toml::Value::Boolean(flag) => Value::Bool(flag),
        // JSON has none, and no field of ours takes one.
        toml::Value::Datetime(date) => {
            let detail = format!(
                "is the date or time {date}, which no field takes; a text stands in quotes"
            );
            Fault::add(faults, pointer, detail);
            Value::Null
        }
        toml::Value::Float(number) => {
            Number::from_f64(number).map_or_else(|| non_finite(number), Value::Number)
        }
        toml::Value::Array(items) => {
            let convert = |(i, item)| from_toml(item, &entry(pointer, i), depth + 1, faults);
            Value::Array(items.into_iter().enumerate().map(convert).collect())
        }
        toml::Value::Table(table) => {
            let mut object = Map::new();
            for (name, item) in table {
                let item = from_toml(item, &member(pointer, &name), depth + 1, faults);
                object.insert(name, item);
            }
            Value::Object(object)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::non_finite::as_non_finite;

    #[test]
    fn both_formats_give_the_same_value() {
        let toml = parse("a = 1\n[b]\nc = [1.5, \"x\", true]\n", Format::Toml).unwrap();
        let json = parse(r#"{"a": 1, "b": {"c": [1.5, "x", true]}}"#, Format::Json).unwrap();
        assert_eq!(toml, json);
    }

    #[test]
    fn what_stands_twice_and_dates_are_faults_with_their_place() {
        let faults = parse(r#"{"a": {"b": 1, "b": 2}}"#, Format::Json).unwrap_err();
        assert_eq!(faults[0].pointer, "/a/b");
        assert!(parse("a = 1\na = 2\n", Format::Toml).is_err());
        assert!(json_or_word(r#"{"b": 1, "b": 2}"#).is_string());
        let dates = "name = 2026-11-23\n[a]\nb = [1, 07:32:00]\nc = 2026-11-23T07:32:00Z\n";
        let faults = parse(dates, Format::Toml).unwrap_err();
        let pointers: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
        assert_eq!(pointers, ["/a/b/1", "/a/c", "/name"]);
        assert!(
            faults[2]
                .detail
                .contains("2026-11-23, which no field takes"),
            "{}",
            faults[2].detail
        );
    }

    #[test]
    fn a_syntax_error_is_one_fault_with_its_place() {
        for (text, format) in [
            ("a = 1\nb = = 2\n", Format::Toml),
            ("{\"a\": 1,\n \"b\": }", Format::Json),
        ] {
            let faults = parse(text, format).unwrap_err();
            assert_eq!(faults.len(), 1);
            assert!(
                faults[0].detail.contains("line 2 column"),
                "{}",
                faults[0].detail
            );
        }
    }

    #[test]
    fn numbers_that_are_not_finite_are_named() {
        let value = parse("a = nan\nb = { c = [1.0, -inf] }\n", Format::Toml).unwrap();
        assert_eq!(as_non_finite(&value["a"]), Some("NaN"));
        assert_eq!(as_non_finite(&value["b"]["c"][1]), Some("-inf"));
        assert_eq!(as_non_finite(&value["b"]), None);
        assert!(parse("{\"a\": 1e999}", Format::Json).is_err());
        assert!(parse("{\"a\": NaN}", Format::Json).is_err());
    }

    #[test]
    fn depth_and_size_are_bounded() {
        let deep = 500_000;
        let json = format!("{}{}", "[".repeat(deep), "]".repeat(deep));
        assert!(parse(&json, Format::Json).is_err());
        assert!(parse(&format!("a = {}", "[".repeat(deep)), Format::Toml).is_err());
        assert!(parse(&format!("{}a = 1", "a.".repeat(deep)), Format::Toml).is_err());
        assert!(parse(&format!("[{}a]", "a.".repeat(99)), Format::Toml).is_err());
        // Keys at the bound inside inline tables at the parser's own: 8000 tables deep.
        let nested = format!("{}a = {{\n", "a.".repeat(99)).repeat(80);
        assert!(parse(&format!("{nested}{}", "}".repeat(80)), Format::Toml).is_err());
        assert!(parse(&" ".repeat(MAX_BYTES + 1), Format::Json).is_err());
    }

    #[test]
    fn texts_alone_may_be_long() {
        // A quote and a backslash at the end of a text end nothing by themselves.
        let text = format!("{}\"\\", "x".repeat(MAX_BYTES));
        let long = serde_json::json!({"text": text}).to_string();
        assert!(parse(&long, Format::Json).is_err());
        assert_eq!(parse_long_texts(&long).expect("reads")["text"], text);
        let many = format!("[{}0]", "0,".repeat(MAX_BYTES / 2));
        let refused = parse_long_texts(&many).expect_err("is too long");
        assert!(refused[0].detail.contains("beside its texts"));
        assert_eq!(bytes_beside_texts(r#"{"a\\": "\"", "b": "" }"#), 17);
    }
}
