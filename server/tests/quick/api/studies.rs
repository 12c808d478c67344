//! `/v1/studies`.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;
use serde_json::{Value, json};

use crate::app::{Home, problem, slow, study};

#[tokio::test(flavor = "multi_thread")]
async fn a_study_may_be_sent_as_toml() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let (_, text) = documents::study::presets()[0];
    let request = app
        .client
        .post(app.url("/v1/studies"))
        .header("content-type", "application/toml; charset=utf-8");
    let response = request.body(text).send().await.expect("an answer");
    assert_eq!(response.status(), StatusCode::ACCEPTED);
    let body: Value = response.json().await.expect("JSON");
    app.wait_for(body["id"].as_str().expect("an id"), "done")
        .await;
}

#[tokio::test(flavor = "multi_thread")]
async fn the_same_study_under_the_same_key_is_taken_in_once() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let send = |document: Value| {
        let request = app
            .client
            .post(app.url("/v1/studies"))
            .header("idempotency-key", "morning run");
        async move { request.json(&document).send().await.expect("an answer") }
    };
    let first: Value = send(study()).await.json().await.expect("JSON");
    let again = send(study()).await;
    assert_eq!(again.status(), StatusCode::ACCEPTED);
    assert_eq!(
        again.json::<Value>().await.expect("JSON")["id"],
        first["id"]
    );

    let mut other = study();
    other["name"] = json!("another study");
    problem(send(other).await, StatusCode::UNPROCESSABLE_ENTITY).await;
    assert_eq!(
        app.json("/v1/studies").await["studies"]
            .as_array()
            .map(Vec::len),
        Some(1)
    );

    let without_key = app.submit(&study()).await;
    assert_ne!(json!(without_key), first["id"]);
}

