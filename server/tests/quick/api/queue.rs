//! Queue that survives a stop, a crash, and a second service.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;
use serde_json::{Value, json};
use server::running::StartError;
use sqlx::SqliteConnection;
use store::StoreError;

use crate::app::{App, Home, problem, slow, study};

type Row = (i64, String, String);

async fn evaluations(sql: &mut SqliteConnection) -> Vec<Row> {
    sqlx::query_as("select rowid, key, created from evaluations order by rowid")
        .fetch_all(sql)
        .await
        .expect("rows")
}

async fn result_hash(app: &App, id: &str) -> String {
    app.wait_for(id, "done").await["result_sha256"]
        .as_str()
        .expect("a hash")
        .to_owned()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_stopped_study_resumes_where_it_was_and_gives_the_same_result() {
    let undisturbed = Home::new();
    let app = undisturbed.start(ClosedFormSolver::new()).await;
    let expected = result_hash(&app, &app.submit(&study()).await).await;

    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    app.wait(&id, |study| study["points_done"].as_i64() >= Some(5))
        .await;
    app.service.stop().await.expect("stops");
    let mut sql = home.sql().await;
    let before = evaluations(&mut sql).await;
    assert!(
        before.len() >= 5 && before.len() < 26,
        "{} points",
        before.len()
    );
    let state: String = sqlx::query_scalar("select state from studies")
        .fetch_one(&mut sql)
        .await
        .expect("a state");
    assert_eq!(state, "queued");
    drop(sql);

    let app = home.start(slow()).await;
    assert_eq!(result_hash(&app, &id).await, expected);
    let after = evaluations(&mut home.sql().await).await;
    assert_eq!(after.len(), 26);
    assert_eq!(
        after[..before.len()],
        before,
        "no stored row is written again"
    );
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    assert_eq!(result["cost"]["reused"], before.len());
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_that_a_crash_left_running_goes_on_at_the_next_start() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    app.wait(&id, |study| study["points_done"].as_i64() >= Some(2))
        .await;
    app.service.stop().await.expect("stops");
    // A crash has no time to put its study back.
    sqlx::query("update studies set state_seal = null, state = 'running'")
        .execute(&mut home.sql().await)
        .await
        .expect("changes");
    let app = home.start(ClosedFormSolver::new()).await;
    app.wait_for(&id, "done").await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_second_service_on_the_same_database_is_refused() {
    let home = Home::new();
    let first = home.start(ClosedFormSolver::new()).await;
    let Err(error) = home.try_start(ClosedFormSolver::new()).await else {
        panic!("a second service started")
    };
    assert!(
        matches!(error, StartError::Store(StoreError::InUse { .. })),
        "{error}"
    );
    assert!(error.to_string().contains("test.db"), "{error}");
    first.service.stop().await.expect("stops");
    home.start(ClosedFormSolver::new()).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_point_that_another_study_solved_is_not_solved_again() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let first = app.submit(&study()).await;
    let expected = result_hash(&app, &first).await;
    let second = app.submit(&study()).await;
    assert_eq!(result_hash(&app, &second).await, expected);
    assert_eq!(evaluations(&mut home.sql().await).await.len(), 26);
    let points = app.json(&format!("/v1/studies/{second}/evaluations")).await;
    assert_eq!(
        points["evaluations"].as_array().map(Vec::len),
        Some(26),
        "they are this study's points too"
    );
    assert_eq!(
        app.json(&format!("/v1/studies/{second}/result")).await["cost"]["reused"],
        26
    );
}

/// Returns the study with other depths, so that it shares no point with the first.
fn other_study(largest_mm: f64) -> Value {
    let mut other = study();
    for input in other["inputs"].as_array_mut().expect("inputs") {
        input["distribution"]["max"] = json!(largest_mm);
    }
    other
}

#[tokio::test(flavor = "multi_thread")]
async fn studies_take_turns_and_give_what_they_give_alone() {
    let (big, small) = (study(), other_study(1.2));
    let mut alone = Vec::new();
    for document in [&big, &small] {
        let home = Home::new();
        let app = home.start(ClosedFormSolver::new()).await;
        let id = app.submit(document).await;
        alone.push(result_hash(&app, &id).await);
    }
    let home = Home::new();
    let app = home.start(slow()).await;
    let (first, second) = (app.submit(&big).await, app.submit(&small).await);
    // Each takes longer than a turn, so that the second has had one before the first has ended.
    let seen = app
        .wait(&second, |study| study["points_done"].as_i64() > Some(0))
        .await;
    assert_eq!(seen["finished"], Value::Null);
    assert_ne!(
        app.json(&format!("/v1/studies/{first}")).await["state"],
        "done"
    );
    let together = [
        result_hash(&app, &first).await,
        result_hash(&app, &second).await,
    ];
    assert_eq!(together.as_slice(), alone);
    let points = evaluations(&mut home.sql().await).await;
    assert_eq!(points.len(), 52, "a turn's end repeats nothing");
}

#[tokio::test(flavor = "multi_thread")]
async fn higher_priority_goes_first() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let running = app.submit(&study()).await;
    app.wait_for(&running, "running").await;
    let low = app.submit(&other_study(1.2)).await;
    let request = app.client.post(app.url("/v1/studies?priority=5"));
    let answer = request.json(&other_study(1.1)).send().await;
    let high: Value = answer.expect("an answer").json().await.expect("JSON");
    assert_eq!(high["priority"], 5);
    let high = high["id"].as_str().expect("an id").to_owned();
    let high = app.wait_for(&high, "done").await;
    let low = app.wait_for(&low, "done").await;
    // The lower one may have begun before the higher one came; it then gives way.
    assert!(high["finished"].as_str() < low["finished"].as_str());

    for wrong in ["101", "-101", "1.5", "urgent", ""] {
        let address = app.url(&format!("/v1/studies?priority={wrong}"));
        let answer = app.client.post(address).json(&study()).send().await;
        let body = problem(answer.expect("an answer"), StatusCode::BAD_REQUEST).await;
        assert!(body["detail"].as_str().expect("text").contains("priority"));
    }
}
