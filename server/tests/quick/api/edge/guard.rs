//! Requests that are refused, each with a problem document.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::{Method, StatusCode};
use serde_json::json;

use crate::app::{Home, problem, study};

#[tokio::test(flavor = "multi_thread")]
async fn hosts_and_origins_that_are_not_ours_are_refused() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let foreign = app
        .client
        .get(app.url("/v1/studies"))
        .header("host", "evil.example");
    problem(
        foreign.send().await.expect("an answer"),
        StatusCode::FORBIDDEN,
    )
    .await;
    let page = app
        .client
        .post(app.url("/v1/studies"))
        .header("origin", "http://evil.example")
        .json(&study());
    problem(page.send().await.expect("an answer"), StatusCode::FORBIDDEN).await;
    let page = app
        .client
        .delete(app.url("/v1/studies/x"))
        .header("origin", "null");
    problem(page.send().await.expect("an answer"), StatusCode::FORBIDDEN).await;
    let own = app
        .client
        .post(app.url("/v1/studies"))
        .header("origin", app.url(""))
        .json(&study());
    assert_eq!(
        own.send().await.expect("an answer").status(),
        StatusCode::ACCEPTED
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn bodies_that_can_not_be_read_are_refused() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let send = |kind: &'static str, body: String| {
        let request = app
            .client
            .post(app.url("/v1/studies"))
            .header("content-type", kind)
            .body(body);
        async move { request.send().await.expect("an answer") }
    };
    problem(
        send("text/plain", study().to_string()).await,
        StatusCode::UNSUPPORTED_MEDIA_TYPE,
    )
    .await;
    problem(
        send("application/json", "{\"name\":".to_owned()).await,
        StatusCode::BAD_REQUEST,
    )
    .await;
    problem(
        send("application/toml", "name = ".to_owned()).await,
        StatusCode::BAD_REQUEST,
    )
    .await;
    problem(
        send("application/json", "[".repeat(900_000)).await,
        StatusCode::BAD_REQUEST,
    )
    .await;
    problem(
        send("application/json", " ".repeat((1 << 20) + 1)).await,
        StatusCode::PAYLOAD_TOO_LARGE,
    )
    .await;
    problem(
        send("application/json", "[1, 2]".to_owned()).await,
        StatusCode::UNPROCESSABLE_ENTITY,
    )
    .await;
    problem(
        send("application/json", "{\"name\": 1e999}".to_owned()).await,
        StatusCode::UNPROCESSABLE_ENTITY,
    )
    .await;
    let zipped = app
        .client
        .post(app.url("/v1/studies"))
        .header("content-encoding", "gzip")
        .json(&study());
    problem(
        zipped.send().await.expect("an answer"),
        StatusCode::UNSUPPORTED_MEDIA_TYPE,
    )
    .await;
    assert_eq!(app.json("/v1/studies").await["studies"], json!([]));
}

#[tokio::test(flavor = "multi_thread")]
async fn wrong_addresses_and_methods_are_refused() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    problem(app.get("/v1/nothing").await, StatusCode::NOT_FOUND).await;
    problem(app.get("/v1/studies/%FF").await, StatusCode::BAD_REQUEST).await;
    for (method, path) in [
        (Method::PUT, "/v1/studies"),
        (Method::DELETE, "/v1/presets"),
        (Method::POST, "/healthz"),
    ] {
        let response = app
            .client
            .request(method, app.url(path))
            .send()
            .await
            .expect("an answer");
        assert!(response.headers().contains_key("allow"), "{path}");
        problem(response, StatusCode::METHOD_NOT_ALLOWED).await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_client_that_does_not_finish_its_headers_is_dropped() {
    use tokio::io::{AsyncReadExt, AsyncWriteExt};
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut stream = tokio::net::TcpStream::connect(app.service.address())
        .await
        .expect("connects");
    stream
        .write_all(b"GET /healthz HTTP/1.1\r\nHost: local")
        .await
        .expect("writes");
    let mut answer = Vec::new();
    // The limit is five seconds; a loaded machine may be late.
    let closed = tokio::time::timeout(
        std::time::Duration::from_secs(15),
        stream.read_to_end(&mut answer),
    )
    .await;
    assert!(closed.is_ok(), "the connection is still open");
}
