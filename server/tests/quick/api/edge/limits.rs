//! Limits on what a client can make the service hold, and what it needn't send again.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::{Response, StatusCode};
use serde_json::{Value, json};
use server::running::{Limits, Outside};

use crate::app::{App, Home, endless, problem, slow, study};

/// The answer to a client that has what the tag says.
async fn again(app: &App, path: &str, etag: &str) -> Response {
    let request = app.client.get(app.url(path)).header("if-none-match", etag);
    request.send().await.expect("an answer")
}

fn etag(response: &Response) -> String {
    assert_eq!(response.headers()["cache-control"], "no-cache");
    response.headers()["etag"]
        .to_str()
        .expect("text")
        .to_owned()
}

/// A refusal for now.
async fn too_many(response: Response) -> Value {
    let retry: u64 = response.headers()["retry-after"]
        .to_str()
        .expect("text")
        .parse()
        .expect("seconds");
    assert!((1..=60).contains(&retry));
    problem(response, StatusCode::TOO_MANY_REQUESTS).await
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_and_a_list_that_have_not_changed_are_not_sent_again() {
    let home = Home::new();
    let app = home.start_for(Outside::default()).await;
    let id = app.submit(&study()).await;
    app.wait_for(&id, "done").await;
    for path in [
        format!("/v1/studies/{id}"),
        "/v1/studies".to_owned(),
        format!("/v1/studies/{id}/result"),
    ] {
        let tag = etag(&app.get(&path).await);
        let unchanged = again(&app, &path, &tag).await;
        assert_eq!(unchanged.status(), StatusCode::NOT_MODIFIED, "{path}");
        assert_eq!(unchanged.headers()["etag"], tag.as_str());
        assert_eq!(unchanged.text().await.expect("text"), "");
        let other = again(&app, &path, "\"something else\"").await;
        assert_eq!(other.status(), StatusCode::OK, "{path}");
    }
    let before = etag(&app.get("/v1/studies").await);
    app.submit(&study()).await;
    let changed = again(&app, "/v1/studies", &before).await;
    assert_eq!(changed.status(), StatusCode::OK);
    assert_ne!(etag(&changed), before);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_full_queue_takes_no_more_until_some_are_done() {
    let home = Home::new();
    let limits = Limits {
        waiting_studies: 2,
        ..Limits::default()
    };
    let app = home.start_with(endless(), limits).await;
    let running = app.submit(&study()).await;
    app.wait_for(&running, "running").await;
    let send = |key: &'static str| {
        let request = app
            .client
            .post(app.url("/v1/studies"))
            .header("idempotency-key", key);
        async move { request.json(&study()).send().await.expect("an answer") }
    };
    for key in ["first", "second"] {
        assert_eq!(send(key).await.status(), StatusCode::ACCEPTED);
    }
    let refused = too_many(send("third").await).await;
    assert!(
        refused["detail"]
            .as_str()
            .is_some_and(|detail| detail.contains("2 studies may wait")),
        "{refused}"
    );
    // What was taken in is found again, however full the queue is.
    assert_eq!(send("second").await.status(), StatusCode::ACCEPTED);
    assert_eq!(
        app.json("/v1/studies").await["studies"]
            .as_array()
            .map(Vec::len),
        Some(3)
    );
    app.delete(&format!("/v1/studies/{running}")).await;
    app.wait(&running, |_| true).await;
    let waiting = app.json("/v1/studies?state=queued").await["studies"][0]["id"].clone();
    app.delete(&format!("/v1/studies/{}", waiting.as_str().expect("an id")))
        .await;
    assert_eq!(send("third").await.status(), StatusCode::ACCEPTED);
    app.service.stop().await.expect("stops");
}

#[tokio::test(flavor = "multi_thread")]
async fn designs_of_a_sweep_wait_in_the_same_line() {
    let home = Home::new();
    let limits = Limits {
        waiting_studies: 2,
        ..Limits::default()
    };
    let app = home.start_with(endless(), limits).await;
    let post = |path: String, body: Value| {
        let request = app.client.post(app.url(&path)).json(&body);
        async move { request.send().await.expect("an answer") }
    };
    let running = app.submit(&study()).await;
    app.wait_for(&running, "running").await;
    let walls = |walls: &[f64]| json!({"study": study(), "grid": {"geometry.wall_mm": walls}});
    too_many(post("/v1/sweeps".to_owned(), walls(&[2.5, 3.0, 3.5])).await).await;
    let sweep = post("/v1/sweeps".to_owned(), walls(&[2.5, 3.0])).await;
    assert_eq!(sweep.status(), StatusCode::ACCEPTED);
    let sweep: Value = sweep.json().await.expect("JSON");
    let path = format!("/v1/sweeps/{}", sweep["id"].as_str().expect("an id"));

    // What the sweep has takes no place, what is new does.
    let further = |walls: &[f64]| json!({"grid": {"geometry.wall_mm": walls}});
    let same = post(format!("{path}/designs"), further(&[2.5, 3.0])).await;
    assert_eq!(same.status(), StatusCode::ACCEPTED);
    too_many(post(format!("{path}/designs"), further(&[3.5])).await).await;

    app.delete(&path).await;
    let other = app.submit(&study()).await;
    too_many(post(format!("{path}/resume"), json!({})).await).await;
    let after = app.json(&path).await;
    assert_eq!(after["counts"]["cancelled"], 2, "{after}");
    app.delete(&format!("/v1/studies/{other}")).await;
    let resumed = post(format!("{path}/resume"), json!({})).await;
    assert_eq!(resumed.status(), StatusCode::ACCEPTED);
    assert_eq!(app.json(&path).await["counts"]["queued"], 2);
    app.service.stop().await.expect("stops");
}

#[tokio::test(flavor = "multi_thread")]
async fn event_streams_are_few_and_a_place_is_free_when_one_ends() {
    let home = Home::new();
    let limits = Limits {
        event_streams: 2,
        ..Limits::default()
    };
    let app = home.start_with(slow(), limits).await;
    let id = app.submit(&study()).await;
    let path = format!("/v1/studies/{id}/events");
    let streams = [app.get(&path).await, app.get(&path).await];
    too_many(app.get(&path).await).await;
    for stream in streams {
        assert!(
            stream
                .text()
                .await
                .expect("a stream")
                .contains("event: done")
        );
    }
    let after = app.client.get(app.url(&path)).header("last-event-id", 0);
    assert_eq!(
        after.send().await.expect("an answer").status(),
        StatusCode::OK
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn too_many_headers_are_refused_with_a_document() {
    let home = Home::new();
    let app = home.start_for(Outside::default()).await;
    let with = |count: usize| {
        let fill =
            |request: reqwest::RequestBuilder, n| request.header(format!("x-filling-{n}"), "x");
        (0..count).fold(app.client.get(app.url("/healthz")), fill)
    };
    let few = with(80).send().await.expect("an answer");
    assert_eq!(
        few.json::<Value>().await.expect("JSON")["status"],
        json!("ok")
    );
    let many = with(200).send().await.expect("an answer");
    problem(many, StatusCode::REQUEST_HEADER_FIELDS_TOO_LARGE).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_that_would_not_fit_is_refused_with_its_estimate() {
    let home = Home::new();
    let limits = Limits {
        memory_bytes: 200_000_000,
        ..Limits::default()
    };
    let app = home.start_with(slow(), limits).await;
    let on_level = |level: &str| {
        let mut document = study();
        document["accuracy"] = json!({"preset": level});
        document
    };
    app.submit(&on_level("draft")).await;
    let answer = app.post(&on_level("reference")).await;
    let body = problem(answer, StatusCode::UNPROCESSABLE_ENTITY).await;
    let detail = body["detail"].as_str().expect("text");
    assert!(
        detail.contains("GB of memory, and 0.20 GB are there"),
        "{detail}"
    );
    let list = app.json("/v1/studies").await;
    assert_eq!(list["studies"].as_array().map(Vec::len), Some(1));
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
