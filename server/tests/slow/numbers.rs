//! Numbers at the ends of what a number can be, in every field that takes one.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;
use serde_json::{Value, json};

use crate::app::{App, Home};

/// Text that stands where the number will be.
const PLACE: &str = "@number@";
/// Numbers beyond the range of every field.
const TOO_LARGE: [&str; 3] = ["1e308", "-1e308", "123456789012345678901234567890"];
/// Zero, as it is read; whether a field may be zero is the field's own business.
const NOTHING: [&str; 3] = ["1e-400", "-0.0", "-0"];

fn scene(material: Value) -> Value {
    json!({
        "geometry": {"kind": "tire", "outer_radius_mm": 50.0, "section_radius_mm": 12.5, "wall_mm": 3.0, "bead_angle_deg": 120.0},
        "material": material,
        "carcass": {"angle_deg": 55.0, "stiffness_n_per_mm": 100.0, "position": 0.5, "compression_ratio": 0.01},
        "film": {"modulus_mpa": 100.0, "poisson_ratio": 0.3, "thickness_mm": 0.05, "length_mm": 5.0, "width_mm": 5.0},
        "pressure": {"internal_mpa": 0.2},
        "ground": {"stations": 5, "station_spacing_mm": 5.5, "depths_mm": [1.0, 1.0, 1.0, 1.0, 1.0]},
        "contact": {"friction": 0.0, "penalty_n_per_mm3": 10.0}
    })
}

fn study(material: Value, law: Value, method: Value, accuracy: Value) -> Value {
    json!({
        "name": "numbers",
        "scene": scene(material),
        "inputs": [{"name": "P3", "vary": "ground.depths_mm[2]", "distribution": law}],
        "candidates": {"points": "P1-P5", "grid": {"circumferential": 5, "meridional": 3, "half_width_deg": 30.0}},
        "layouts": {"spacings_deg": [60.0, 90.0], "positions": ["crown"]},
        "method": method,
        "accuracy": accuracy
    })
}

/// Studies that between them have every numeric field.
fn studies() -> Vec<Value> {
    let rubber =
        json!({"model": "mooney-rivlin", "c10_mpa": 0.144, "c01_mpa": 0.036, "d1_per_mpa": 0.01});
    let uniform = json!({"kind": "uniform", "min": 0.7, "max": 1.3, "truncate": [0.75, 1.25]});
    let mdrm = json!({"kind": "mdrm", "nodes": 3, "check_points": 2, "seed": 1});
    let tolerance = json!({"tolerance": 0.02});
    let mut all = vec![study(
        rubber.clone(),
        uniform.clone(),
        mdrm.clone(),
        tolerance.clone(),
    )];
    for other in [
        json!({"model": "neo-hookean", "c10_mpa": 0.2}),
        json!({"model": "yeoh", "c10_mpa": 0.17, "c20_mpa": -0.002, "c30_mpa": 6e-5}),
        json!({"model": "ogden", "terms": [{"mu_mpa": 0.5, "alpha": 1.3}, {"mu_mpa": 0.1, "alpha": -2.0}]}),
    ] {
        all.push(study(
            other,
            uniform.clone(),
            mdrm.clone(),
            json!({"budget_s": 60.0}),
        ));
    }
    for other in [
        json!({"kind": "normal", "mean": 1.0, "std": 0.05}),
        json!({"kind": "lognormal", "mu": 0.0, "sigma": 0.05}),
        json!({"kind": "exponential", "rate": 2.0, "truncate": [0.5, 1.5]}),
        json!({"kind": "gamma", "shape": 50.0, "scale": 0.02}),
        json!({"kind": "weibull", "shape": 5.0, "scale": 1.0, "truncate": [0.5, 1.5]}),
        json!({"kind": "beta", "alpha": 2.0, "beta": 3.0, "min": 0.5, "max": 1.5}),
        json!({"kind": "gumbel", "location": 1.0, "scale": 0.05, "truncate": [0.5, 2.0]}),
        json!({"kind": "triangular", "min": 0.5, "mode": 1.0, "max": 2.0}),
    ] {
        all.push(study(
            rubber.clone(),
            other,
            mdrm.clone(),
            tolerance.clone(),
        ));
    }
    for other in [
        json!({"kind": "pce", "samples": 20}),
        json!({"kind": "saltelli", "samples": 8}),
        json!({"kind": "auto", "nodes": 3, "check_points": 3, "tolerance": 0.05, "most_runs": 100}),
    ] {
        all.push(study(
            rubber.clone(),
            uniform.clone(),
            other,
            tolerance.clone(),
        ));
    }
    all
}

