//! Results that are sent in pieces.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;
use store::content::sha256;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;

use crate::app::{App, Home, problem, study};

/// Several pieces, and more than the kernel takes for a client that doesn't read.
const LONG: usize = 24 << 20;

/// A service with the result of a study, made long by what JSON doesn't count: the study and the text.
async fn with_long_result(home: &Home) -> (App, String, String) {
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    app.wait_for(&id, "done").await;
    let stored = app.get(&format!("/v1/studies/{id}/result")).await;
    let mut text = stored.text().await.expect("a text");
    text.push_str(&" ".repeat(LONG - text.len()));
    let change =
        "update results set seal = null, document = ?, document_sha256 = ? where study = ?";
    let changed = sqlx::query(change)
        .bind(&text)
        .bind(sha256(&[id.as_bytes(), text.as_bytes()]))
        .bind(&id)
        .execute(&mut home.sql().await)
        .await;
    assert_eq!(changed.expect("changes").rows_affected(), 1);
    (app, id, text)
}

/// Changes the last byte.
async fn damage(home: &Home) {
    let change = "update results set document = substr(document, 1, length(document) - 1) || 'x'";
    let damaged = sqlx::query(change).execute(&mut home.sql().await).await;
    assert_eq!(damaged.expect("damages").rows_affected(), 1);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_long_result_is_sent_whole_with_its_length() {
    let home = Home::new();
    let (app, id, text) = with_long_result(&home).await;
    let path = format!("/v1/studies/{id}/result");
    let answer = app.get(&path).await;
    assert_eq!(answer.headers()["content-length"], LONG.to_string());
    assert_eq!(answer.headers()["content-type"], "application/json");
    let tag = answer.headers()["etag"].clone();
    assert!(answer.text().await.expect("a text") == text);
    let head = app.client.head(app.url(&path)).send().await;
    let head = head.expect("an answer");
    assert_eq!(head.status(), StatusCode::OK);
    assert_eq!(head.headers()["content-length"], LONG.to_string());
    assert_eq!(head.headers()["etag"], tag);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_damaged_long_result_is_refused_and_who_has_it_is_told_that_it_has_not_changed() {
    let home = Home::new();
    let (app, id, _) = with_long_result(&home).await;
    damage(&home).await;
    let path = format!("/v1/studies/{id}/result");
    let body = problem(app.get(&path).await, StatusCode::INTERNAL_SERVER_ERROR).await;
    let detail = body["detail"].as_str().expect("a sentence");
    assert!(detail.contains("damaged") && detail.contains("results"));
    let tag = app.json(&format!("/v1/studies/{id}")).await["result_sha256"].clone();
    let asked = app.client.get(app.url(&path));
    let asked = asked.header(
        "if-none-match",
        format!("\"{}\"", tag.as_str().expect("a hash")),
    );
    let answer = asked.send().await.expect("an answer");
    assert_eq!(answer.status(), StatusCode::NOT_MODIFIED);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_result_that_changes_while_it_is_sent_ends_early() {
    let home = Home::new();
    let (app, id, text) = with_long_result(&home).await;
    let address = app.service.address();
    let mut client = TcpStream::connect(address).await.expect("connects");
    let request = format!("GET /v1/studies/{id}/result HTTP/1.1\r\nHost: {address}\r\n\r\n");
    client.write_all(request.as_bytes()).await.expect("asks");
    let mut answer = vec![0; 1 << 16];
    let begun = client.read(&mut answer).await.expect("reads");
    answer.truncate(begun);
    assert!(answer.starts_with(b"HTTP/1.1 200 "));
    damage(&home).await;
    let mut rest = Vec::new();
    // The end may be an error: what matters is that it comes, and early.
    let _ = client.read_to_end(&mut rest).await;
    answer.extend(rest);
    let head = answer.windows(4).position(|end| end == b"\r\n\r\n");
    let sent = answer.len() - head.expect("a head") - 4;
    assert!(sent < text.len(), "{sent} bytes of a damaged text");
}
