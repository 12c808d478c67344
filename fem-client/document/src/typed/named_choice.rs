//! An enum that stands in documents as its name.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};
use utoipa::openapi::{ObjectBuilder, RefOr, Schema, Type};

use crate::fields::alternatives;

/// An enum that stands in documents as its name.
pub trait Choice: Copy + 'static {
    /// Names in documents with what they stand for.
    const CHOICES: &'static [(&'static str, Self)];
    /// Meaning of each, in the same order.
    const MEANINGS: &'static [&'static str];
}

/// The schema of a choice, with what each name means.
pub fn choice_schema<T: Choice>() -> Value {
    let names: Vec<&str> = T::CHOICES.iter().map(|choice| choice.0).collect();
    let meanings = names.iter().zip(T::MEANINGS);
    let told: Vec<String> = meanings
        .filter(|(_, meaning)| !meaning.is_empty())
        .map(|(name, meaning)| format!("`{name}`: {meaning}"))
        .collect();
    json!({"type": "string", "enum": names, "description": told.join(" ")})
}

/// A choice by its name, for answers that are read back.
///
/// # Errors
/// When there is none of this name.
pub fn deserialize_choice<'de, D: Deserializer<'de>, T: Choice>(
    deserializer: D,
) -> Result<T, D::Error> {
    let name = String::deserialize(deserializer)?;
    let found = T::CHOICES.iter().find(|(choice, _)| *choice == name);
    found.map(|(_, choice)| *choice).ok_or_else(|| {
        let names = alternatives(T::CHOICES.iter().map(|choice| choice.0));
        serde::de::Error::custom(format!("must be {names}; it is {name:?}"))
    })
}

/// A choice in the description of the service.
pub fn open_api_choice<T: Choice>(doc: &str) -> RefOr<Schema> {
    ObjectBuilder::new()
        .schema_type(Type::String)
        .enum_values(Some(T::CHOICES.iter().map(|choice| choice.0)))
        .description(Some(doc))
        .into()
}
