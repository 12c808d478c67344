//! Examples of what the service is sent, and of what it answers other than JSON; answers are recorded by `lab/examples.py`.

use document::{Format, parse};
use serde_json::{Value, json};

const ID: &str = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b";

/// A small study, as TOML.
pub fn study_toml() -> &'static str {
    "name = \"two depths\"\nscene = { preset = \"foot-tire\" }\n\
     [[inputs]]\nname = \"P2\"\nvary = \"ground.depths_mm[1]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n\
     [[inputs]]\nname = \"P3\"\nvary = \"ground.depths_mm[2]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n\
     [method]\nkind = \"mdrm\"\nnodes = 3\n[accuracy]\npreset = \"draft\"\n"
}

/// The example's study as JSON.
pub fn study() -> Value {
    parse(study_toml(), Format::Toml).unwrap_or_default()
}

/// A scene with a gauge and two derivatives, as TOML.
pub fn scene_question_toml() -> &'static str {
    "derivatives = [\"pressure.internal_mpa\", \"ground.depths_mm[2]\"]\n\
     gauges = [{ theta_deg = 0, phi_deg = 45, angle_deg = 90 }]\n\
     [scene]\npreset = \"foot-tire\"\nmodel = { level = \"draft\" }\n"
}

/// The example's scene as JSON.
pub fn scene_question() -> Value {
    parse(scene_question_toml(), Format::Toml).unwrap_or_default()
}

/// A preview that nobody waits for any more.
pub fn superseded() -> Value {
    problem(409, "Conflict", "superseded: a newer preview was asked for")
}

/// A point of a study, as its stream tells it.
pub fn event() -> Value {
    let data = json!({"kind": "point-solved", "time": "2026-11-22T01:02:03.456Z", "ordinal": 3, "done": 4, "of": 10, "wall_s": 0.07, "newton_iterations": 5});
    json!({"id": "17", "event": "point-solved", "data": data.to_string()})
}

/// The first rows of a table.
pub fn csv() -> &'static str {
    "rank,name,input,gsi_x_percent,gsi_y_percent\n1,P3,P3,72.86,55.33\n"
}

/// The beginning of a Parquet file.
pub fn parquet() -> &'static str {
    "PAR1"
}

/// The beginning of a map's file.
pub fn vtu() -> &'static str {
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
}

/// The beginning of a glTF file.
pub fn glb() -> &'static str {
    "glTF"
}

/// The header of a surface, after its length.
pub fn surface() -> &'static str {
    "{\"study\":\"019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b\",\"level\":\"draft\",\"rows\":21,\"columns\":30,\"phi_deg\":[-120.0],\"theta_deg\":[-180.0],\"ground\":{\"x_mm\":[-50.0],\"z_mm\":[-49.0],\"camber_deg\":0.0},\"arrays\":[{\"name\":\"inner_inflated_mm\",\"unit\":\"mm\",\"components\":3,\"offset\":0,\"count\":630}]}"
}

/// A layout that somebody moves by hand.
pub fn hand_layouts() -> Value {
    json!({"layouts": [{"name": "mine", "films": [
        {"theta_deg": 0.0, "phi_deg": 0.0, "angle_deg": 90.0}, {"theta_deg": 40.0, "phi_deg": 0.0, "angle_deg": 0.0},
    ]}], "simulated": true})
}

/// Returns the layouts as TOML.
pub fn hand_layouts_toml() -> &'static str {
    "simulated = true\n[[layouts]]\nname = \"mine\"\nfilms = [{ theta_deg = 0, phi_deg = 0, angle_deg = 90 }, { theta_deg = 40, phi_deg = 0, angle_deg = 0 }]\n"
}

/// A model of two inputs, of which two points have values.
pub fn analysis() -> Value {
    json!({
        "inputs": [
            {"name": "force_n", "distribution": {"kind": "normal", "mean": 10.0, "std": 1.0}},
            {"name": "height_mm", "distribution": {"kind": "uniform", "min": 1.8, "max": 2.2}},
        ],
        "method": {"kind": "auto", "tolerance": 0.01},
        "values": {"outputs": ["strain"], "ids": [0, 1], "rows": [[1.07e-3], [9.1e-4]]},
    })
}

/// A study without layouts.
pub fn no_layouts() -> Value {
    problem(
        409,
        "Conflict",
        "the study asked for no layouts, so that nothing around the wheel is stored: add \"layouts\" to its document and run it again",
    )
}

/// Returns the answer to a request for something that isn't there.
pub fn absent() -> Value {
    problem(404, "Not Found", "there is no study \"x\"")
}

/// A study that goes with its sweep alone.
pub fn design() -> Value {
    problem(
        409,
        "Conflict",
        "the study is a design of the sweep x: remove that, DELETE /v1/sweeps/x?purge",
    )
}

/// Returns the answer to somebody without the token.
pub fn locked() -> Value {
    problem(401, "Unauthorized", "this service asks for its token")
}

/// More than a service takes on.
pub fn crowded() -> Value {
    problem(
        429,
        "Too Many Requests",
        "at most 20000 studies may wait: send it again when some are done",
    )
}

/// An engine that a service hasn't.
pub fn unknown_engine() -> Value {
    problem(
        422,
        "Unprocessable Entity",
        "there is no engine \"nomad\" here; this service has slurm",
    )
}

/// An engine that refuses.
pub fn unwilling() -> Value {
    problem(
        503,
        "Service Unavailable",
        "the engine slurm: sbatch: error: invalid partition specified: shrt",
    )
}

/// A service that can't work.
pub fn unready() -> Value {
    problem(
        503,
        "Service Unavailable",
        "the database does not answer; the service's log says why",
    )
}

/// A document with a fault.
pub fn faults() -> Value {
    json!({
        "type": "about:blank", "title": "Unprocessable Entity", "status": 422, "detail": "the document has one fault",
        "errors": [{"pointer": "/method/nodes", "detail": "must be a whole number from 1 to 65; it is 0"}], "request_id": ID,
    })
}

/// A problem document.
pub(crate) fn problem(status: u16, title: &str, detail: &str) -> Value {
    json!({"type": "about:blank", "title": title, "status": status, "detail": detail, "request_id": ID})
}

#[cfg(test)]
mod tests {
    use documents::study::Study;

    use super::super::study_wire::StreamEvent;
    use super::*;
    use crate::wire::layout_wire::HandLayoutsDocument;

    #[test]
    fn examples_are_of_their_types() {
        serde_json::from_value::<StreamEvent>(event()).expect("an event");
        serde_json::from_value::<HandLayoutsDocument>(hand_layouts()).expect("layouts");
    }

    #[test]
    fn the_example_study_is_valid() {
        let refuse = |path: &str| Err(path.to_owned());
        for (text, format) in [
            (study_toml().to_owned(), Format::Toml),
            (study().to_string(), Format::Json),
        ] {
            Study::from_document(&text, format, &refuse).expect("a valid study");
        }
    }
}
