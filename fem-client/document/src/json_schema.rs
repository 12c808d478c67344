//! JSON Schemas of documents, draft 2020-12.
//!
//! A unit stands in `x-unit`, as JSON Schema has no word for it.

use serde_json::{Value, json};

use crate::fields::{Map, Range};

/// Definitions that a schema refers to, each once.
#[derive(Debug)]
pub struct Schemas {
    definitions: Map,
    place: &'static str,
    suffix: &'static str,
}

impl Default for Schemas {
    /// Definitions of a document of their own.
    fn default() -> Self {
        Self::referred("#/$defs/", "")
    }
}

impl Schemas {
    /// Definitions that are found at a place, their names with a suffix.
    pub fn referred(place: &'static str, suffix: &'static str) -> Self {
        Self {
            definitions: Map::new(),
            place,
            suffix,
        }
    }

    /// A reference to a definition, which is made at its first use.
    pub fn define(&mut self, name: &str, made: impl FnOnce(&mut Self) -> Value) -> Value {
        let name = format!("{name}{}", self.suffix);
        if !self.definitions.contains_key(&name) {
            self.definitions.insert(name.clone(), Value::Null);
            let definition = made(self);
            self.definitions.insert(name.clone(), definition);
        }
        json!({"$ref": format!("{}{name}", self.place)})
    }

    /// All definitions by name.
    pub fn definitions(self) -> Map {
        self.definitions
    }

    /// The schema of a whole document: a reference with the definitions that it needs.
    pub fn document(self, title: &str, root: &Value) -> Value {
        let mut schema = Map::new();
        schema.insert(
            "$schema".to_owned(),
            "https://json-schema.org/draft/2020-12/schema".into(),
        );
        schema.insert("title".to_owned(), title.into());
        if let Value::Object(root) = root {
            schema.extend(root.clone());
        }
        schema.insert("$defs".to_owned(), Value::Object(self.definitions));
        Value::Object(schema)
    }
}

/// The fields of a table.
#[derive(Debug, Default, Clone)]
pub struct Properties {
    properties: Map,
    required: Vec<Value>,
    /// Kinds of which a table has one: the fields that each has besides, first the usual one.
    kinds: Vec<Self>,
    /// Fields of which a table has one at most.
    exclusive: Vec<Vec<&'static str>>,
}

impl Properties {
    /// Adds a field that may be absent.
    pub fn add(
        &mut self,
        name: &str,
        doc: &str,
        schema: Value,
        default: Option<Value>,
        nullable: bool,
    ) {
        let schema = match nullable {
            true => json!({"anyOf": [schema, {"type": "null"}]}),
            false => schema,
        };
        let mut schema = told(doc, schema);
        if let (Some(default), Value::Object(schema)) = (default, &mut schema) {
            schema.insert("default".to_owned(), default);
        }
        self.properties.insert(name.to_owned(), schema);
    }

    /// Adds a field that must be there.
    pub fn add_required(&mut self, name: &str, doc: &str, schema: Value) {
        self.properties.insert(name.to_owned(), told(doc, schema));
        self.required.push(name.into());
    }

    /// Adds the fields of another table, but for some.
    pub fn add_all(&mut self, other: Self, but: &[&str]) {
        let others = other.properties.into_iter();
        self.properties
            .extend(others.filter(|(name, _)| !but.contains(&name.as_str())));
    }

    /// Adds a kind of table, of which each table is one: its name in the field `tag`, what it means, and the fields that it has besides. A table that names none
    /// is of the usual kind.
    pub fn add_kind(&mut self, tag: &str, name: &str, doc: &str, own: Self, is_usual: bool) {
        let mut kind = Self::default();
        match is_usual {
            true => kind.add(tag, doc, json!({"const": name}), Some(name.into()), false),
            false => kind.add_required(tag, doc, json!({"const": name})),
        }
        kind.properties.extend(own.properties);
        kind.required.extend(own.required);
        self.kinds.push(kind);
    }

    /// Says that a table has one of these fields at most.
    pub fn exclude(&mut self, names: &[&'static str]) {
        self.exclusive.push(names.to_vec());
    }

    /// The schema of the table; no other fields are allowed.
    pub fn table(self, doc: &str) -> Value {
        if self.kinds.is_empty() {
            return self.closed(doc);
        }
        let kinds = self.kinds.iter().map(|kind| {
            let mut all = Self {
                kinds: Vec::new(),
                properties: kind.properties.clone(),
                required: [kind.required.clone(), self.required.clone()].concat(),
                exclusive: self.exclusive.clone(),
            };
            all.properties.extend(self.properties.clone());
            all.closed("")
        });
        json!({"description": doc, "oneOf": kinds.collect::<Vec<_>>()})
    }

    fn closed(self, doc: &str) -> Value {
        let mut table = Map::new();
        if !doc.is_empty() {
            table.insert("description".to_owned(), doc.into());
        }
        table.insert("type".to_owned(), "object".into());
        table.insert("properties".to_owned(), Value::Object(self.properties));
        table.insert("additionalProperties".to_owned(), false.into());
        if !self.required.is_empty() {
            table.insert("required".to_owned(), Value::Array(self.required));
        }
        let pairs = self.exclusive.iter().flat_map(|names| {
            let pairs = names.iter().enumerate();
            pairs.flat_map(|(k, a)| names.iter().skip(k + 1).map(move |b| [*a, *b]))
        });
        let forbidden: Vec<Value> = pairs
            .map(|pair| json!({"not": {"required": pair}}))
            .collect();
        if !forbidden.is_empty() {
            table.insert("allOf".to_owned(), Value::Array(forbidden));
        }
        Value::Object(table)
    }
}

/// A schema with what a field says of it.
fn told(doc: &str, schema: Value) -> Value {
    match schema {
        Value::Object(mut schema) => {
            let what = schema.remove("description");
            let text = match what.as_ref().and_then(Value::as_str) {
                Some(what) if !doc.is_empty() => format!("{doc} {what}"),
                Some(what) => what.to_owned(),
                None => doc.to_owned(),
            };
            let mut described = Map::new();
            if !text.is_empty() {
                described.insert("description".to_owned(), text.into());
            }
            described.extend(schema);
            Value::Object(described)
        }
        other => other,
    }
}

impl Range {
    /// The schema of a number within it.
    pub fn schema(&self) -> Value {
        let mut schema = json!({"type": "number", "minimum": self.low, "maximum": self.high});
        if let (false, Value::Object(schema)) = (self.unit.is_empty(), &mut schema) {
            schema.insert("x-unit".to_owned(), self.unit.into());
        }
        schema
    }
}
