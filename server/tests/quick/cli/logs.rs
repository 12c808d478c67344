//! The log of the real service.

use reqwest::{Client, StatusCode};
use serde_json::{Value, json};

use super::served::Served;

/// Two depths on the coarsest mesh. The name wants to be a line of the log: names have no control characters, but other line breaks.
fn study() -> Value {
    let input = |name: &str, station: usize| {
        json!({
            "name": name, "vary": format!("ground.depths_mm[{station}]"),
            "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3},
        })
    };
    json!({
        "name": "two depths\u{2028}2026-01-01T00:00:00Z ERROR forged: all is lost",
        "scene": {"preset": "foot-tire"}, "inputs": [input("P2", 1), input("P3", 2)],
        "method": {"kind": "mdrm", "nodes": 3}, "accuracy": {"preset": "draft"},
    })
}

/// Whether a line stands in a span with this field.
fn within(line: &Value, field: &str, value: &str) -> bool {
    let spans = line["spans"].as_array().into_iter().flatten();
    spans.into_iter().any(|span| span[field] == value)
}

#[tokio::test]
async fn every_line_says_for_which_study_and_which_request_it_is() {
    let folder = tempfile::tempdir().expect("temp dir");
    let arguments = [
        "--addr",
        "127.0.0.1:0",
        "--log-format",
        "json",
        "--log",
        "debug",
    ];
    let service = Served::start(folder.path(), &arguments, &[]);
    let id = service.run(&study()).await;
    let missing = Client::new().get(format!("{}/v1/studies/none", service.url));
    let missing = missing.header("x-request-id", "forged");
    let missing = missing.send().await.expect("an answer");
    assert_eq!(missing.status(), StatusCode::NOT_FOUND);
    let request = missing.headers()["x-request-id"]
        .to_str()
        .expect("text")
        .to_owned();
    assert_ne!(request, "forged");
    let log = service.log();
    let read =
        |line: &str| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"));
    let lines: Vec<Value> = log.lines().map(read).collect();

    let of_study = |line: &&Value| within(line, "study", &id) || line["study"] == id.as_str();
    // Statements are logged as they are sent, from the solving threads too: these are written for every point.
    let points = |line: &&&Value| {
        line["summary"]
            .as_str()
            .is_some_and(|text| text.contains("into evaluations"))
    };
    let all: Vec<&Value> = lines.iter().filter(|line| points(&line)).collect();
    // Seven points of two inputs with three nodes, or more with those that check.
    assert!(all.len() >= 7, "{} points are in the log", all.len());
    for line in &all {
        assert!(of_study(line), "{line}");
    }
    for message in ["study started", "study ended"] {
        let found = lines.iter().find(|line| line["message"] == message);
        assert!(
            found.is_some_and(|line| of_study(&line)),
            "{message}: {found:?}"
        );
    }
    let of_request: Vec<&Value> = lines
        .iter()
        .filter(|line| within(line, "request_id", &request))
        .collect();
    let answered = of_request
        .iter()
        .find(|line| line["message"] == "request")
        .expect("its line");
    assert_eq!(
        (&answered["status"], &answered["method"]),
        (&json!(404), &json!("GET"))
    );
    assert!(
        of_request.len() > 1,
        "what the request asked of the database is in its span, too"
    );
}

#[tokio::test]
async fn what_clients_send_can_not_look_like_a_line_of_the_log() {
    let folder = tempfile::tempdir().expect("temp dir");
    let service = Served::start(
        folder.path(),
        &["--addr", "127.0.0.1:0"],
        &[("STRAINSITE_LOG", "debug")],
    );
    let id = service.run(&study()).await;
    let path = "/v1/studies/x%0A2026-01-01T00:00:00Z%20ERROR%20forged%1B[31m";
    let asked = Client::new().get(format!("{}{path}", service.url)).send();
    let asked = asked.await.expect("an answer");
    assert_eq!(asked.status(), StatusCode::NOT_FOUND);
    let log = service.log();
    assert!(log.contains(&id) && log.contains("all is lost"), "{log}");
    assert!(
        !log.contains(['\u{1b}', '\u{2028}']),
        "neither escape sequences nor line breaks"
    );
    for line in log.lines() {
        // 2026-11-22T03:04:05.678901Z, then a level, then where.
        let mut words = line.split_whitespace();
        let time = words.next().unwrap_or_default();
        assert!(time.parse::<jiff::Timestamp>().is_ok(), "{line:?}");
        let level = words.next().unwrap_or_default();
        assert!(
            ["ERROR", "WARN", "INFO", "DEBUG"].contains(&level),
            "{line:?}"
        );
        assert_ne!((time, level), ("2026-01-01T00:00:00Z", "ERROR"), "{line:?}");
    }
}
