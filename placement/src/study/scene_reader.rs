//! Reads the scene that a document names or holds.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use fem_client::document::Format;
use fem_client::document::fault::{Fault, member};
use fem_client::document::fields::{Fields, choice, shown};
use fem_client::scene::{PRESETS, Scene};
use serde_json::Value;

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
