//! Examples of the documents of estimators.

use serde_json::{Value, json};

use super::examples::problem;

const ID: &str = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6d";

/// Two runs and a recipe. Something can be learnt from them: who sends the example gets an estimator.
pub fn document() -> Value {
    json!({
        "name": "rig, week 47", "recipe": {"columns": {"forces": "fz_n", "threshold_n": 0.5}, "models": {"kinds": ["ridge", "gpr"]}},
        "recordings": [recording("monday.csv", 3), recording("tuesday.csv", 5)],
    })
}

/// The recordings and the recipe, without a name.
pub fn looked_at() -> Value {
    let mut document = document();
    if let Some(fields) = document.as_object_mut() {
        fields.remove("name");
    }
    document
}

/// Six strokes of two signals that follow a force.
fn recording(file: &str, noise: usize) -> Value {
    let row = |row: usize| {
        let force = [0, 3, 5, 2][row % 4];
        let off = row * noise % 7;
        format!(
            "0.{row:02},{}.{off},{}.{off},{force}\n",
            2 * force,
            9 - force
        )
    };
    let rows: String = (0..24).map(row).collect();
    json!({"file": file, "text": format!("time_s,s1,s2,fz_n\n{rows}")})
}

/// A run of which no force was measured.
pub fn unmeasured() -> Value {
    json!({"file": "friday.csv", "text": "time_s,s1,s2\n0,0.1,8.8\n0.01,6.3,6.1\n"})
}

/// The beginning of a model file.
pub fn model() -> Value {
    json!({"format": estimation::estimator::FORMAT, "version": estimation::estimator::VERSION})
}

/// The beginning of estimates as CSV.
pub fn estimates() -> &'static str {
    "time_s,fz_n,fz_n_low,fz_n_high,outside\n0.0,0.1,-0.7,0.9,0\n"
}

/// Recordings that nothing can be learnt from.
pub fn faults() -> Value {
    json!({
        "type": "about:blank", "title": "Unprocessable Entity", "status": 422, "detail": "the document has one fault",
        "errors": [{"pointer": "/recordings", "detail": "monday.csv, line 3, column s1: must be a number; it is \"n/a\""}], "request_id": ID,
    })
}

/// An estimator that has nothing yet.
pub fn unlearnt() -> Value {
    problem(
        409,
        "Conflict",
        "the estimator is running and has no report",
    )
}

/// An estimator that isn't there.
pub fn absent() -> Value {
    problem(404, "Not Found", "there is no estimator \"x\"")
}

/// More than a service takes on.
pub fn crowded() -> Value {
    let detail = "at most 100 estimators may wait: send it again when some are done";
    problem(429, "Too Many Requests", detail)
}

/// More than is read.
pub fn too_large() -> Value {
    let detail = "a document with files has at most 67108864 bytes";
    problem(413, "Payload Too Large", detail)
}

#[cfg(test)]
mod tests {
    use serde::de::DeserializeOwned;

    use super::super::estimator_wire as wire;
    use super::*;
    use crate::forces::submission_reader::{FitLimits, read_recording, read_submission};

    fn reads<T: DeserializeOwned>(example: Value) {
        serde_json::from_value::<T>(example.clone())
            .unwrap_or_else(|error| panic!("{}: {error}: {example}", std::any::type_name::<T>()));
    }

    #[test]
    fn examples_are_of_their_types() {
        reads::<wire::EstimatorDocument>(document());
        reads::<wire::RecordingDocument>(unmeasured());
    }

    #[test]
    fn the_example_can_be_learnt_and_applied() {
        let limits = FitLimits {
            threads: 1,
            memory_bytes: u64::MAX,
        };
        read_submission(document(), limits).expect("a valid submission");
        read_recording(unmeasured()).expect("a valid recording");
    }
}
