//! `/metrics`.

use std::collections::HashMap;

use fem_client::closed_form::ClosedFormSolver;
use reqwest::Method;

use crate::app::{App, Home, slow, study};

/// Every sample by its name and labels. The text must be what OpenMetrics says: comments of four kinds, samples with one number, an end.
async fn samples(app: &App) -> HashMap<String, f64> {
    let answer = app.get("/metrics").await;
    let kind = answer.headers()["content-type"]
        .to_str()
        .expect("text")
        .to_owned();
    assert!(
        kind.starts_with("application/openmetrics-text; version=1.0.0"),
        "{kind}"
    );
    let text = answer.text().await.expect("text");
    let body = text.strip_suffix("# EOF\n").expect("an end");
    let mut samples = HashMap::new();
    for line in body.lines() {
        if let Some(comment) = line.strip_prefix("# ") {
            let kind = comment.split(' ').next();
            assert!(matches!(kind, Some("HELP" | "TYPE" | "UNIT")), "{line}");
            continue;
        }
        let (name, value) = line.rsplit_once(' ').expect("a sample");
        let begin = name.split('{').next().expect("a name");
        assert!(
            begin
                .bytes()
                .all(|byte| byte.is_ascii_lowercase() || byte == b'_'),
            "{line}"
        );
        assert!(!name.contains('{') || name.ends_with("\"}"), "{line}");
        let value = value.parse().expect("a number");
        assert_eq!(
            samples.insert(name.to_owned(), value),
            None,
            "{line} stands twice"
        );
    }
    samples
}

#[tokio::test(flavor = "multi_thread")]
async fn the_measurements_rise_by_what_was_done() {
    let home = Home::new();
    // Some nodes lie deeper than this, and have no equilibrium.
    let app = home
        .start(ClosedFormSolver::new().with_depth_limit(1.26))
        .await;
    let before = samples(&app).await;
    let first = app.submit(&study()).await;
    app.wait_for(&first, "done").await;
    let result = app.json(&format!("/v1/studies/{first}/result")).await;
    let failed = result["failed_points"].as_array().expect("a list").len() as f64;
    let second = app.submit(&study()).await;
    app.wait_for(&second, "done").await;
    let after = samples(&app).await;
    let rise = |name: &str| after[name] - before.get(name).copied().unwrap_or(0.0);
    let points = |outcome: &str| rise(&format!("strainsite_points_total{{outcome=\"{outcome}\"}}"));
    assert!(failed >= 5.0);
    assert_eq!(
        (points("solved"), points("failed"), points("reused")),
        (26.0 - failed, failed, 26.0)
    );
    assert_eq!(rise("strainsite_solve_seconds_count"), 26.0);
    assert_eq!(rise("strainsite_solve_seconds_bucket{le=\"+Inf\"}"), 26.0);
    assert_eq!(rise("strainsite_studies{state=\"done\"}"), 2.0);
    assert_eq!(after["strainsite_estimators{state=\"queued\"}"], 0.0);
    let submitted =
        "strainsite_requests_total{method=\"POST\",route=\"/v1/studies\",status=\"202\"}";
    assert_eq!(rise(submitted), 2.0);
    // A migrated database has a dozen tables of 4 kB, and a process that runs has a megabyte.
    assert!(after["strainsite_database_bytes"] > 40_000.0);
    assert!(after["process_resident_memory_bytes"] > 1e6);
}

#[tokio::test(flavor = "multi_thread")]
async fn clients_can_not_make_the_measurements_grow() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let asking = async || {
        for name in ["a", "b", "c"] {
            app.get(&format!("/v1/studies/{name}")).await;
            app.get(&format!("/no/such/{name}")).await;
            let method = Method::from_bytes(name.to_uppercase().as_bytes()).expect("a method");
            let request = app.client.request(method, app.url("/v1/presets"));
            request.send().await.expect("an answer");
        }
    };
    asking().await;
    let few = samples(&app).await;
    asking().await;
    let many = samples(&app).await;
    // The first reading was itself a request, and is a sample of the second.
    let own = |name: &&String| !name.contains("/metrics");
    assert_eq!(
        few.keys().filter(own).count(),
        many.keys().filter(own).count()
    );
    for (route, method, status) in [
        ("/v1/studies/{id}", "GET", 404),
        ("other", "GET", 404),
        ("/v1/presets", "other", 405),
    ] {
        let name = format!(
            "strainsite_requests_total{{method=\"{method}\",route=\"{route}\",status=\"{status}\"}}"
        );
        assert_eq!(many.get(&name), Some(&6.0), "{name}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn open_event_streams_are_counted_until_they_end() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    let mut stream = app.get(&format!("/v1/studies/{id}/events")).await;
    stream.chunk().await.expect("a first event");
    assert_eq!(samples(&app).await["strainsite_event_streams"], 1.0);
    while let Ok(Some(_)) = stream.chunk().await {}
    drop(stream);
    app.wait_for(&id, "done").await;
    assert_eq!(samples(&app).await["strainsite_event_streams"], 0.0);
}
