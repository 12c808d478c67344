//! A struct as a table, and several fields of a table as one value.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde_json::Value;

use crate::fault::Fault;
use crate::fields::{Fields, Map};
use crate::json_schema::{Properties, Schemas};
use crate::typed::field_value::Field;

/// A struct whose fields are those of a table.
pub trait Table: Field<Within = ()> {
    /// Name of the definition in a schema.
    const NAME: &'static str;
    /// Sentence that says what the table is.
    const DOC: &'static str;

    /// Names of the fields that this table may have, in the order in which they are told.
    fn names(value: &Value) -> Vec<&'static str>;

    /// Reads the fields of an open table; None after a fault.
    fn read_fields(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Self>;

    /// Puts the fields of the canonical text into a table.
    fn write_fields(&self, table: &mut Map);

    /// Describes the fields.
    fn describe(properties: &mut Properties, schemas: &mut Schemas);
}

/// Several fields of a table that are one value.
pub trait Group: Sized {
    /// Names of its fields in this table; `usual` is what it is without any.
    fn names(value: &Value, usual: &Self) -> Vec<&'static str>;

    /// Reads the fields of an open table; None after a fault.
    fn read_fields(fields: &Fields<'_>, usual: Self, faults: &mut Vec<Fault>) -> Option<Self>;

    /// Puts the fields of the canonical text into a table.
    fn write_fields(&self, table: &mut Map);

    /// Describes the fields.
    fn describe(usual: &Self, properties: &mut Properties, schemas: &mut Schemas);
}

/// Reads a table; None after a fault.
pub fn read_table<T: Table>(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<T> {
    let fields = Fields::open(value, at, &T::names(value), faults)?;
    T::read_fields(&fields, faults)
}

/// A table in its canonical form.
pub fn table_value<T: Table>(table: &T) -> Value {
    let mut map = Map::new();
    table.write_fields(&mut map);
    Value::Object(map)
}

/// A reference to the definition of a table, which is made at its first use.
pub fn table_schema<T: Table>(schemas: &mut Schemas) -> Value {
    schemas.define(T::NAME, |schemas| {
        let mut properties = Properties::default();
        T::describe(&mut properties, schemas);
        properties.table(T::DOC)
    })
}

/// Reads a field that may be absent.
pub fn optional<T>(
    fields: &Fields<'_>,
    name: &str,
    nullable: bool,
    default: impl FnOnce() -> T,
    faults: &mut Vec<Fault>,
    read: impl FnOnce(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<T> {
    match fields.get(name) {
        None => Some(default()),
        Some((Value::Null, _)) if nullable => Some(default()),
        Some((value, at)) => read(value, &at, faults),
    }
}

/// Reads a field that must be there; `what` says what it is.
pub fn required<T>(
    fields: &Fields<'_>,
    name: &str,
    what: &str,
    faults: &mut Vec<Fault>,
    read: impl FnOnce(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<T> {
    let (value, at) = fields.required(name, what, faults)?;
    read(value, &at, faults)
}
