//! Readouts of the points of a run.

use fem_client::scene::Scene;
use fem_client::solver::Readout;
use serde_json::Value;

/// A run's readout, point by point: where the map lies is read at the cut point, and where it has moved to on the lines through that.
///
/// Off the lines nobody asks for it, and it would be most of what such a point takes to store.
pub(crate) struct PointReadouts<'r> {
    readout: &'r Readout,
    scenes: &'r [Scene],
    /// The cut point's scene, where there is a map.
    cut: Option<Value>,
}

impl<'r> PointReadouts<'r> {
    /// Begins with scenes whose first one is the cut point's.
    pub(crate) fn new(readout: &'r Readout, scenes: &'r [Scene]) -> Self {
        let cut = scenes.first().filter(|_| readout.grid.is_some());
        Self {
            readout,
            scenes,
            cut: cut.map(Scene::to_value),
        }
    }

    /// Returns the readout of the point with this ordinal.
    pub(crate) fn of(&self, ordinal: usize) -> Readout {
        let has_map = self.cut.is_some();
        let on_line = |cut: &Value| differences(cut, &self.scenes[ordinal].to_value()) == 1;
        Readout {
            shape: ordinal == 0 && has_map,
            positions: ordinal > 0 && self.cut.as_ref().is_some_and(on_line),
            ..self.readout.clone()
        }
    }
}

/// Counts the numbers or texts in which two documents differ; a part that one of them lacks is one.
fn differences(a: &Value, b: &Value) -> usize {
    match (a, b) {
        (Value::Object(a), Value::Object(b)) => {
            let both = a.iter().map(|(name, a)| match b.get(name) {
                Some(b) => differences(a, b),
                None => 1,
            });
            let of_b = b.keys().filter(|name| !a.contains_key(*name)).count();
            both.sum::<usize>() + of_b
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            a.iter().zip(b).map(|(a, b)| differences(a, b)).sum()
        }
        _ => usize::from(a != b),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use document::Format;
    use documents::study::plan::Plan;
    use documents::study::{Study, presets};

    #[test]
    fn the_map_s_places_are_read_on_the_lines_and_nowhere_else() {
        let text = presets()[0].1;
        let study = Study::from_document(text, Format::Toml, &|path| Err(path.to_owned())).unwrap();
        let plan = Plan::new(&study).unwrap();
        let readout = study.readout();
        let readouts = PointReadouts::new(&readout, &plan.points);
        let all = |pick: fn(&Readout) -> bool| -> Vec<usize> {
            let chosen = |ordinal: &usize| pick(&readouts.of(*ordinal));
            (0..plan.points.len()).filter(chosen).collect()
        };
        assert_eq!(all(|readout| readout.shape), [0]);
        // Four nodes beside the shared one on each of five lines; five check points off them.
        let moved = all(|readout| readout.positions);
        assert_eq!(moved, (1..=20).collect::<Vec<_>>());
        let without_map = Readout::default();
        let readouts = PointReadouts::new(&without_map, &plan.points);
        assert_eq!(readouts.of(1), without_map);
    }
}
