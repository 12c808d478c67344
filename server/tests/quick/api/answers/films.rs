//! Films' signals: served as they are stored, exported, and removed with their study.

use std::sync::Arc;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use reqwest::StatusCode;
use serde_json::{Value, json};

use crate::app::{Home, problem, study};

/// The closed form on a ground that presses by force: a tenth of a millimetre for each newton.
struct ByForce;

impl Solver for ByForce {
    fn version(&self) -> String {
        "closed form by force".to_owned()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let mut scene = request.scene.clone();
        if let Some(load) = scene.ground.load_n {
            scene.ground = scene.ground.at_depths(vec![0.1 * load; 5]);
        }
        ClosedFormSolver::new().solve(&SolveRequest {
            scene: &scene,
            ..*request
        })
    }
}

fn with_signals() -> Value {
    let mut document = study();
    document["signals"] =
        json!({"loads_n": [2, 5, 10], "films": ["bare", "coupled"], "positions": ["crown"]});
    document
}

#[tokio::test(flavor = "multi_thread")]
async fn signals_are_served_and_exported_as_the_result_has_them() {
    let home = Home::new();
    let app = home.start_on(Arc::new(ByForce)).await;
    let id = app.submit(&with_signals()).await;
    app.wait_for(&id, "done").await;
    let at = |part: &str| format!("/v1/studies/{id}/{part}");
    let result = app.json(&at("result")).await;
    let signals = app.json(&at("signals")).await;
    assert_eq!(signals, result["signals"]);
    for (list, length) in [("curves", 12), ("pairs", 4), ("widths", 3), ("claims", 12)] {
        assert_eq!(
            signals[list].as_array().map(Vec::len),
            Some(length),
            "{list}"
        );
    }
    let rows = signals["rows"].as_array().expect("a list");
    assert_eq!(rows.len(), 2 * 2 * (3 + 3 + 7));
    let (bare, coupled) = rows.split_at(rows.len() / 2);
    assert!(bare.iter().all(|row| row["open_circuit_v"].is_number()));
    assert!(
        coupled
            .iter()
            .all(|row| row["open_circuit_v"].is_null() && row["reason"].is_string())
    );

    let csv = app.get(&at("export?format=csv&table=signals")).await;
    let text = csv.text().await.expect("a body");
    let mut lines = text.lines();
    assert!(
        lines
            .next()
            .is_some_and(|line| line.starts_with("tire,film,position,direction,over,load_n"))
    );
    assert_eq!(lines.count(), rows.len());
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_that_asks_for_none_has_none_and_a_removed_one_leaves_none() {
    let home = Home::new();
    let app = home.start_on(Arc::new(ByForce)).await;
    let plain = app.submit(&study()).await;
    app.wait_for(&plain, "done").await;
    let none = app.get(&format!("/v1/studies/{plain}/signals")).await;
    let none = problem(none, StatusCode::NOT_FOUND).await;
    assert!(
        none["detail"]
            .as_str()
            .expect("a sentence")
            .contains("asks for none")
    );
    let absent = app.get("/v1/studies/x/signals").await;
    problem(absent, StatusCode::NOT_FOUND).await;

    let id = app.submit(&with_signals()).await;
    app.wait_for(&id, "done").await;
    let removed = app.delete(&format!("/v1/studies/{id}?purge")).await;
    assert_eq!(removed.status(), StatusCode::NO_CONTENT);
    let mut sql = home.sql().await;
    for table in ["signals", "signal_findings"] {
        let query = format!("select count(*) from {table}");
        let count = sqlx::query_scalar::<_, i64>(sqlx::AssertSqlSafe(query)).fetch_one(&mut sql);
        assert_eq!(count.await.expect("reads"), 0, "{table}");
    }
}
