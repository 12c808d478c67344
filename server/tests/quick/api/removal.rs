//! Studies and sweeps that are removed, and a database that may grow only so far.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;
use serde_json::{Value, json};
use server::running::Limits;
use sqlx::SqliteConnection;
use store::file::upkeep;

use crate::app::{App, Home, problem, slow, study};

fn named(name: &str) -> Value {
    let mut document = study();
    document["name"] = json!(name);
    document
}

async fn remove(app: &App, path: &str) {
    let removed = app.delete(&format!("{path}?purge")).await;
    assert_eq!(removed.status(), StatusCode::NO_CONTENT);
    for below in ["", "/result", "/events"] {
        let gone = app.get(&format!("{path}{below}")).await;
        assert_eq!(gone.status(), StatusCode::NOT_FOUND, "{below}");
    }
}

async fn rows(connection: &mut SqliteConnection, table: &str) -> i64 {
    let query = format!("select count(*) from {table}");
    let count = sqlx::query_scalar(sqlx::AssertSqlSafe(query)).fetch_one(connection);
    count.await.expect("reads")
}

async fn faults(home: &Home) -> Vec<String> {
    let found = upkeep::inspect(&home.database(), &|_, _| {}).await;
    found.expect("reads").faults
}

#[tokio::test(flavor = "multi_thread")]
async fn a_removed_study_takes_only_what_is_its_own() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let (kept, other) = (app.submit(&named("kept")).await, {
        let mut other = named("other");
        // One input of another range: the points on its line are this study's own.
        other["inputs"][0]["distribution"] = json!({"kind": "uniform", "min": 0.9, "max": 1.1});
        app.submit(&other).await
    });
    for id in [&kept, &other] {
        app.wait_for(id, "done").await;
    }
    let mut sql = home.sql().await;
    let both = rows(&mut sql, "evaluations").await;
    let before = app.json(&format!("/v1/studies/{kept}/result")).await;
    remove(&app, &format!("/v1/studies/{other}")).await;
    assert!(rows(&mut sql, "evaluations").await < both);
    let after = app.json(&format!("/v1/studies/{kept}/result")).await;
    assert_eq!(after, before);
    assert_eq!(faults(&home).await, Vec::<String>::new());

    remove(&app, &format!("/v1/studies/{kept}")).await;
    for table in [
        "studies",
        "evaluations",
        "start_states",
        "strain_fields",
        "study_points",
        "results",
        "events",
        "location_scores",
        "result_maps",
        "result_extracts",
    ] {
        assert_eq!(rows(&mut sql, table).await, 0, "{table}");
    }
    let list = app.json("/v1/studies").await;
    assert_eq!(list["studies"], json!([]));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_running_study_is_cancelled_and_removed_and_the_next_one_runs() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let running = app.submit(&named("running")).await;
    let next = app.submit(&named("next")).await;
    app.wait(&running, |study| study["points_done"].as_u64() > Some(2))
        .await;
    remove(&app, &format!("/v1/studies/{running}")).await;
    app.wait_for(&next, "running").await;
    let mut sql = home.sql().await;
    assert_eq!(faults(&home).await, Vec::<String>::new());
    remove(&app, &format!("/v1/studies/{next}")).await;
    assert_eq!(rows(&mut sql, "evaluations").await, 0);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_key_is_free_again_when_its_study_is_removed() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let send = async || {
        let request = app.client.post(app.url("/v1/studies")).json(&study());
        let sent = request.header("idempotency-key", "night-run").send().await;
        let body: Value = sent.expect("an answer").json().await.expect("JSON");
        body["id"].as_str().expect("an id").to_owned()
    };
    let first = send().await;
    assert_eq!(send().await, first);
    remove(&app, &format!("/v1/studies/{first}")).await;
    assert_ne!(send().await, first);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_sweep_is_removed_with_its_designs_and_they_only_with_it() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let document =
        json!({"name": "walls", "study": study(), "grid": {"geometry.wall_mm": [2.5, 3]}});
    let request = app.client.post(app.url("/v1/sweeps")).json(&document);
    let sweep: Value = request
        .send()
        .await
        .expect("an answer")
        .json()
        .await
        .expect("JSON");
    let id = sweep["id"].as_str().expect("an id");
    let design = sweep["designs"][0]["study"]["id"].as_str();
    let design = design.unwrap_or_else(|| panic!("{sweep}"));
    let refused = app
        .delete(&format!("/v1/studies/{design}?purge=true"))
        .await;
    let detail = problem(refused, StatusCode::CONFLICT).await["detail"].to_string();
    assert!(detail.contains(id), "{detail}");
    let removed = app.delete(&format!("/v1/sweeps/{id}?purge")).await;
    assert_eq!(removed.status(), StatusCode::NO_CONTENT);
    for path in [format!("/v1/sweeps/{id}"), format!("/v1/studies/{design}")] {
        assert_eq!(app.get(&path).await.status(), StatusCode::NOT_FOUND);
    }
    let mut sql = home.sql().await;
    for table in ["studies", "sweeps", "sweep_designs", "evaluations"] {
        assert_eq!(rows(&mut sql, table).await, 0, "{table}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn what_is_neither_yes_nor_no_removes_nothing() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    let asked = app.delete(&format!("/v1/studies/{id}?purge=maybe")).await;
    problem(asked, StatusCode::BAD_REQUEST).await;
    app.wait_for(&id, "done").await;
    let asked = app.delete(&format!("/v1/studies/{id}?purge=false")).await;
    assert_eq!(asked.status(), StatusCode::ACCEPTED);
}

/// The limit leaves some ten studies room: their results, for all have the same points.
#[tokio::test(flavor = "multi_thread")]
async fn a_database_that_may_not_grow_takes_studies_again_when_some_are_removed() {
    const MOST_BYTES: u64 = 2_000_000;
    let home = Home::new();
    let limits = Limits {
        database_bytes: Some(MOST_BYTES),
        ..Limits::default()
    };
    let app = home.start_with(ClosedFormSolver::new(), limits).await;
    let mut ids = Vec::new();
    let refused = loop {
        let answer = app.post(&named(&format!("study {}", ids.len()))).await;
        if answer.status() != StatusCode::ACCEPTED {
            break answer;
        }
        let body: Value = answer.json().await.expect("JSON");
        let id = body["id"].as_str().expect("an id").to_owned();
        app.wait_for(&id, "done").await;
        ids.push(id);
        assert!(ids.len() < 1000, "the limit isn't heeded");
    };
    assert!(refused.headers().contains_key("retry-after"));
    let detail = problem(refused, StatusCode::INSUFFICIENT_STORAGE).await["detail"].to_string();
    assert!(detail.contains("--max-database-mb"), "{detail}");
    for id in &ids {
        remove(&app, &format!("/v1/studies/{id}")).await;
    }
    app.submit(&named("again")).await;
    let size = std::fs::metadata(home.database()).expect("is there").len();
    assert!(size <= MOST_BYTES, "{size}");
}
