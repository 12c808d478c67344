//! A study as a model of UM-Bridge, asked as its clients ask.

use std::process::Command;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::program::service::Program;
use crate::program::{strainsite, text};

fn serving() -> Program {
    let mut command = Command::new(env!("CARGO_BIN_EXE_strainsite"));
    let arguments = [
        "umbridge",
        "foot-tire",
        "--set",
        "accuracy.preset=draft",
        "--addr",
        "127.0.0.1:0",
    ];
    command.args(arguments).stdout(std::process::Stdio::piped());
    Program::run(&mut command)
}

/// Answer to a request about the model, and its status.
async fn asked(program: &Program, what: &str, request: &Value) -> (u16, Value) {
    let mut request = request.clone();
    request["name"] = request
        .get("name")
        .cloned()
        .unwrap_or_else(|| json!("forward"));
    let sent = program
        .client
        .post(format!("{}/{what}", program.url))
        .body(request.to_string());
    let answer = sent.send().await.expect("an answer");
    (answer.status().as_u16(), answer.json().await.expect("JSON"))
}

async fn output(program: &Program, what: &str, request: &Value) -> Value {
    let (status, answer) = asked(program, what, request).await;
    assert_eq!(status, 200, "{answer}");
    answer["output"].clone()
}

fn numbers(list: &Value) -> Vec<f64> {
    let list = list.as_array().expect("a list");
    list.iter()
        .map(|number| number.as_f64().expect("a number"))
        .collect()
}

/// Equilibrium by `strainsite solve`, differentiated by the depth below P3.
fn solved(depths: &str) -> Value {
    let folder = tempfile::tempdir().expect("temp dir");
    let depths = format!("ground.depths_mm={depths}");
    let arguments = [
        "solve",
        "foot-tire",
        "--set",
        "model.level=draft",
        "--set",
        &depths,
        "--derivatives",
        "ground.depths_mm[2]",
        "--json",
        "-",
    ];
    let output = strainsite(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// Largest difference over the largest number.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let largest = b
        .iter()
        .fold(0.0, |most: f64, number| most.max(number.abs()));
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).abs() / largest)
        .fold(0.0, f64::max)
}

#[tokio::test]
async fn a_point_and_its_derivatives_are_those_of_one_equilibrium() {
    let program = serving();
    let info: Value = program.get("/Info").await.json().await.expect("JSON");
    assert_eq!(info, json!({"protocolVersion": 1.0, "models": ["forward"]}));
    let (_, support) = asked(&program, "ModelInfo", &json!({})).await;
    assert_eq!(
        support["support"],
        json!({"Evaluate": true, "Gradient": true, "ApplyJacobian": true, "ApplyHessian": false})
    );
    let (_, inputs) = asked(&program, "InputSizes", &json!({"config": {}})).await;
    assert_eq!(inputs, json!({"inputSizes": [5]}));
    let (_, outputs) = asked(&program, "OutputSizes", &json!({})).await;
    assert_eq!(outputs, json!({"outputSizes": [5, 5, 1]}));

    // A point starts from the means' equilibrium, where solve starts from nothing: Newton's method stops both below 1e-8 of the forces.
    let alone = solved("[1,1.1,0.9,1,1.2]");
    let point = json!({"input": [[1, 1.1, 0.9, 1, 1.2]], "config": {"level": "draft"}});
    let found = output(&program, "Evaluate", &point).await;
    let of = |document: &Value, name: &str| -> Vec<f64> {
        let locations = document["locations"].as_array().expect("locations");
        locations
            .iter()
            .map(|location| location[name].as_f64().expect("a strain"))
            .collect()
    };
    for (k, name) in ["strain_x", "strain_y"].into_iter().enumerate() {
        assert!(
            apart(&numbers(&found[k]), &of(&alone, name)) < 1e-6,
            "{name}: {found}"
        );
    }
    assert!(
        apart(
            &numbers(&found[2]),
            &[alone["reaction_n"].as_f64().expect("a force")]
        ) < 1e-6
    );

    let along_p3 = |mut request: Value, out: usize| {
        request["outWrt"] = json!(out);
        request["inWrt"] = json!(0);
        request["vec"] = json!([0, 0, 1, 0, 0]);
        request["sens"] = json!(vec![1.0; if out == 2 { 1 } else { 5 }]);
        request
    };
    let derivatives = &alone["derivatives"][0];
    for (out, name) in ["strain_x", "strain_y"].into_iter().enumerate() {
        let column = output(&program, "ApplyJacobian", &along_p3(point.clone(), out)).await;
        let expected = of(derivatives, name);
        assert!(
            apart(&numbers(&column), &expected) < 1e-5,
            "{name}: {column}"
        );
        let gradient = output(&program, "Gradient", &along_p3(point.clone(), out)).await;
        let sum: f64 = expected.iter().sum();
        let scale: f64 = expected.iter().map(|one| one.abs()).sum();
        assert!(
            (numbers(&gradient)[2] - sum).abs() < 1e-5 * scale,
            "{name}: {gradient}"
        );
    }
    let force = output(&program, "Gradient", &along_p3(point.clone(), 2)).await;
    assert!(
        apart(
            &[numbers(&force)[2]],
            &[derivatives["reaction_n"].as_f64().expect("a force")]
        ) < 1e-5
    );

    // The same point again is known: what is left is ours.
    let begun = Instant::now();
    for _ in 0..50 {
        assert_eq!(output(&program, "Evaluate", &point).await, found);
    }
    eprintln!("a known point: {:?}", begun.elapsed() / 50);
    program.kill();
}

