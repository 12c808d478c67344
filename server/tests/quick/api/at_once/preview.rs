//! A document's places at once: what they are, and that nothing stays of them.

use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use fem_client::closed_form::ClosedFormSolver;
use reqwest::{RequestBuilder, StatusCode};
use serde_json::{Value, json};
use service::solving::solver_choice::{SolverName, solver};

use super::Counting;
use crate::app::{App, Home, PATIENCE, problem, slow, study};

fn request(app: &App, document: &Value) -> RequestBuilder {
    let address = app.url("/v1/studies:preview");
    app.client.post(address).json(document)
}

async fn preview(app: &App, document: &Value) -> Value {
    let response = request(app, document).send().await.expect("an answer");
    assert_eq!(response.status(), StatusCode::OK);
    response.json().await.expect("JSON")
}

#[tokio::test(flavor = "multi_thread")]
async fn a_preview_is_the_draft_of_its_study_to_the_bit() {
    let home = Home::new();
    let embedded = solver(SolverName::Embedded, PATIENCE).expect("a solver");
    let app = home.start_on(embedded).await;
    let mut document = study();
    document["inputs"]
        .as_array_mut()
        .expect("inputs")
        .truncate(2);
    document["candidates"]["grid"] = json!({"circumferential": 5, "meridional": 3});
    document["layouts"] = json!({"spacings_deg": [60], "positions": ["crown"]});
    let preview = preview(&app, &document).await;
    assert_eq!(
        (&preview["claim"], &preview["level"]),
        (&json!("none"), &json!("draft"))
    );
    document["accuracy"] = json!({"preset": "draft"});
    let id = app.submit(&document).await;
    app.wait_for(&id, "done").await;
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    for part in ["inputs", "locations", "cut_point", "map"] {
        assert_eq!(preview[part], result[part], "{part}");
    }
    for part in ["sentence", "verdict", "layout", "trade", "films"] {
        assert_eq!(preview["answer"][part], result["answer"][part], "{part}");
    }
    assert_eq!(preview["answer"]["verdict"], "unknown");
    let solves = |part: &str| result["cost"][part].as_u64().expect("a count");
    let all = solves("solves") + solves("layout_solves");
    assert_eq!(preview["solves"].as_u64(), Some(all));
    assert!(preview["map"]["shape"]["inflated_mm"].is_array());
    let left_out = preview["left_out"].to_string();
    assert!(left_out.contains("coarser mesh"), "{left_out}");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_newer_preview_ends_the_one_before_and_nothing_is_stored() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let document = study();
    let first = tokio::spawn(request(&app, &document).send());
    tokio::time::sleep(Duration::from_millis(300)).await;
    let begun = Instant::now();
    let (second, superseded) = tokio::join!(preview(&app, &document), async {
        let answer = first.await.expect("a task").expect("an answer");
        (answer, begun.elapsed())
    });
    assert_eq!(second["solves"], 26);
    let (superseded, after) = superseded;
    // The solve in flight takes a tenth of a second, and isn't waited for.
    assert!(after < Duration::from_secs(1), "{after:?}");
    let refusal = problem(superseded, StatusCode::CONFLICT).await;
    let detail = refusal["detail"].as_str().expect("a sentence");
    assert!(detail.starts_with("superseded"), "{detail}");

    let mut sql = home.sql().await;
    for table in [
        "studies",
        "evaluations",
        "start_states",
        "results",
        "crashes",
    ] {
        let count = sqlx::AssertSqlSafe(format!("select count(*) from {table}"));
        let rows: i64 = sqlx::query_scalar(count)
            .fetch_one(&mut sql)
            .await
            .expect("counts");
        assert_eq!(rows, 0, "{table}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_preview_is_answered_while_a_study_runs_which_goes_on() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    app.wait(&id, |study| study["points_done"].as_i64() >= Some(2))
        .await;
    preview(&app, &study()).await;
    let done = app.wait_for(&id, "done").await;
    assert_eq!(done["points_done"], 26);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_client_that_goes_away_ends_its_preview() {
    let home = Home::new();
    let counting = Counting::slow();
    let app = home.start_on(counting.clone()).await;
    let impatient = request(&app, &study()).timeout(Duration::from_millis(400));
    assert!(impatient.send().await.expect_err("too slow").is_timeout());
    tokio::time::sleep(Duration::from_millis(500)).await;
    let begun = counting.begun.load(Ordering::Relaxed);
    assert!((1..20).contains(&begun), "{begun} of 26 solves");
    tokio::time::sleep(Duration::from_millis(500)).await;
    assert_eq!(counting.begun.load(Ordering::Relaxed), begun);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_preview_beyond_its_limit_says_what_to_do_and_ends() {
    let home = Home::new();
    let counting = Counting::slow();
    let limit = Duration::from_millis(300);
    let app = home.start_with_limit(limit, counting.clone()).await;
    let answer = request(&app, &study()).send().await.expect("an answer");
    let refused = problem(answer, StatusCode::SERVICE_UNAVAILABLE).await;
    let detail = refused["detail"].as_str().expect("a sentence");
    assert!(
        detail.contains("submit the document as a study"),
        "{detail}"
    );
    tokio::time::sleep(Duration::from_millis(500)).await;
    let begun = counting.begun.load(Ordering::Relaxed);
    assert!(begun < 26, "{begun} of 26 solves");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_load_without_equilibrium_has_no_preview() {
    let home = Home::new();
    let app = home
        .start(ClosedFormSolver::new().with_depth_limit(0.5))
        .await;
    let response = request(&app, &study()).send().await.expect("an answer");
    let refused = problem(response, StatusCode::UNPROCESSABLE_ENTITY).await;
    let detail = refused["detail"].to_string();
    assert!(detail.contains("no preview"), "{detail}");
}
