//! Reads a number as a scene has it.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use fem_client::scene::Scene;
use serde_json::Value;

/// Reads a number as a scene reads the field at this path.
pub(crate) fn of_scene(
    path: &str,
    value: &Value,
    pointer: &str,
    faults: &mut Vec<Fault>,
) -> Option<f64> {
    let mut scene = Scene::default();
    let read = scene.set(path, value).and_then(|()| scene.number_at(path));
    read.inspect_err(|fault| Fault::add(faults, pointer, fault.detail.clone()))
        .ok()
}
