//! A database that is removed under the service.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;

use crate::app::{Home, problem, slow, study};

#[tokio::test(flavor = "multi_thread")]
async fn a_removed_database_is_said_and_no_study_ends_until_it_is_back() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    app.wait(&id, |study| study["points_done"].as_i64() >= Some(2))
        .await;
    let (file, away) = (home.database(), home.database().with_extension("away"));
    std::fs::rename(&file, &away).expect("moves");
    for response in [
        app.post(&study()).await,
        app.get("/readyz").await,
        app.get(&format!("/v1/studies/{id}")).await,
    ] {
        let problem = problem(response, StatusCode::SERVICE_UNAVAILABLE).await;
        let detail = problem["detail"].as_str().expect("a sentence");
        assert!(detail.contains("removed or replaced"), "{detail}");
    }
    assert_eq!(app.get("/healthz").await.status(), StatusCode::OK);
    std::fs::rename(&away, &file).expect("moves back");
    // Not failed meanwhile.
    app.wait_for(&id, "done").await;
    app.service.stop().await.expect("stops");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_service_whose_database_was_replaced_does_not_end_as_if_nothing_were() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let other = home.database().with_extension("other");
    std::fs::copy(home.database(), &other).expect("copies");
    std::fs::rename(&other, home.database()).expect("replaces");
    let error = app.service.stop().await.expect_err("was replaced");
    assert!(error.to_string().contains("test.db"), "{error}");
}
