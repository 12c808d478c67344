//! Tables of answers in the description: their columns, each with the description of the field that it shows.
//!
//! They stand under `x-tables`: OpenAPI has no word for them. Generators of clients' tables read them there.

use results::columns::{Column, Table, tables};
use serde_json::{Map, Value, json};

/// Every table: the parts that its rows are made of, and its columns.
pub fn described_tables(schemas: &Value) -> Value {
    let described = |table: Table| {
        let columns: Vec<Value> = table
            .columns
            .iter()
            .map(|column| described(&table, column, schemas))
            .collect();
        let parts: Map<String, Value> = table
            .parts
            .iter()
            .map(|(name, schema)| ((*name).to_owned(), json!(schema)))
            .collect();
        (
            table.name.to_owned(),
            json!({"parts": parts, "columns": columns}),
        )
    };
    Value::Object(tables().into_iter().map(described).collect())
}

fn described(table: &Table, column: &Column, schemas: &Value) -> Value {
    let mut value = json!(column);
    value["exported"] = column.is_exported.into();
    if let Some(described) = description(table, &column.at, schemas) {
        value["description"] = described;
    }
    value
}

/// Finds what the schema of a pointer's field says of it; `None` where it says nothing, or there is no such field.
fn description(table: &Table, at: &str, schemas: &Value) -> Option<Value> {
    let mut steps = at.split('/').skip(1);
    let part = steps.next()?;
    let (_, schema) = table.parts.iter().find(|(name, _)| *name == part)?;
    let mut schema = &schemas[*schema];
    let mut described = schema.get("description");
    for step in steps {
        let own = field(schema, step, schemas)?;
        // An item of a list is described by the list.
        described = own.get("description").or(described);
        schema = own;
    }
    described.cloned()
}

/// The schema of a field, or of an item, of what a schema stands for.
fn field<'s>(schema: &'s Value, name: &str, schemas: &'s Value) -> Option<&'s Value> {
    if let Some(referred) = schema["$ref"].as_str() {
        return field(&schemas[referred.rsplit('/').next()?], name, schemas);
    }
    let own = schema["properties"].get(name);
    let item = || {
        name.parse::<usize>().ok()?;
        schema["prefixItems"].get(0).or_else(|| schema.get("items"))
    };
    let of_variant = || {
        let variants = ["oneOf", "anyOf", "allOf"].into_iter();
        let mut variants = variants
            .filter_map(|word| schema[word].as_array())
            .flatten();
        variants.find_map(|variant| field(variant, name, schemas))
    };
    own.or_else(item).or_else(of_variant)
}
