//! Checks that a scene's contact is the usual one: upright, on plane ground that isn't dragged.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use fem_client::scene::Scene;

/// Adds a fault for each way in which the scene's contact is another one; what is about the usual one stands `at` a place, and `is` or `are` about that.
pub(super) fn check_usual(scene: &Scene, at: &str, is: &str, faults: &mut Vec<Fault>) {
    if scene.ground.is_dragged() {
        let detail = format!(
            "{is} about ground that isn't dragged: the scene's ground.shift_mm must be left out"
        );
        Fault::add(faults, at, detail);
    }
    if scene.ground.leans() {
        let detail =
            format!("{is} about an upright wheel: the scene's ground.camber_deg must be left out");
        Fault::add(faults, at, detail);
    }
    if scene.ground.profile.is_some() {
        let detail =
            format!("{is} about plane ground: the scene's ground.profile must be left out");
        Fault::add(faults, at, detail);
    }
}
