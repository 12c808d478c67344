//! Reads JSON into a value, and sees what serde_json itself lets pass: a member that stands twice in its table, of which it keeps the last.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::map::Entry;
use serde_json::{Map, Number, Value};

use crate::fault::{Fault, entry, member};

/// A value, and a fault for each member that stands twice. serde_json refuses more than 128 levels and numbers beyond the range of f64.
///
/// # Errors
/// What serde_json says of a text that isn't well-formed.
pub(super) fn read(text: &str) -> Result<(Value, Vec<Fault>), serde_json::Error> {
    let mut faults = Vec::new();
    let mut text = serde_json::Deserializer::from_str(text);
    let reader = Reader {
        place: &Place::Top,
        faults: &mut faults,
    };
    let value = reader.deserialize(&mut text)?;
    text.end()?;
    Ok((value, faults))
}

/// Place of a value: its pointer is written out for faults alone.
enum Place<'p> {
    Top,
    Member(&'p Place<'p>, &'p str),
    Entry(&'p Place<'p>, usize),
}

impl Place<'_> {
    fn pointer(&self) -> String {
        match self {
            Self::Top => String::new(),
            Self::Member(table, name) => member(&table.pointer(), name),
            Self::Entry(list, index) => entry(&list.pointer(), *index),
        }
    }
}

struct Reader<'r> {
    place: &'r Place<'r>,
    faults: &'r mut Vec<Fault>,
}

impl<'de> DeserializeSeed<'de> for Reader<'_> {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, text: D) -> Result<Value, D::Error> {
        text.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Reader<'_> {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, flag: bool) -> Result<Value, E> {
        Ok(Value::Bool(flag))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Value, E> {
        Ok(Value::Number(number.into()))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Value, E> {
        Ok(Value::Number(number.into()))
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Value, E> {
        let number = Number::from_f64(number);
        number
            .map(Value::Number)
            .ok_or_else(|| E::custom("number out of range"))
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(Value::String(text.to_owned()))
    }

    fn visit_string<E>(self, text: String) -> Result<Value, E> {
        Ok(Value::String(text))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        let mut items = Vec::new();
        loop {
            let reader = Reader {
                place: &Place::Entry(self.place, items.len()),
                faults: self.faults,
            };
            match list.next_element_seed(reader)? {
                Some(item) => items.push(item),
                None => return Ok(Value::Array(items)),
            }
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut table: A) -> Result<Value, A::Error> {
        let mut object = Map::new();
        while let Some(name) = table.next_key::<String>()? {
            let place = Place::Member(self.place, &name);
            let reader = Reader {
                place: &place,
                faults: self.faults,
            };
            let value = table.next_value_seed(reader)?;
            match object.entry(name) {
                Entry::Vacant(free) => {
                    free.insert(value);
                }
                Entry::Occupied(taken) => {
                    let at = member(&self.place.pointer(), taken.key());
                    Fault::add(self.faults, &at, "stands twice; which one is meant?");
                }
            }
        }
        Ok(Value::Object(object))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_of_serde_json() {
        for text in [
            "null",
            " [true, false, -1, 18446744073709551615, -9223372036854775808, 0.1, 1e-400, 5e-324, -0.0, 1e22] ",
            r#"{"b": {"": "\u00e4\n"}, "a": [[], {}], "c": "plain"}"#,
        ] {
            let (value, faults) = read(text).expect("JSON");
            assert!(faults.is_empty());
            let expected: Value = serde_json::from_str(text).expect("JSON");
            // As texts: the order of members counts, and the sign of zero.
            assert_eq!(value.to_string(), expected.to_string());
        }
        for text in [
            "",
            "{",
            "1 2",
            "1e999",
            "NaN",
            "{\"a\"}",
            "[1,]",
            "\"\\ud800\"",
        ] {
            let own = read(text).expect_err(text).to_string();
            let expected = serde_json::from_str::<Value>(text).expect_err(text);
            assert_eq!(own, expected.to_string());
        }
        let levels = |count| format!("{}{}", "[".repeat(count), "]".repeat(count));
        assert!(read(&levels(127)).is_ok() && read(&levels(128)).is_err());
    }

    #[test]
    fn members_that_stand_twice_are_told_with_their_pointers() {
        let text =
            r#"{"a": 1, "b": [0, {"c/d": 1, "e": 2, "c\u002fd": 3}], "a": {"f": 1, "f": 1}}"#;
        let (_, faults) = read(text).expect("JSON");
        let pointers: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
        assert_eq!(pointers, ["/b/1/c~1d", "/a/f", "/a"]);
        let many = format!("{{{}\"a\": 0}}", "\"a\": 0,".repeat(100_000));
        let (_, faults) = read(&many).expect("JSON");
        assert_eq!(faults.len(), crate::fault::MAX_FAULTS + 1);
    }
}