/// JSON pointers of all numbers.
fn numbers(value: &Value, pointer: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(pointer.to_owned()),
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                numbers(item, &format!("{pointer}/{index}"), found);
            }
        }
        Value::Object(members) => {
            for (name, member) in members {
                numbers(member, &format!("{pointer}/{name}"), found);
            }
        }
        _ => {}
    }
}

/// Asks what the study would cost, which reads it as a submission does and stores nothing.
async fn ask(app: &App, kind: &str, text: String) -> (StatusCode, Value) {
    let address = app.url("/v1/studies:estimate");
    let request = app.client.post(address).header("content-type", kind);
    let answer = request.body(text).send().await.expect("an answer");
    (answer.status(), answer.json().await.expect("JSON"))
}

fn pointers(problem: &Value) -> Vec<&str> {
    let errors = problem["errors"].as_array().expect("a list of faults");
    let pointers = errors.iter().map(|error| error["pointer"].as_str());
    pointers
        .map(|pointer| pointer.expect("a pointer"))
        .collect()
}

/// Checks that a number is refused, and by name: the field's own fault says which numbers it takes.
fn names(status: StatusCode, problem: &Value, pointer: &str, literal: &str) {
    assert_eq!(
        status,
        StatusCode::UNPROCESSABLE_ENTITY,
        "{pointer} = {literal}: {problem}"
    );
    let errors = problem["errors"].as_array().expect("a list of faults");
    let own = errors.iter().find(|error| error["pointer"] == pointer);
    let own = own.unwrap_or_else(|| panic!("{pointer} = {literal} isn't named: {problem}"));
    let detail = own["detail"].as_str().expect("a sentence");
    assert!(
        detail.contains(" from ") && detail.contains(" to "),
        "{pointer} = {literal}: {detail}"
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_number_at_the_extremes_is_refused_by_the_name_of_its_field() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut tried = std::collections::BTreeSet::new();
    for study in studies() {
        let (status, answer) = ask(&app, "application/json", study.to_string()).await;
        assert_eq!(status, StatusCode::OK, "{answer}");
        let mut found = Vec::new();
        numbers(&study, "", &mut found);
        for pointer in found {
            let kind = study["inputs"][0]["distribution"]["kind"].as_str();
            let model = study["scene"]["material"]["model"].as_str();
            let method = study["method"]["kind"].as_str();
            // Fields that all studies have are tried once.
            let owner = match pointer.split('/').nth(1) {
                Some("inputs") => kind,
                Some("method") => method,
                Some("scene") if pointer.starts_with("/scene/material") => model,
                _ => None,
            };
            if tried.insert((owner.map(str::to_owned), pointer.clone())) {
                try_field(&app, &study, &pointer).await;
            }
        }
    }
    eprintln!("{} fields", tried.len());
    assert!(tried.len() > 75, "{} fields", tried.len());
    assert_eq!(app.json("/v1/studies").await["studies"], json!([]));
}

async fn try_field(app: &App, study: &Value, pointer: &str) {
    let mut study = study.clone();
    *study.pointer_mut(pointer).expect("is there") = json!(PLACE);
    let place = json!(PLACE).to_string();
    let json = |literal: &str| study.to_string().replace(&place, literal);
    let table = toml::to_string(&study).expect("has no null");
    let toml = |literal: &str| table.replace(&place, literal);

    for literal in TOO_LARGE {
        let (status, answer) = ask(app, "application/json", json(literal)).await;
        names(status, &answer, pointer, literal);
    }
    for literal in ["nan", "inf", "-inf", "1e308", "-1e308"] {
        let (status, answer) = ask(app, "application/toml", toml(literal)).await;
        names(status, &answer, pointer, literal);
    }
    for literal in NOTHING {
        let (status, answer) = ask(app, "application/json", json(literal)).await;
        if status != StatusCode::OK {
            assert_eq!(
                status,
                StatusCode::UNPROCESSABLE_ENTITY,
                "{pointer} = {literal}: {answer}"
            );
            assert!(
                pointers(&answer).iter().all(|at| !at.is_empty()),
                "{pointer} = {literal}: {answer}"
            );
        }
    }
    // JSON's own grammar has no such numbers: the text is refused, with line and column.
    let (status, answer) = ask(app, "application/json", json("1e400")).await;
    assert_eq!(
        status,
        StatusCode::UNPROCESSABLE_ENTITY,
        "{pointer}: {answer}"
    );
    let detail = answer["errors"][0]["detail"].as_str().unwrap_or_default();
    assert!(detail.contains("out of range at line 1 column"), "{detail}");
    let (status, answer) = ask(app, "application/json", json("NaN")).await;
    assert_eq!(status, StatusCode::BAD_REQUEST, "{pointer}: {answer}");
}
