//! Reads the scene that a document names or holds.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, member};
use document::fields::{Fields, choice, shown};
use document::json_schema::{Properties, Schemas};
use document::{Format, Table};
use fem_client::scene::{PRESETS, Scene};
use serde_json::{Value, json};

/// Gives the text of a scene file, or says why it can't be had.
pub type Resolve<'r> = &'r dyn Fn(&str) -> Result<String, String>;

/// Reads the field `scene`: a path, a table, or a preset with overrides.
pub(crate) fn scene(
    fields: &Fields<'_>,
    resolve: Resolve<'_>,
    faults: &mut Vec<Fault>,
) -> Option<Scene> {
    let what = "a path, a table, or { preset = \"foot-tire\" }";
    let (value, pointer) = fields.required("scene", what, faults)?;
    match value {
        Value::String(path) => scene_file(path, &pointer, resolve, faults),
        Value::Object(object) if object.contains_key("preset") => {
            let names = PRESETS.map(|(name, _)| (name, name));
            let name = choice(
                &object["preset"],
                &member(&pointer, "preset"),
                &names,
                faults,
            )?;
            let mut overrides = object.clone();
            overrides.shift_remove("preset");
            Scene::preset(name)?.overlaid(&overrides, &pointer, faults)
        }
        Value::Object(_) => Scene::from_value(value, &pointer, faults),
        other => {
            Fault::add(
                faults,
                &pointer,
                format!("must be {what}; it is {}", shown(other)),
            );
            None
        }
    }
}

fn scene_file(
    path: &str,
    pointer: &str,
    resolve: Resolve<'_>,
    faults: &mut Vec<Fault>,
) -> Option<Scene> {
    let text = match resolve(path) {
        Ok(text) => text,
        Err(detail) => {
            Fault::add(faults, pointer, detail);
            return None;
        }
    };
    let name = path.escape_debug();
    match Scene::from_text(&text, Format::of_path(path)) {
        Ok(scene) => Some(scene),
        Err(found) => {
            for fault in found {
                let at = format!("{pointer}{}", fault.pointer);
                Fault::add(faults, &at, format!("in {name}: {}", fault.detail));
            }
            None
        }
    }
}

/// The schema of the field `scene`.
pub(crate) fn scene_schema(schemas: &mut Schemas) -> Value {
    let changed = schemas.define("ChangedScene", |schemas| {
        let mut properties = Properties::default();
        let names: Vec<&str> = PRESETS.iter().map(|(name, _)| *name).collect();
        let doc = "A shipped scene, over which the tables beside it are laid.";
        let preset = json!({"type": "string", "enum": names});
        properties.add("preset", doc, preset, None, false);
        Scene::describe(&mut properties, schemas);
        properties.table(Scene::DOC)
    });
    let path = json!({"type": "string", "description": "Path of a scene file, or a shipped scene's name."});
    json!({"anyOf": [changed, path]})
}
