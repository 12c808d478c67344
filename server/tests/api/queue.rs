//! What survives a stop, a crash, and a second service.

use fem_client::closed_form::ClosedFormSolver;
use server::service::StartError;
use server::store::StoreError;
use sqlx::SqliteConnection;

use crate::support::{App, Home, slow, study};

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
    app.service.stop().await;
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
    app.service.stop().await;
    // A crash has no time to put its study back.
    sqlx::query("update studies set state = 'running'")
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
    first.service.stop().await;
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

#[tokio::test(flavor = "multi_thread")]
async fn studies_run_one_after_the_other_oldest_first() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let (first, second) = (app.submit(&study()).await, app.submit(&study()).await);
    app.wait_for(&first, "running").await;
    assert_eq!(
        app.json(&format!("/v1/studies/{second}")).await["state"],
        "queued"
    );
    let (first, second) = (
        app.wait_for(&first, "done").await,
        app.wait_for(&second, "done").await,
    );
    assert!(first["finished"].as_str() <= second["started"].as_str());
}
