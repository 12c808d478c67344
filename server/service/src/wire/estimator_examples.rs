//! Examples of the documents of estimators. A test reads each back as the type that it is an example of.

use serde_json::{Value, json};

const ID: &str = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6d";

/// Two runs and a recipe. Something can be learnt from them: who sends the example gets an estimator.
pub fn document() -> Value {
    json!({
        "name": "rig, week 47", "recipe": {"columns": {"forces": "fz_n", "threshold_n": 0.5}, "models": {"kinds": ["ridge", "gpr"]}},
        "recordings": [recording("monday.csv", 3), recording("tuesday.csv", 5)],
    })
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

/// An estimator at work.
pub fn summary() -> Value {
    json!({
        "id": ID, "name": "rig, week 47", "state": "running", "error": null, "created": "2026-11-24T01:02:03.456Z", "started": "2026-11-24T01:02:03.457Z",
        "finished": null, "forces": ["fz_n"], "recordings": [figures("monday.csv"), figures("tuesday.csv")], "progress": {"done": 3, "of": 9},
    })
}

fn figures(file: &str) -> Value {
    json!({
        "file": file, "rows": 3000, "labelled": 3000, "cycles": 12, "rate_hz": 100.0,
        "sha256": "af5570f5a1810b7af78caf4bc70a660f0df51e42baf91d4de5b2328de0e83dfc",
    })
}

/// An estimator with its recipe.
pub fn detail() -> Value {
    let mut detail = summary();
    detail["recipe"] = document()["recipe"].clone();
    detail
}

/// What a fit found.
pub fn report() -> Value {
    let split = |by: &str, rmse: f64| {
        json!({
            "by": by, "rmse_n": rmse, "rmse_interval_n": [rmse * 0.8, rmse * 1.3], "nrmse_percent": 2.1, "mean_nrmse_percent": 31.0, "r2": 0.995,
            "coverage": 0.953, "width_n": 1.6,
        })
    };
    let model = |model: &str, rmse: f64| {
        json!({
            "model": model, "features": "raw", "validation": split("run", rmse),
            "splits": {"random": split("random", 0.5 * rmse), "cycle": split("cycle", 0.7 * rmse), "run": split("run", rmse), "time": null, "frequency": null},
            "leak_factor": 2.0, "better_than_mean": true,
        })
    };
    json!({
        "recordings": [figures("monday.csv"), figures("tuesday.csv")],
        "forces": [{"force": "fz_n", "chosen": "gpr", "chosen_features": "raw", "rolled_r2": -0.4, "models": [model("gpr", 0.41), model("ridge", 0.62)]}],
        "promise": "95 % of the rows of another run like these lie within their intervals: the widths are those of runs that were left out",
        "notes": ["the first reading of each run is taken off its signals"],
        "cost": {"candidates": 9, "wall_s": 4.2},
    })
}

/// The beginning of a model file.
pub fn model() -> Value {
    json!({"format": estimation::estimator::FORMAT, "version": estimation::estimator::VERSION})
}

/// Rows that weren't learnt from.
pub fn left_out() -> Value {
    json!({"forces": [{
        "force": "fz_n", "run": [0, 0], "time_s": [0.0, 0.01], "truth_n": [0.0, 1.5], "estimate_n": [0.1, 1.4], "low_n": [-0.7, 0.6], "high_n": [0.9, 2.2],
    }]})
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
    let detail = "a document with recordings has at most 67108864 bytes";
    problem(413, "Payload Too Large", detail)
}

fn problem(status: u16, title: &str, detail: &str) -> Value {
    json!({"type": "about:blank", "title": title, "status": status, "detail": detail, "request_id": ID})
}

#[cfg(test)]
mod tests {
    use estimation::fit_report::Report;
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
        reads::<wire::EstimatorSummary>(summary());
        reads::<wire::EstimatorDetail>(detail());
        reads::<wire::LeftOutForces>(left_out());
        reads::<Report>(report());
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
