//! Content keys of points, under which an archive keeps them.

use std::collections::BTreeMap;

use fem_client::scene::Scene;
use fem_client::solver::{Readout, Solver};

use super::point_readouts::PointReadouts;
use super::starts::Starts;
use documents::study::sha256_hex;

/// Content keys: SHA-256 over all that determines an outcome to the bit, which is the solver's version, the scene, the
/// readout and the start. The cut point starts from scratch, each other one from a point for which its key stands.
pub(crate) fn keys<'k>(
    scenes: &'k [Scene],
    starts: &'k Starts,
    solver: &dyn Solver,
    readout: &'k Readout,
) -> impl Iterator<Item = String> + 'k {
    let version = solver.version();
    let readouts = PointReadouts::new(readout, scenes);
    let key = move |ordinal: usize, start: &str| {
        let (scene, readout) = (scenes[ordinal].to_value(), readouts.of(ordinal));
        let content = serde_json::json!({
            "solver": version, "scene": scene, "readout": readout, "start": start,
        });
        sha256_hex(&content.to_string())
    };
    let mut left = BTreeMap::new();
    (0..scenes.len()).map(move |ordinal| {
        let start = starts.of(ordinal).and_then(|start| left.get(&start));
        let own = key(ordinal, start.map_or("scratch", String::as_str));
        if starts.is_left(ordinal) {
            left.insert(ordinal, own.clone());
        }
        own
    })
}
