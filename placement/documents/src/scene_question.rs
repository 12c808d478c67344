//! A scene to be solved once, and what is read of it.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Value;
use document::fault::{Fault, member};
use document::fields::Fields;
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use document::typed::lists::distinct_list;
use document::typed::table_fields::{read_table, table_schema};
use fem_client::scene::Scene;
use fem_client::solver::gauge::{self, Gauge};
use fem_client::solver::{Readout, sides};
use serde_json::json;

use crate::parts::scene_reader::{Resolve, scene, scene_schema};

/// Most gauges of a question.
const MOST_GAUGES: usize = 100;
/// Most derivatives of a question. Five take 1.3 times their solve on the reference mesh, so that all of these take less than a minute.
const MOST_DERIVATIVES: usize = 50;
/// Longest path of a number, characters.
const LONGEST_PATH: usize = 100;

/// A scene to be solved once, and what is read of it.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneQuestion {
    /// The scene.
    pub scene: Scene,
    /// Gauges and derivatives that are asked for.
    pub readout: Readout,
}

impl SceneQuestion {
    /// Reads `{"scene": {"preset": "foot-tire"}, "gauges": [{"theta_deg": 0, "phi_deg": 45}], "derivatives": ["pressure.internal_mpa"]}`.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_value(value: &Value, resolve: Resolve<'_>) -> Result<Self, Vec<Fault>> {
        let mut faults = Vec::new();
        let known = ["scene", "gauges", "derivatives"];
        let question = Fields::open(value, "", &known, &mut faults)
            .and_then(|fields| read(&fields, resolve, &mut faults));
        match question {
            Some(question) if faults.is_empty() => Ok(question),
            _ => Err(faults),
        }
    }
}

fn read(
    fields: &Fields<'_>,
    resolve: Resolve<'_>,
    faults: &mut Vec<Fault>,
) -> Option<SceneQuestion> {
    let scene = scene(fields, resolve, faults);
    let gauges = match fields.get("gauges") {
        None => Some(Vec::new()),
        Some((value, at)) => distinct_list(value, &at, MOST_GAUGES, faults, read_table::<Gauge>),
    };
    let derivatives = match fields.get("derivatives") {
        None => Some(Vec::new()),
        Some((value, at)) => {
            distinct_list(value, &at, MOST_DERIVATIVES, faults, |value, at, faults| {
                String::read(value, at, &LONGEST_PATH, faults)
            })
        }
    };
    let (scene, gauges, derivatives) = (scene?, gauges?, derivatives?);
    faults.extend(gauge::faults(&gauges, &scene));
    faults.extend(in_question(sides::faults(&derivatives, &scene)));
    Some(SceneQuestion {
        scene,
        readout: Readout {
            gauges,
            derivatives,
            ..Readout::default()
        },
    })
}

/// Faults of a solver, which has scene and readout apart, at their places in the question.
pub fn in_question(faults: Vec<Fault>) -> Vec<Fault> {
    let placed = |fault: Fault| match ["/gauges", "/derivatives"]
        .iter()
        .any(|list| fault.pointer.starts_with(list))
    {
        true => fault,
        false => Fault {
            pointer: format!("{}{}", member("", "scene"), fault.pointer),
            ..fault
        },
    };
    faults.into_iter().map(placed).collect()
}

/// The schema of a question.
pub fn scene_question_schema(schemas: &mut Schemas) -> Value {
    schemas.define("SceneQuestion", |schemas| {
        let mut question = Properties::default();
        let doc = "The scene: its tables, or a shipped one with changes, as `{\"preset\": \"foot-tire\"}`.";
        let scene = scene_schema(schemas);
        question.add_required("scene", doc, scene);
        let gauge = table_schema::<Gauge>(schemas);
        let gauges = json!({"type": "array", "maxItems": MOST_GAUGES, "items": gauge});
        let doc = "Points of the inner surface where the strain is read, each along a direction.";
        question.add("gauges", doc, gauges, None, false);
        let path = String::schema(&LONGEST_PATH, schemas);
        let paths = json!({"type": "array", "maxItems": MOST_DERIVATIVES, "items": path});
        let doc = "Numbers of the scene by which the answer is differentiated, by path, as `ground.depths_mm[2]`.";
        question.add("derivatives", doc, paths, None, false);
        question.table("A scene to be solved once, and what is read of it.")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(document: &Value) -> Result<SceneQuestion, Vec<(String, String)>> {
        let no_files = |_: &str| Err("no files".to_owned());
        SceneQuestion::from_value(document, &no_files).map_err(|faults| {
            let told = faults
                .into_iter()
                .map(|fault| (fault.pointer, fault.detail));
            told.collect()
        })
    }

    #[test]
    fn a_question_has_a_scene_and_what_is_read_of_it() {
        let question = read(&json!({
            "scene": {"preset": "foot-tire", "pressure": {"internal_mpa": 0.15}},
            "gauges": [{"theta_deg": -10, "phi_deg": 45}, {"theta_deg": 0, "phi_deg": 0, "angle_deg": 90}],
            "derivatives": ["pressure.internal_mpa"],
        }));
        let question = question.expect("a question");
        assert_eq!(question.scene.pressure.internal_mpa, 0.15);
        let angles: Vec<f64> = question
            .readout
            .gauges
            .iter()
            .map(|gauge| gauge.angle_deg)
            .collect();
        assert_eq!(angles, [0.0, 90.0]);
        assert_eq!(question.readout.derivatives, ["pressure.internal_mpa"]);
        let bare = read(&json!({"scene": {"preset": "foot-tire"}})).expect("a scene alone");
        assert_eq!(bare.readout, Readout::default());
    }

    #[test]
    fn all_faults_are_named_at_once_at_their_places() {
        let faults = read(&json!({
            "scene": {"preset": "foot-tire", "contact": {"friction": 0.5}},
            "gauges": [{"theta_deg": 0, "phi_deg": 150}],
            "derivatives": ["pressure.internal_mpa", "no.such"],
        }));
        let faults = faults.expect_err("faults");
        let pointers: Vec<&str> = faults.iter().map(|(pointer, _)| pointer.as_str()).collect();
        assert_eq!(
            pointers,
            [
                "/gauges/0/phi_deg",
                "/derivatives/1",
                "/scene/contact/friction"
            ]
        );

        let faults = read(&json!({
            "scene": "tire.toml", "gauge": [],
            "gauges": [{"theta_deg": "x"}, 3], "derivatives": ["a", "a", ""],
        }));
        let faults = faults.expect_err("faults");
        let pointers: Vec<&str> = faults.iter().map(|(pointer, _)| pointer.as_str()).collect();
        let expected = [
            "/gauge",
            "/scene",
            "/gauges/0/theta_deg",
            "/gauges/0/phi_deg",
            "/gauges/1",
            "/derivatives/1",
            "/derivatives/2",
        ];
        assert_eq!(pointers, expected);
    }
}
