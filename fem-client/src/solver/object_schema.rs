//! Schemas of objects whose fields aren't those of their type: what a value per direction, or a table, is flattened to.

use utoipa::openapi::schema::{ObjectBuilder, OneOfBuilder, Schema, SchemaType};
use utoipa::openapi::{KnownFormat, Ref, RefOr, SchemaFormat};

pub use utoipa::openapi::Type;

/// Describes an object field by field, in their order in documents.
pub struct ObjectSchema(ObjectBuilder);

impl ObjectSchema {
    /// An object without fields.
    pub fn new(description: &str) -> Self {
        Self(ObjectBuilder::new().description(Some(description)))
    }

    /// A field that is always there.
    #[must_use]
    pub fn required(self, kind: Type, name: &str, description: &str) -> Self {
        let field = of_kind(kind.clone(), kind.into(), description);
        Self(self.0.property(name, field).required(name))
    }

    /// A field that is always there, and may be null.
    #[must_use]
    pub fn nullable(self, kind: Type, name: &str, description: &str) -> Self {
        let or_null = SchemaType::from_iter([kind.clone(), Type::Null]);
        let field = of_kind(kind, or_null, description);
        Self(self.0.property(name, field).required(name))
    }

    /// A field that may be missing, an object with a schema of this name.
    #[must_use]
    pub(crate) fn optional_object(self, schema: &str, name: &str, description: &str) -> Self {
        let mut object = Ref::from_schema_name(schema);
        object.description = description.to_owned();
        let null = ObjectBuilder::new().schema_type(Type::Null);
        let field = OneOfBuilder::new().item(object).item(null);
        Self(self.0.property(name, field))
    }

    /// The schema.
    pub fn schema(self) -> RefOr<Schema> {
        self.0.into()
    }
}

/// Numbers are doubles, whole numbers counts.
fn of_kind(kind: Type, schema_type: SchemaType, description: &str) -> ObjectBuilder {
    let field = ObjectBuilder::new()
        .schema_type(schema_type)
        .description(Some(description));
    match kind {
        Type::Number => field.format(Some(SchemaFormat::KnownFormat(KnownFormat::Double))),
        Type::Integer => field.minimum(Some(0)),
        _ => field,
    }
}
