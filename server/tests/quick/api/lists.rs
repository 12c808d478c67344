//! Lists that are searched, and studies and sweeps that are renamed and archived.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::{Response, StatusCode};
use serde_json::{Value, json};

use crate::app::{App, Home, study};

async fn patch(app: &App, path: &str, change: &Value) -> Response {
    let request = app.client.patch(app.url(path)).json(change);
    request.send().await.expect("an answer")
}

async fn changed(app: &App, path: &str, change: Value) -> Value {
    let answer = patch(app, path, &change).await;
    assert_eq!(answer.status(), StatusCode::OK);
    answer.json().await.expect("JSON")
}

/// Names of the entries, newest first.
async fn names(app: &App, kind: &str, query: &str) -> Vec<String> {
    let page = app.json(&format!("/v1/{kind}?{query}")).await;
    let entries = page[kind].as_array().expect("a list");
    let name = |entry: &Value| entry["name"].as_str().expect("a name").to_owned();
    entries.iter().map(name).collect()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_is_renamed_in_lists_alone_and_archived() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    let path = format!("/v1/studies/{id}");
    let before = app.wait_for(&id, "done").await;
    let result = app.json(&format!("{path}/result")).await;

    let change = json!({"name": "Thin 50%_wall", "archived": true});
    let first = changed(&app, &path, change.clone()).await;
    assert_eq!(first["name"], "Thin 50%_wall");
    assert!(first["archived"].is_string(), "{first}");
    assert_eq!(changed(&app, &path, change).await, first, "changed again");

    let after = app.json(&path).await;
    assert_eq!(after["name"], "Thin 50%_wall");
    assert_eq!(after["document"], before["document"]);
    assert_eq!(after["spec_sha256"], before["spec_sha256"]);
    assert_eq!(app.json(&format!("{path}/result")).await, result);

    assert!(names(&app, "studies", "").await.is_empty());
    let back = changed(&app, &path, json!({"archived": false})).await;
    assert_eq!(
        (&back["archived"], &back["name"]),
        (&Value::Null, &first["name"])
    );
    assert_eq!(names(&app, "studies", "").await.len(), 1);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_list_is_searched_page_by_page() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut ids = Vec::new();
    for name in ["Wall 1", "wall 2", "bead", "WALL 3"] {
        let id = app.submit(&study()).await;
        changed(&app, &format!("/v1/studies/{id}"), json!({"name": name})).await;
        app.wait_for(&id, "done").await;
        ids.push(id);
    }
    assert_eq!(
        names(&app, "studies", "search=wall").await,
        ["WALL 3", "wall 2", "Wall 1"]
    );
    assert!(names(&app, "studies", "search=w%25l").await.is_empty());
    assert_eq!(
        names(&app, "studies", &format!("search={}", ids[2])).await,
        ["bead"]
    );

    let page = app.json("/v1/studies?search=wall&limit=2").await;
    let cursor = page["next_cursor"].as_str().expect("a cursor");
    let query = format!("search=wall&limit=2&cursor={cursor}");
    assert_eq!(names(&app, "studies", &query).await, ["Wall 1"]);

    let asked = app.get("/v1/studies?search=wall").await;
    let tag = asked.headers()["etag"].clone();
    let again = |tag| {
        app.client
            .get(app.url("/v1/studies?search=wall"))
            .header("if-none-match", tag)
            .send()
    };
    let status = again(tag.clone()).await.expect("an answer").status();
    assert_eq!(status, StatusCode::NOT_MODIFIED);
    changed(
        &app,
        &format!("/v1/studies/{}", ids[0]),
        json!({"archived": true}),
    )
    .await;
    assert_eq!(
        again(tag).await.expect("an answer").status(),
        StatusCode::OK
    );
    for (query, found) in [
        ("search=wall", &["WALL 3", "wall 2"][..]),
        ("search=wall&archived=true", &["Wall 1"]),
        ("search=wall&archived=all", &["WALL 3", "wall 2", "Wall 1"]),
    ] {
        assert_eq!(names(&app, "studies", query).await, found, "{query}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_sweep_is_found_renamed_and_archived() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let document = json!({"name": "walls", "study": study(), "grid": {"geometry.wall_mm": [2.5]}});
    let request = app.client.post(app.url("/v1/sweeps")).json(&document);
    let sweep: Value = request
        .send()
        .await
        .expect("an answer")
        .json()
        .await
        .expect("JSON");
    let path = format!("/v1/sweeps/{}", sweep["id"].as_str().expect("an id"));
    changed(&app, &path, json!({"name": "Walls, thin"})).await;
    assert_eq!(names(&app, "sweeps", "search=THIN").await, ["Walls, thin"]);
    assert!(names(&app, "sweeps", "search=thick").await.is_empty());
    let archived = changed(&app, &path, json!({"archived": true})).await;
    assert!(
        archived["archived"].is_string() && archived["name"] == "Walls, thin",
        "{archived}"
    );
    assert!(names(&app, "sweeps", "").await.is_empty());
    assert_eq!(names(&app, "sweeps", "archived=true").await.len(), 1);
    assert_eq!(app.json(&path).await["archived"], archived["archived"]);
}
