//! `POST /v1/analyses`: points out, values in, until no more are asked for.

use std::f64::consts::PI;
use std::fmt::Write as _;

use fem_client::closed_form::ClosedFormSolver;
use reqwest::{Response, StatusCode};
use serde_json::{Value, json};

use super::ishigami;
use crate::app::{App, Home, problem};
use crate::program::{strainsite, text};

async fn post(app: &App, body: &Value) -> Response {
    let request = app.client.post(app.url("/v1/analyses")).json(body);
    request.send().await.expect("an answer")
}

async fn analysed(app: &App, body: &Value) -> Value {
    let answer = post(app, body).await;
    assert_eq!(answer.status(), StatusCode::OK);
    answer.json().await.expect("JSON")
}

/// Three uniform inputs on [-pi, pi].
fn inputs() -> Value {
    let law = json!({"kind": "uniform", "min": -PI, "max": PI});
    ["a", "b", "c"]
        .map(|name| json!({"name": name, "distribution": law}))
        .into()
}

/// Runs the model at the points that are asked for; the rows are appended.
fn run(points: &Value, ids: &mut Vec<Value>, rows: &mut Vec<Value>) {
    ids.extend(points["ids"].as_array().expect("ids").iter().cloned());
    for point in points["rows"].as_array().expect("rows") {
        let x: Vec<f64> = point
            .as_array()
            .expect("numbers")
            .iter()
            .filter_map(Value::as_f64)
            .collect();
        rows.push(json!([ishigami(&x)]));
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_client_loops_until_nothing_is_wanted_and_gets_what_the_command_line_says() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut found = analysed(&app, &json!({"inputs": inputs()})).await;
    assert_eq!(
        (&found["outputs"], &found["evaluations"]),
        (&json!([]), &json!(0))
    );
    let (mut ids, mut rows, mut rounds) = (Vec::new(), Vec::new(), 0);
    while found["wanted"] != 0 {
        assert_eq!(
            found["wanted"],
            found["points"]["ids"].as_array().map_or(0, Vec::len)
        );
        run(&found["points"], &mut ids, &mut rows);
        let values = json!({"outputs": ["y"], "ids": ids, "rows": rows});
        found = analysed(&app, &json!({"inputs": inputs(), "values": values})).await;
        rounds += 1;
    }
    assert!(rounds > 1, "auto asks again");
    let exact = [0.31390519114781146, 0.4424111447900408, 0.0];
    for (k, exact) in exact.into_iter().enumerate() {
        let (output, number) = (&found["outputs"][0], |value: &Value| {
            value.as_f64().expect("a number")
        });
        let error = (number(&output["first_order"][k]) - exact).abs();
        assert!(error <= number(&output["error"]["by_input"][k]), "{output}");
    }

    // As a file the values have the same digits, and the command line the same answer.
    let mut csv = "id,y\n".to_owned();
    for (id, row) in ids.iter().zip(&rows) {
        writeln!(csv, "{id},{:.16e}", row[0].as_f64().expect("a number")).expect("writes");
    }
    let of_file = analysed(&app, &json!({"inputs": inputs(), "values": csv})).await;
    assert_eq!(of_file, found);
    let folder = tempfile::tempdir().expect("temp dir");
    let document = json!({"inputs": inputs(), "method": {"kind": "auto"}});
    std::fs::write(folder.path().join("inputs.json"), document.to_string()).expect("writes");
    std::fs::write(folder.path().join("values.csv"), csv).expect("writes");
    let told = strainsite(
        folder.path(),
        &["gsa", "analyse", "inputs.json", "values.csv", "--json", "-"],
    );
    assert_eq!(
        serde_json::from_str::<Value>(text(&told.stdout)).expect("JSON"),
        found
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn faults_and_advice_are_told() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let faults = async |body: Value| -> Vec<(String, String)> {
        let told = problem(post(&app, &body).await, StatusCode::UNPROCESSABLE_ENTITY).await;
        let faults = told["errors"].as_array().expect("faults").iter();
        let words = |value: &Value| value.as_str().expect("words").to_owned();
        faults
            .map(|fault| (words(&fault["pointer"]), words(&fault["detail"])))
            .collect()
    };
    let told = faults(json!({"inputs": [{"name": "a"}], "method": {"nodes": 0}, "value": 1})).await;
    let places: Vec<&str> = told.iter().map(|(place, _)| place.as_str()).collect();
    assert_eq!(
        places,
        ["/value", "/method/nodes", "/inputs/0/distribution"]
    );
    let mdrm = json!({"kind": "mdrm", "check_points": 0});
    let valued = |values: Value| json!({"inputs": inputs(), "method": mdrm, "values": values});
    let told = faults(valued("id,y\n0,1\n0,2\n500,3\n".into())).await;
    assert_eq!(told.len(), 1);
    assert_eq!(
        (told[0].0.as_str(), &told[0].1[..7]),
        ("/values", "line 3:")
    );
    let lists = json!({"outputs": ["y"], "ids": [0, 500], "rows": [[1], [2]]});
    let told = faults(valued(lists)).await;
    assert_eq!(told[0].0, "/values/rows/1");
    assert!(told[0].1.starts_with("there is no point 500"), "{told:?}");

    let missing = analysed(&app, &valued("id,y\n0,1\n".into())).await;
    let advice = missing["advice"].as_str().expect("advice");
    assert!(
        advice.starts_with("no values for points 1, 2, 3"),
        "{advice}"
    );
    assert_eq!(
        (&missing["wanted"], &missing["outputs"]),
        (&json!(12), &json!([]))
    );
    let mut rows = vec![json!([ishigami(&[0.0; 3])])];
    run(&missing["points"], &mut Vec::new(), &mut rows);
    let little = analysed(&app, &valued(json!({"outputs": ["y"], "rows": rows}))).await;
    let advice = little["advice"].as_str();
    assert!(
        advice.is_none_or(|advice| advice.contains("kind = \"auto\"")),
        "{little}"
    );
}
