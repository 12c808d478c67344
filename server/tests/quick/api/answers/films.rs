//! Films' signals: served as they are stored, exported, and removed with their study.

use std::sync::Arc;

use reqwest::StatusCode;
use serde_json::{Value, json};

use crate::app::{ByForce, Home, study};

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
    let count = sqlx::query_scalar::<_, i64>("select count(*) from signals");
    let count = count.fetch_one(&mut home.sql().await).await;
    assert_eq!(count.expect("reads"), rows.len() as i64);
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
async fn a_removed_study_leaves_no_signals() {
    let home = Home::new();
    let app = home.start_on(Arc::new(ByForce)).await;
    let id = app.submit(&with_signals()).await;
    app.wait_for(&id, "done").await;
    let removed = app.delete(&format!("/v1/studies/{id}?purge")).await;
    assert_eq!(removed.status(), StatusCode::NO_CONTENT);
    let mut sql = home.sql().await;
    let count = sqlx::query_scalar::<_, i64>("select count(*) from signals");
    assert_eq!(count.fetch_one(&mut sql).await.expect("reads"), 0);
}
