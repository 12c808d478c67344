//! An enum whose variants are kinds of one table.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use serde_json::Value;

use crate::fault::Fault;
use crate::fields::{Fields, Map, alternatives, shown};
use crate::json_schema::{Properties, Schemas};

/// An enum whose variants are kinds of one table, told apart by the field [`Self::TAG`].
pub trait Variants: Sized + Clone {
    /// The field that names the kind.
    const TAG: &'static str;

    /// Returns each kind once, with its defaults.
    fn all() -> Vec<Self>;

    /// The first kind, with its defaults.
    fn usual() -> Self;

    /// The kind of this name, with its defaults.
    fn of_name(name: &str) -> Option<Self> {
        Self::all()
            .into_iter()
            .find(|variant| variant.name() == name)
    }

    /// The kind's name in documents.
    fn name(&self) -> &'static str;

    /// The fields that only this kind has.
    fn own_names(&self) -> &'static [&'static str];

    /// Reads the fields of this kind, whose values are the defaults; None after a fault.
    fn read_own(self, fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Self>;

    /// Puts the fields of this kind into a table.
    fn write_own(&self, table: &mut Map);

    /// Name, meaning and fields of each kind.
    fn describe(schemas: &mut Schemas) -> Vec<(&'static str, &'static str, Properties)>;
}

/// The kind of this name, the usual one where there is no name. One that nobody knows is taken as one without fields of its own where there is such a one,
/// so that its name alone is at fault.
pub(crate) fn variant_of<V: Variants>(name: Option<&Value>, usual: V) -> V {
    let Some(name) = name else {
        return usual;
    };
    let named = name.as_str().and_then(V::of_name);
    let bare = || {
        let all = V::all().into_iter();
        all.into_iter()
            .find(|variant| variant.own_names().is_empty())
    };
    named.or_else(bare).unwrap_or(usual)
}

/// The names of the fields of the kind that a table names.
pub fn variant_names<V: Variants>(value: &Value, usual: &V) -> Vec<&'static str> {
    let variant = variant_of(value.get(V::TAG), usual.clone());
    [&[V::TAG], variant.own_names()].concat()
}

/// Reads the fields of the kind that a table names; None after a fault, which an unknown name is.
pub fn read_variant<V: Variants>(
    fields: &Fields<'_>,
    usual: V,
    faults: &mut Vec<Fault>,
) -> Option<V> {
    let name = fields.get(V::TAG);
    let variant = variant_of(name.as_ref().map(|(name, _)| *name), usual);
    let known = match name {
        Some((name, at)) if name.as_str() != Some(variant.name()) => {
            let names = alternatives(V::all().iter().map(V::name));
            Fault::add(
                faults,
                &at,
                format!("must be {names}; it is {}", shown(name)),
            );
            None
        }
        _ => Some(()),
    };
    let read = variant.read_own(fields, faults);
    known.and(read)
}

/// Puts a kind's name and fields into a table.
pub fn write_variant<V: Variants>(variant: &V, table: &mut Map) {
    table.insert(V::TAG.to_owned(), variant.name().into());
    variant.write_own(table);
}

/// Adds the kinds of an enum; a table that names none is of the usual kind.
pub fn describe_variants<V: Variants>(
    usual: &V,
    properties: &mut Properties,
    schemas: &mut Schemas,
) {
    for (name, doc, own) in V::describe(schemas) {
        let is_usual = usual.name() == name;
        properties.add_kind(V::TAG, name, doc, own, is_usual);
    }
}

/// Reads a table that has nothing but the fields of its kind.
pub fn read_kind<V: Variants>(value: &Value, at: &str, faults: &mut Vec<Fault>) -> Option<V> {
    let usual = V::usual();
    let fields = Fields::open(value, at, &variant_names(value, &usual), faults)?;
    read_variant(&fields, usual, faults)
}

/// The canonical form of such a table.
pub fn kind_value<V: Variants>(variant: &V) -> Value {
    let mut table = Map::new();
    write_variant(variant, &mut table);
    Value::Object(table)
}

/// A reference to the definition of such a table.
pub fn kind_schema<V: Variants>(name: &str, doc: &str, schemas: &mut Schemas) -> Value {
    schemas.define(name, |schemas| {
        let mut properties = Properties::default();
        describe_variants(&V::usual(), &mut properties, schemas);
        properties.table(doc)
    })
}
