//! Derives for documents: what a type says once is its reader, its canonical text, its default and its JSON Schema.
//!
//! ```ignore
//! /// What measures the forces.
//! #[derive(Table)]
//! pub struct ForceSensor {
//!     /// Readings a second by its own clock, Hz.
//!     #[field(default = 200.0, within = RATE)]
//!     pub rate_hz: f64,
//! }
//! ```
//!
//! The traits are those of `document::typed`, and their page says what each attribute means.

mod attributes;
mod derive_choice;
mod derive_table;
mod derive_variants;
mod described;

use proc_macro::TokenStream;
use syn::{DeriveInput, parse_macro_input};

/// A struct whose fields are those of a table: `Table`, `Field` and `Default`.
///
/// - `#[field(default = EXPRESSION)]`: what an absent field is; without it the type's own default
/// - `#[field(within = EXPRESSION)]`: what bounds it, a `Field::Within`
/// - `#[field(required = "what it is")]`: a document that lacks it is faulty
/// - `#[field(nullable)]`: `null` is the same as absent
/// - `#[field(omitted)]`: the canonical text leaves it out where it is the default
/// - `#[field(with = MODULE)]`: read, written and described by functions of this module
/// - `#[field(group)]`: several fields of the same table, by `Group`; `#[field(group = MODULE)]`: by functions of this module
/// - `#[table(rule = FUNCTION)]`: a rule of the whole table, `fn(&Self, &Fields, faults) -> Option<()>`
/// - `#[table(rule = FUNCTION(FIELD, FIELD))]`: a rule between these fields, asked whatever is wrong with others
/// - `#[table(then = FUNCTION)]`: what follows from the fields that are given, `fn(Self, &Fields) -> Self`
/// - `#[table(name = "NAME")]`: the name of the definition in a schema, where it isn't that of the struct
/// - `#[table(before = FUNCTION)]`: what ends reading before any field is looked at
/// - `#[table(told = [NAMES])]`: the names of the fields in the order of faults, where it isn't that of the struct
#[proc_macro_derive(Table, attributes(table, field))]
pub fn derive_table(input: TokenStream) -> TokenStream {
    answer(derive_table::derive(parse_macro_input!(
        input as DeriveInput
    )))
}

/// An enum without fields that stands in documents as its name, in kebab case or as `#[choice("name")]` says: `Choice`, `Field`, serde and its schema.
#[proc_macro_derive(Choice, attributes(choice))]
pub fn derive_choice(input: TokenStream) -> TokenStream {
    answer(derive_choice::derive(parse_macro_input!(
        input as DeriveInput
    )))
}

/// An enum whose variants are kinds of one table, told apart by the field `#[variants(tag = "kind")]`: `Variants`.
#[proc_macro_derive(Variants, attributes(variants, field, choice))]
pub fn derive_variants(input: TokenStream) -> TokenStream {
    answer(derive_variants::derive(parse_macro_input!(
        input as DeriveInput
    )))
}

fn answer(made: syn::Result<proc_macro2::TokenStream>) -> TokenStream {
    made.unwrap_or_else(|error| error.into_compile_error())
        .into()
}
