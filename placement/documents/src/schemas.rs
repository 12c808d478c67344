//! JSON Schemas of all documents, by name.

use document::json_schema::Schemas;
use document::typed::field_value::Field;
use document::{Choice, Value};
use estimation::recipe::Recipe;
use fem_client::scene::Scene;

use crate::own_model::inputs_document::inputs_file_schema;
use crate::study::study_schema::study_schema;
use crate::sweep::sweep_schema::sweep_schema;

/// Documents that users write.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
pub enum DocumentKind {
    /// A study: what varies, and what is asked.
    Study,
    /// A scene: what is pressed, and how.
    Scene,
    /// A sweep: a study, and what its designs set otherwise.
    Sweep,
    /// A recipe of `strainsite force fit`.
    Recipe,
    /// Inputs of `strainsite gsa`.
    Gsa,
}

impl DocumentKind {
    /// The JSON Schema of the document, draft 2020-12, with every bound, default, unit and description.
    pub fn schema(self) -> Value {
        let mut schemas = Schemas::default();
        let root = self.root(&mut schemas);
        schemas.document(&format!("strainsite {}", self.as_str()), &root)
    }

    /// A reference to the document among the definitions that it needs.
    pub fn root(self, schemas: &mut Schemas) -> Value {
        match self {
            Self::Study => study_schema(schemas),
            Self::Scene => Scene::schema(&(), schemas),
            Self::Sweep => sweep_schema(schemas),
            Self::Recipe => Recipe::schema(&(), schemas),
            Self::Gsa => inputs_file_schema(schemas),
        }
    }
}