#[tokio::test(flavor = "multi_thread")]
async fn the_list_comes_in_pages_newest_first() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut ids = Vec::new();
    for _ in 0..5 {
        ids.push(app.submit(&study()).await);
    }
    ids.reverse();
    let (mut seen, mut cursor) = (Vec::new(), String::new());
    loop {
        let page = app.json(&format!("/v1/studies?limit=2{cursor}")).await;
        let studies = page["studies"].as_array().expect("a list");
        assert!(studies.len() <= 2);
        seen.extend(
            studies
                .iter()
                .filter_map(|study| study["id"].as_str().map(str::to_owned)),
        );
        let Some(next) = page["next_cursor"].as_str() else {
            break;
        };
        cursor = format!("&cursor={next}");
    }
    assert_eq!(seen, ids);

    for id in &ids {
        app.wait_for(id, "done").await;
    }
    assert_eq!(
        app.json("/v1/studies?state=done").await["studies"]
            .as_array()
            .map(Vec::len),
        Some(5)
    );
    assert_eq!(
        app.json("/v1/studies?state=failed").await["studies"],
        json!([])
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_running_study_is_cancelled_and_keeps_its_points() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let id = app.submit(&study()).await;
    let path = format!("/v1/studies/{id}");
    app.wait(&id, |study| study["points_done"].as_i64() >= Some(2))
        .await;
    let waiting = app.submit(&study()).await;

    let cancelled = app.delete(&path).await;
    assert_eq!(cancelled.status(), StatusCode::ACCEPTED);
    assert_eq!(
        cancelled.json::<Value>().await.expect("JSON")["state"],
        "cancelled"
    );
    assert_eq!(app.delete(&path).await.status(), StatusCode::ACCEPTED);
    problem(
        app.get(&format!("{path}/result")).await,
        StatusCode::NOT_FOUND,
    )
    .await;
    let points = app.json(&format!("{path}/evaluations")).await;
    assert!(
        points["evaluations"]
            .as_array()
            .is_some_and(|points| points.len() >= 2)
    );

    // The queue goes on, with the cancelled study's points.
    app.wait_for(&waiting, "done").await;
    let result = app.json(&format!("/v1/studies/{waiting}/result")).await;
    assert!(result["cost"]["reused"].as_u64() >= Some(2));
    assert_eq!(app.json(&path).await["state"], "cancelled");
    problem(app.delete("/v1/studies/none").await, StatusCode::NOT_FOUND).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_whose_cut_point_has_no_equilibrium_fails_and_names_it() {
    let home = Home::new();
    // The cut point lies at 1 mm.
    let app = home
        .start(ClosedFormSolver::new().with_depth_limit(0.9))
        .await;
    let id = app.submit(&study()).await;
    let failed = app.wait_for(&id, "failed").await;
    let error = failed["error"].as_str().expect("a sentence");
    assert!(
        error.contains("point 0 at [1.0, 1.0, 1.0, 1.0, 1.0]: not-converged: no equilibrium"),
        "{error}"
    );
    let body = problem(
        app.get(&format!("/v1/studies/{id}/result")).await,
        StatusCode::NOT_FOUND,
    )
    .await;
    assert!(
        body["detail"]
            .as_str()
            .is_some_and(|detail| detail.contains(error)),
        "{body}"
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_study_is_estimated_before_and_the_estimate_is_kept_with_it() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let ask = |document: Value| {
        let request = app
            .client
            .post(app.url("/v1/studies:estimate"))
            .json(&document);
        async move { request.send().await.expect("an answer") }
    };
    let estimate: Value = ask(study()).await.json().await.expect("JSON");
    assert_eq!(estimate["solves"]["left"]["expected"], 26);
    assert_eq!(estimate["accuracy"]["fidelity"], "standard mdrm 5");
    // Nothing is known of a solver that isn't the one whose times were measured.
    assert!(estimate["wall_s"].is_null() && estimate["measured_solves"] == 0);
    assert_eq!(app.json("/v1/studies").await["studies"], json!([]));

    let id = app.submit(&study()).await;
    app.wait_for(&id, "done").await;
    assert_eq!(
        app.json(&format!("/v1/studies/{id}")).await["estimate"],
        estimate
    );
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    assert_eq!(result["estimate"], estimate);
    let again: Value = ask(study()).await.json().await.expect("JSON");
    assert_eq!(again["solves"]["known"], 26);
    assert!(
        again["measured_solves"].as_u64() > Some(10) && again["wall_s"].is_object(),
        "{again}"
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn the_same_study_again_has_its_answer_at_once_and_shares_every_point() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let first = app.submit(&study()).await;
    let first = app.wait_for(&first, "done").await;
    let again = app.submit(&study()).await;
    let again = app.wait_for(&again, "done").await;
    for field in ["result_sha256", "points_total", "points_done", "document"] {
        assert_eq!(first[field], again[field], "{field}");
    }
    let id = |study: &Value| study["id"].as_str().expect("an id").to_owned();
    let result = app
        .json(&format!("/v1/studies/{}/result", id(&again)))
        .await;
    assert_eq!(result["study"]["id"], again["id"]);
    assert_eq!(
        (&result["cost"]["solves"], &result["cost"]["reused"]),
        (&json!(26), &json!(26))
    );
    let points = |study: &Value| format!("/v1/studies/{}/evaluations", id(study));
    assert_eq!(
        app.json(&points(&first)).await,
        app.json(&points(&again)).await
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_damaged_answer_is_not_taken_over_but_computed_from_the_points() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let first = app.submit(&study()).await;
    let first = app.wait_for(&first, "done").await;
    sqlx::query("update results set document = replace(document, 'P3', 'P4')")
        .execute(&mut home.sql().await)
        .await
        .expect("damages");
    let again = app.submit(&study()).await;
    let again = app.wait_for(&again, "done").await;
    assert_eq!(first["result_sha256"], again["result_sha256"]);
    let path = format!(
        "/v1/studies/{}/result",
        again["id"].as_str().expect("an id")
    );
    assert_eq!(app.json(&path).await["locations"][0]["name"], "P3");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_damaged_document_is_never_run_and_never_answers_an_intact_one() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    let intact = app.wait_for(&id, "done").await;
    app.service.stop().await.expect("closes");
    let damage =
        "update studies set state = 'queued', finished = null, spec = replace(spec, '0.7', '0.2')";
    let mut sql = home.sql().await;
    let damaged = sqlx::query(damage).execute(&mut sql).await;
    assert_eq!(damaged.expect("damages").rows_affected(), 1);
    drop(sql);

    let app = home.start(ClosedFormSolver::new()).await;
    let listed = |page: &Value| page["studies"][0]["state"] == "failed";
    while !listed(&app.json("/v1/studies").await) {
        tokio::time::sleep(std::time::Duration::from_millis(10)).await;
    }
    let refused = app.get(&format!("/v1/studies/{id}")).await;
    let body = problem(refused, StatusCode::INTERNAL_SERVER_ERROR).await;
    let detail = body["detail"].as_str().expect("a sentence");
    assert!(detail.contains("studies") && detail.contains(&id), "{body}");
    let again = app.submit(&study()).await;
    let again = app.wait_for(&again, "done").await;
    assert_eq!(again["result_sha256"], intact["result_sha256"]);
}

#[tokio::test(flavor = "multi_thread")]
async fn exchanged_points_are_never_served_and_never_taken_over() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    let intact = app.wait_for(&id, "done").await;
    let exchange = "update study_points set evaluation = (select evaluation from study_points other
                        where other.study = study_points.study and other.ordinal = 3 - study_points.ordinal)
                    where ordinal in (1, 2)";
    let exchanged = sqlx::query(exchange).execute(&mut home.sql().await).await;
    assert_eq!(exchanged.expect("exchanges").rows_affected(), 2);

    let refused = app.get(&format!("/v1/studies/{id}/evaluations")).await;
    let body = problem(refused, StatusCode::INTERNAL_SERVER_ERROR).await;
    let detail = body["detail"].as_str().expect("a sentence");
    assert!(
        detail.contains("study_points") && detail.contains(&id),
        "{body}"
    );
    let again = app.submit(&study()).await;
    let again = app.wait_for(&again, "done").await;
    assert_eq!(again["result_sha256"], intact["result_sha256"]);
    let points = app
        .json(&format!(
            "/v1/studies/{}/evaluations",
            again["id"].as_str().expect("an id")
        ))
        .await;
    assert_eq!(points["evaluations"][1]["ordinal"], 1);
}
