//! Health, and the files of the dashboard.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;

use crate::app::{Home, problem};

#[tokio::test(flavor = "multi_thread")]
async fn the_service_says_that_it_is_up_and_ready() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    assert_eq!(app.json("/healthz").await["status"], "ok");
    assert_eq!(app.json("/readyz").await["status"], "ready");
}

#[tokio::test(flavor = "multi_thread")]
async fn the_dashboard_is_served_with_a_strict_policy_and_an_etag() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let page = app.get("/").await;
    assert_eq!(page.status(), StatusCode::OK);
    assert_eq!(page.headers()["content-type"], "text/html");
    assert_eq!(page.headers()["x-content-type-options"], "nosniff");
    let policy = page.headers()["content-security-policy"]
        .to_str()
        .expect("text");
    assert!(
        policy.contains("default-src 'self'") && policy.contains("frame-ancestors 'none'"),
        "{policy}"
    );
    assert!(!policy.contains("unsafe"), "{policy}");
    let etag = page.headers()["etag"].clone();
    let html = page.text().await.expect("text");

    let again = app
        .client
        .get(app.url("/"))
        .header("if-none-match", etag)
        .send()
        .await
        .expect("an answer");
    assert_eq!(again.status(), StatusCode::NOT_MODIFIED);
    let deep = app
        .client
        .get(app.url("/studies/1"))
        .header("accept", "text/html")
        .send()
        .await
        .expect("an answer");
    assert_eq!(deep.status(), StatusCode::SEE_OTHER);
    assert_eq!(
        deep.headers()["location"],
        "/",
        "any page address leads to the dashboard"
    );

    let script = html
        .split('"')
        .find(|part| part.ends_with(".js"))
        .expect("the page has a script")
        .to_owned();
    let script = app
        .get(&format!("/{}", script.trim_start_matches(['.', '/'])))
        .await;
    assert_eq!(script.headers()["content-type"], "text/javascript");
}

#[tokio::test(flavor = "multi_thread")]
async fn files_outside_the_dashboard_are_not_served() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    for path in [
        "/missing.js",
        "/..%2f..%2fCargo.toml",
        "/%2e%2e/%2e%2e/etc/passwd",
        "/assets/",
    ] {
        problem(app.get(path).await, StatusCode::NOT_FOUND).await;
    }
    let written = app
        .client
        .post(app.url("/"))
        .body("x")
        .send()
        .await
        .expect("an answer");
    problem(written, StatusCode::METHOD_NOT_ALLOWED).await;
}
