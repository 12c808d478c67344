//! The value of a field, and the plain ones: numbers, whole numbers, flags.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde_json::{Value, json};

use crate::fault::Fault;
use crate::fields::{Fields, Range, integer, number, shown};
use crate::json_schema::Schemas;

/// The value of a field.
pub trait Field: Sized {
    /// Bounds of the value: a [`Range`] of a number, least and greatest of a whole one, `Entries` of a list.
    type Within;

    /// Reads it; None after a fault.
    fn read(
        value: &Value,
        at: &str,
        within: &Self::Within,
        faults: &mut Vec<Fault>,
    ) -> Option<Self>;

    /// The value in the canonical text; None where the text leaves it out.
    fn write(&self) -> Option<Value>;

    /// Returns the JSON Schema of the value, without what the field says of it.
    fn schema(within: &Self::Within, schemas: &mut Schemas) -> Value;
}

impl Field for f64 {
    type Within = Range;

    fn read(value: &Value, at: &str, within: &Range, faults: &mut Vec<Fault>) -> Option<Self> {
        number(value, at, *within, faults)
    }

    fn write(&self) -> Option<Value> {
        Some((*self).into())
    }

    fn schema(within: &Range, _: &mut Schemas) -> Value {
        within.schema()
    }
}

/// Whole numbers between two, both included.
macro_rules! whole_numbers {
    ($($number:ty),+) => {$(
        impl Field for $number {
            type Within = (u64, u64);

            fn read(value: &Value, at: &str, &(least, most): &(u64, u64), faults: &mut Vec<Fault>) -> Option<Self> {
                let read = integer(value, at, least, most, faults)?;
                Self::try_from(read).ok()
            }

            fn write(&self) -> Option<Value> {
                Some((*self).into())
            }

            fn schema((least, most): &(u64, u64), _: &mut Schemas) -> Value {
                json!({"type": "integer", "minimum": least, "maximum": most})
            }
        }
    )+};
}

whole_numbers!(u32, u64, usize);

/// A text with something to see and without control characters, as a pattern that JavaScript and Python read alike.
const PLAIN_TEXT: &str = "^[^\\u0000-\\u001f\\u007f-\\u009f]*[^\\s\\u0000-\\u001f\\u007f-\\u009f][^\\u0000-\\u001f\\u007f-\\u009f]*$";

/// A text of up to so many characters: not empty, without control characters, so that it can't forge lines of a log or table.
impl Field for String {
    type Within = usize;

    fn read(value: &Value, at: &str, longest: &usize, faults: &mut Vec<Fault>) -> Option<Self> {
        let good = |text: &&str| {
            !text.trim().is_empty()
                && text.chars().count() <= *longest
                && !text.chars().any(char::is_control)
        };
        let text = value.as_str().filter(good);
        if text.is_none() {
            let detail = format!(
                "must be a text of 1 to {longest} characters without control characters; it is {}",
                shown(value)
            );
            Fault::add(faults, at, detail);
        }
        text.map(str::to_owned)
    }

    fn write(&self) -> Option<Value> {
        Some(self.as_str().into())
    }

    fn schema(longest: &usize, _: &mut Schemas) -> Value {
        json!({"type": "string", "minLength": 1, "maxLength": longest, "pattern": PLAIN_TEXT})
    }
}

impl Field for bool {
    type Within = ();

    fn read(value: &Value, at: &str, (): &(), faults: &mut Vec<Fault>) -> Option<Self> {
        let flag = value.as_bool();
        if flag.is_none() {
            let detail = format!("must be true or false; it is {}", shown(value));
            Fault::add(faults, at, detail);
        }
        flag
    }

    fn write(&self) -> Option<Value> {
        Some((*self).into())
    }

    fn schema((): &(), _: &mut Schemas) -> Value {
        json!({"type": "boolean"})
    }
}

impl<T: Field> Field for Option<T> {
    type Within = T::Within;

    fn read(value: &Value, at: &str, within: &T::Within, faults: &mut Vec<Fault>) -> Option<Self> {
        T::read(value, at, within, faults).map(Some)
    }

    fn write(&self) -> Option<Value> {
        self.as_ref()?.write()
    }

    fn schema(within: &T::Within, schemas: &mut Schemas) -> Value {
        T::schema(within, schemas)
    }
}

/// Reads a name, which can't be left out.
pub fn read_name(
    fields: &Fields<'_>,
    field: &str,
    longest: usize,
    faults: &mut Vec<Fault>,
) -> Option<String> {
    let (value, at) = fields.required(field, "a short text", faults)?;
    String::read(value, &at, &longest, faults)
}
