//! Types as they stand in documents: read with every fault, written canonically, described by a schema.
//!
//! `Table`, `Choice` and `Variants` are derived. A field's name, default, bounds with their unit, and doc comment stand once, on the field; its reader, the
//! canonical text, the default of the struct and the JSON Schema follow. Rules between fields are functions: `#[table(check = ...)]`.
//!
//! - [`field_value`]: the value of a field, and plain ones; [`lists`]: lists
//! - [`table_fields`]: a struct as a table
//! - [`named_choice`]: an enum by its names; [`kinds`]: an enum of kinds of a table

pub mod field_value;
pub mod kinds;
pub mod lists;
pub mod named_choice;
pub mod table_fields;