#[tokio::test]
async fn what_is_wrong_is_refused_with_a_type_and_what_would_be_right() {
    let program = serving();
    let means = json!([[1, 1, 1, 1, 1]]);
    for (what, request, kind, because) in [
        (
            "Evaluate",
            json!({"name": "backward", "input": means}),
            "ModelNotFound",
            "forward",
        ),
        ("InputSizes", json!({"name": 3}), "ModelNotFound", "forward"),
        (
            "Evaluate",
            json!({}),
            "InvalidInput",
            "one list of 5 numbers",
        ),
        (
            "Evaluate",
            json!({"input": [[1, 1]]}),
            "InvalidInput",
            "one list of 5 numbers",
        ),
        (
            "Evaluate",
            json!({"input": [[1, 1, 1, 1, "one"]]}),
            "InvalidInput",
            "one list of 5 numbers",
        ),
        (
            "Evaluate",
            json!({"input": [[1, 1, 1, 1, 1], []]}),
            "InvalidInput",
            "one list",
        ),
        (
            "Evaluate",
            json!({"input": [[1, 1, 1, 1, 1e9]]}),
            "InvalidInput",
            "depths_mm",
        ),
        (
            "Evaluate",
            json!({"input": means, "config": {"level": "finest"}}),
            "InvalidInput",
            "draft",
        ),
        (
            "Evaluate",
            json!({"input": means, "config": {"lvel": "draft"}}),
            "InvalidInput",
            "lvel",
        ),
        (
            "OutputSizes",
            json!({"config": [1]}),
            "InvalidInput",
            "object",
        ),
        (
            "Gradient",
            json!({"input": means, "outWrt": 3, "inWrt": 0, "sens": [1]}),
            "InvalidInput",
            "outWrt",
        ),
        (
            "Gradient",
            json!({"input": means, "outWrt": 2, "inWrt": 1, "sens": [1]}),
            "InvalidInput",
            "inWrt",
        ),
        (
            "Gradient",
            json!({"input": means, "outWrt": 2, "inWrt": 0, "sens": [1, 2]}),
            "InvalidInput",
            "sens",
        ),
        (
            "ApplyJacobian",
            json!({"input": means, "outWrt": 2, "inWrt": 0, "vec": [1]}),
            "InvalidInput",
            "vec",
        ),
        (
            "ApplyHessian",
            json!({"input": means}),
            "UnsupportedFeature",
            "second",
        ),
        (
            "Evaluate",
            json!({"input": [[12.5, 12.5, 12.5, 12.5, 12.5]]}),
            "NoEquilibrium",
            "self-contact",
        ),
    ] {
        let (status, answer) = asked(&program, what, &request).await;
        let message = answer["error"]["message"].as_str().unwrap_or_default();
        assert!(
            (400..500).contains(&status)
                && answer["error"]["type"] == kind
                && message.contains(because),
            "{what} {request}: {answer}"
        );
    }
    let post = |path: &str| program.client.post(format!("{}{path}", program.url));
    let nan = post("/Evaluate").body(r#"{"name": "forward", "input": [[NaN, 1, 1, 1, 1]]}"#);
    assert_eq!(nan.send().await.expect("an answer").status(), 400);
    let large = post("/Evaluate").body(vec![b' '; 2 << 20]);
    assert_eq!(large.send().await.expect("an answer").status(), 413);
    // A page that the user opens elsewhere can't ask.
    for (header, value) in [("Host", "evil.example"), ("Origin", "http://evil.example")] {
        let foreign = post("/Evaluate").header(header, value).body("{}");
        assert_eq!(
            foreign.send().await.expect("an answer").status(),
            403,
            "{header}"
        );
    }
    let process = program.number().to_string();
    let told = Command::new("kill").args(["-TERM", &process]).status();
    assert!(told.expect("kill runs").success());
    let begun = Instant::now();
    while program
        .client
        .get(format!("{}/Info", program.url))
        .send()
        .await
        .is_ok()
    {
        assert!(begun.elapsed() < Duration::from_secs(5), "it ends");
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
}
