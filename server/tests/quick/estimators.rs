//! `/v1/estimators` from outside.

use std::fmt::Write as _;
use std::time::{Duration, Instant};

use estimation::recipe::Recipe;
use fem_client::closed_form::ClosedFormSolver;
use reqwest::{Response, StatusCode};
use serde_json::{Value, json};
use service::forces::applying::{Zero, apply};
use service::forces::fitting::{Work, fit};
use service::forces::model_file::{model_text, read_model};
use service::forces::recorded_texts::NamedText;

use crate::app::{App, Home, PATIENCE, problem};

/// Two signals that follow a force, each with a little of its own.
pub fn text(seed: u32, rows: u32) -> String {
    let mut text = "time_s,s1,s2,fz_n\n".to_owned();
    for row in 0..rows {
        let t = f64::from(row) * 0.01;
        let force = 3.0 - 3.0 * (t * 9.0).cos();
        let own = f64::from((row * 7919 + seed * 104_729) % 101) / 1000.0;
        let (first, second) = (2.0 * force + own, 1.0 - force + 2.0 * own);
        writeln!(text, "{t},{first},{second},{force}").expect("writes");
    }
    text
}

fn recordings() -> Value {
    json!([{"file": "monday.csv", "text": text(1, 150)}, {"file": "tuesday.csv", "text": text(2, 150)}])
}

/// Returns a document that is learnt within a tenth of a second.
pub fn quick() -> Value {
    let recipe = json!({"preprocess": {"start_value": "keep"}, "features": {"sets": ["raw", "all"]}, "models": {"kinds": ["ridge"]}});
    json!({"name": "rig", "recipe": recipe, "recordings": recordings()})
}

/// Returns a document that takes a minute.
fn lasting() -> Value {
    let networks = json!({"iterations": 2000, "networks": 8});
    json!({"recipe": {"models": {"kinds": ["ann", "gpr"], "ann": networks}}, "recordings": [
        {"file": "a.csv", "text": text(1, 600)}, {"file": "b.csv", "text": text(2, 600)}, {"file": "c.csv", "text": text(3, 600)},
    ]})
}

async fn post(app: &App, path: &str, document: &Value) -> Response {
    let request = app.client.post(app.url(path)).json(document);
    request.send().await.expect("an answer")
}

/// Submits what must be accepted, and returns its identifier.
async fn submit(app: &App, document: &Value) -> String {
    let response = post(app, "/v1/estimators", document).await;
    let location = response.headers().get("location").cloned();
    let (status, body) = (
        response.status(),
        response.json::<Value>().await.expect("JSON"),
    );
    assert_eq!(status, StatusCode::ACCEPTED, "{body}");
    let id = body["id"].as_str().expect("an id").to_owned();
    let location = location.expect("a location");
    assert_eq!(location, format!("/v1/estimators/{id}").as_str());
    id
}

async fn wait(app: &App, id: &str, until: impl Fn(&Value) -> bool) -> Value {
    let begun = Instant::now();
    loop {
        let estimator = app.json(&format!("/v1/estimators/{id}")).await;
        if until(&estimator) {
            return estimator;
        }
        assert!(begun.elapsed() < PATIENCE, "still waiting: {estimator}");
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
}

pub async fn wait_for(app: &App, id: &str, state: &str) -> Value {
    wait(app, id, |estimator| estimator["state"] == state).await
}

#[tokio::test(flavor = "multi_thread")]
async fn what_the_service_learns_and_estimates_is_what_the_command_line_does() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let document = quick();
    let id = submit(&app, &document).await;
    let done = wait_for(&app, &id, "done").await;
    assert_eq!(
        (&done["name"], &done["error"]),
        (&json!("rig"), &json!(null))
    );
    assert_eq!(done["forces"], json!(["fz_n"]));
    assert_eq!(done["recordings"][1]["file"], "tuesday.csv");
    assert_eq!(done["recordings"][1]["rows"], 150);
    assert_eq!(done["recipe"], document["recipe"]);
    assert!(done["progress"].is_null() && done["started"].is_string());

    let files: Vec<NamedText> = ["monday.csv", "tuesday.csv"]
        .into_iter()
        .zip(1..)
        .map(|(name, seed)| NamedText {
            name: name.to_owned(),
            text: text(seed, 150),
        })
        .collect();
    let recipe = Recipe::from_value(&document["recipe"]).expect("a recipe");
    let work = Work {
        threads: 1,
        told: &|_| {},
    };
    let here = fit(&recipe, &files, work).expect("learns");
    let path = format!("/v1/estimators/{id}");
    let answer = app.get(&format!("{path}/model")).await;
    assert_eq!(answer.headers()["content-type"], "application/json");
    let tag = answer.headers()["etag"].clone();
    let model = answer.text().await.expect("text");
    assert_eq!(model, model_text(&here.estimator).expect("finite"));
    let again = app.client.get(app.url(&format!("{path}/model")));
    let again = again.header("if-none-match", tag).send().await;
    assert_eq!(again.expect("an answer").status(), StatusCode::NOT_MODIFIED);

    let mut report = app.json(&format!("{path}/report")).await;
    let mut expected = serde_json::to_value(&here.report).expect("JSON");
    for report in [&mut report, &mut expected] {
        report["cost"]["wall_s"] = json!(0);
    }
    assert_eq!(report, expected);
    let left_out = app.json(&format!("{path}/left-out")).await;
    assert_eq!(left_out, json!({"forces": here.left_out}));

    let unmeasured = "time_s,s1,s2\n0,0.5,0.2\n0.01,1.5,0.1\n0.02,60,0.1\n";
    let run = json!({"file": "friday.csv", "text": unmeasured});
    let answer = post(&app, &format!("{path}:apply"), &run).await;
    assert_eq!(answer.status(), StatusCode::OK);
    assert_eq!(answer.headers()["content-type"], "text/csv; charset=utf-8");
    let estimator = read_model(&model).expect("reads");
    let estimates = apply(&estimator, "friday.csv", unmeasured, &Zero::AsLearnt)
        .expect("applies")
        .csv;
    assert_eq!(answer.text().await.expect("text"), estimates);
    assert_eq!(estimates.lines().count(), 4);

    // Given a zero, recordings are estimated by it however they begin, until it is forgotten.
    assert_eq!(done["zero"], json!(null));
    let rest = json!({"file": "rest.csv", "text": "time_s,s1,s2\n0,0.2,0.1\n0.01,0.4,0.3\n0.02,0.3,0.2\n"});
    let answer = post(&app, &format!("{path}:zero"), &rest).await;
    assert_eq!(answer.status(), StatusCode::OK);
    let zero: Value = answer.json().await.expect("JSON");
    assert_eq!(
        (&zero["file"], &zero["zero"]),
        (&json!("rest.csv"), &json!([0.3, 0.2]))
    );
    assert_eq!(app.json(&path).await["zero"], zero);
    let known = Zero::Known(vec![0.3, 0.2]);
    let by_zero = apply(&estimator, "friday.csv", unmeasured, &known).expect("applies");
    let answer = post(&app, &format!("{path}:apply"), &run).await;
    assert_eq!(answer.text().await.expect("text"), by_zero.csv);
    assert_ne!(by_zero.csv, estimates);
    let loaded = json!({"file": "rest.csv", "text": "time_s,s1\n0,1\n"});
    let refused = post(&app, &format!("{path}:zero"), &loaded).await;
    problem(refused, StatusCode::UNPROCESSABLE_ENTITY).await;
    assert_eq!(app.json(&path).await["zero"], zero);
    let forgotten = post(&app, &format!("{path}:zero"), &json!({})).await;
    assert_eq!(forgotten.status(), StatusCode::NO_CONTENT);
    let answer = post(&app, &format!("{path}:apply"), &run).await;
    assert_eq!(answer.text().await.expect("text"), estimates);
}

#[tokio::test(flavor = "multi_thread")]
async fn what_is_not_there_yet_is_told() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let run = json!({"file": "friday.csv", "text": "time_s,s1,s2\n0,0.5,0.2\n"});
    let id = submit(&app, &lasting()).await;
    let path = format!("/v1/estimators/{id}");
    for part in ["report", "model", "left-out"] {
        let early = app.get(&format!("{path}/{part}")).await;
        let told = problem(early, StatusCode::CONFLICT).await;
        let detail = told["detail"].as_str().expect("text");
        assert!(detail.contains("and has no"), "{detail}");
    }
    let early = post(&app, &format!("{path}:apply"), &run).await;
    problem(early, StatusCode::CONFLICT).await;
    let running = wait(&app, &id, |estimator| {
        estimator["progress"]["of"].as_u64() > Some(0)
    })
    .await;
    assert_eq!(running["state"], "running");
    let cancelled = app.delete(&path).await;
    assert_eq!(cancelled.status(), StatusCode::ACCEPTED);
    wait_for(&app, &id, "cancelled").await;
    // What has ended stays as it is.
    assert_eq!(app.delete(&path).await.status(), StatusCode::ACCEPTED);
    // Another one goes on as soon as the models in hand are judged.
    let next = submit(&app, &quick()).await;
    wait_for(&app, &next, "done").await;

    let wrong = json!({"file": "friday.csv", "text": "time_s,s1\n0,1\n"});
    let told = post(&app, &format!("/v1/estimators/{next}:apply"), &wrong).await;
    let told = problem(told, StatusCode::UNPROCESSABLE_ENTITY).await;
    assert_eq!(told["errors"][0]["pointer"], "/text");
    let told = post(&app, &format!("/v1/estimators/{next}:apply"), &json!({})).await;
    let told = problem(told, StatusCode::UNPROCESSABLE_ENTITY).await;
    assert_eq!(told["errors"].as_array().map(Vec::len), Some(2));

    for id in [&id, &next] {
        let path = format!("/v1/estimators/{id}");
        let removed = app.delete(&format!("{path}?purge")).await;
        assert_eq!(removed.status(), StatusCode::NO_CONTENT);
        problem(app.get(&path).await, StatusCode::NOT_FOUND).await;
    }
    let mut sql = home.sql().await;
    let left: i64 = sqlx::query_scalar("select count(*) from estimator_recordings")
        .fetch_one(&mut sql)
        .await
        .expect("counts");
    assert_eq!(left, 0);
}

#[tokio::test(flavor = "multi_thread")]
async fn two_rows_far_apart_do_not_make_estimates_without_end() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut document = quick();
    document["recipe"]["preprocess"] =
        json!({"start_value": "keep", "rate_hz": 50, "pause_s": 1e9});
    let id = submit(&app, &document).await;
    wait_for(&app, &id, "done").await;
    let path = format!("/v1/estimators/{id}:apply");
    let far = json!({"file": "far.csv", "text": "time_s,s1,s2\n0,0.5,0.2\n1e8,1.5,0.1\n"});
    let told = problem(
        post(&app, &path, &far).await,
        StatusCode::UNPROCESSABLE_ENTITY,
    )
    .await;
    let detail = told["errors"][0]["detail"].as_str().expect("text");
    assert!(detail.starts_with("far.csv, line 3"), "{detail}");
    let near = json!({"file": "near.csv", "text": "time_s,s1,s2\n0,0.5,0.2\n0.1,1.5,0.1\n"});
    let answer = post(&app, &path, &near).await;
    assert_eq!(answer.status(), StatusCode::OK);
    assert_eq!(answer.text().await.expect("text").lines().count(), 7);
    document["recordings"][0]["text"] = json!(text(1, 150) + "1e8,1,1,1\n");
    let told = post(&app, "/v1/estimators", &document).await;
    let told = problem(told, StatusCode::UNPROCESSABLE_ENTITY).await;
    assert_eq!(told["errors"][0]["pointer"], "/recipe/preprocess/rate_hz");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_key_stands_for_one_submission_and_lists_are_paged() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let send = async |document: &Value| {
        let request = app.client.post(app.url("/v1/estimators"));
        let request = request.header("idempotency-key", "week 47").json(document);
        request.send().await.expect("an answer")
    };
    let mut document = quick();
    let mut ids = Vec::new();
    for _ in 0..2 {
        let accepted: Value = send(&document).await.json().await.expect("JSON");
        ids.push(accepted["id"].clone());
    }
    assert_eq!(ids[0], ids[1]);
    document["recordings"][0]["text"] = json!(text(3, 150));
    problem(send(&document).await, StatusCode::UNPROCESSABLE_ENTITY).await;

    document["name"] = json!("another rig");
    let second = submit(&app, &document).await;
    // Two are fitted at once, and the later one may end first.
    for id in [ids[0].as_str().expect("an id"), &second] {
        wait_for(&app, id, "done").await;
    }
    let page = app.json("/v1/estimators?limit=1").await;
    assert_eq!(page["estimators"][0]["id"], json!(second));
    let cursor = page["next_cursor"].as_str().expect("a cursor");
    let older = app
        .json(&format!(
            "/v1/estimators?limit=1&cursor={cursor}&state=done"
        ))
        .await;
    assert_eq!(older["estimators"][0]["id"], ids[0]);
    assert_eq!(older["next_cursor"], Value::Null);
    let named = app.json("/v1/estimators?search=ANOTHER").await;
    assert_eq!(named["estimators"].as_array().map(Vec::len), Some(1));
    let wrong = app.get("/v1/estimators?state=over").await;
    problem(wrong, StatusCode::BAD_REQUEST).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_fit_goes_on_after_a_restart_and_damage_ends_it() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let first = submit(&app, &lasting()).await;
    let second = submit(&app, &quick()).await;
    wait_for(&app, &first, "running").await;
    let begun = Instant::now();
    app.service.stop().await.expect("stops");
    assert!(
        begun.elapsed() < Duration::from_secs(5),
        "{:?}",
        begun.elapsed()
    );
    let mut sql = home.sql().await;
    let states: Vec<String> = sqlx::query_scalar("select state from estimators")
        .fetch_all(&mut sql)
        .await
        .expect("reads");
    assert_eq!(states, ["queued", "queued"]);
    // As a kill leaves it.
    let changed =
        sqlx::query("update estimators set state_seal = null, state = 'running' where id = ?")
            .bind(&first)
            .execute(&mut sql)
            .await;
    changed.expect("updates");
    let spoiled = "update estimator_recordings set text = text || '9,9,9,9' where estimator = ? and ordinal = 0";
    let spoiled = sqlx::query(spoiled).bind(&second).execute(&mut sql).await;
    assert_eq!(spoiled.expect("updates").rows_affected(), 1);

    let app = home.start(ClosedFormSolver::new()).await;
    wait_for(&app, &first, "running").await;
    app.delete(&format!("/v1/estimators/{first}")).await;
    let failed = wait_for(&app, &second, "failed").await;
    let error = failed["error"].as_str().expect("a reason");
    assert!(error.contains("damaged"), "{error}");
    let report = app.get(&format!("/v1/estimators/{second}/report")).await;
    let told = problem(report, StatusCode::CONFLICT).await;
    assert!(
        told["detail"]
            .as_str()
            .is_some_and(|detail| detail.contains(error))
    );
    // The line goes on.
    let third = submit(&app, &quick()).await;
    wait_for(&app, &third, "done").await;
}

#[tokio::test(flavor = "multi_thread")]
async fn recordings_are_looked_at_before_anything_is_learnt() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::default()).await;
    let broken = json!({"file": "broken.csv", "text": "time_s,s1,s2,fz_n\n0,1,x,3\n"});
    let mut all = recordings();
    all.as_array_mut().expect("a list").push(broken);
    let document = json!({"recordings": all});
    let answer = post(&app, "/v1/recordings:look", &document).await;
    assert_eq!(answer.status(), StatusCode::OK);
    let found: Value = answer.json().await.expect("JSON");
    assert_eq!(found["recordings"].as_array().map(Vec::len), Some(2));
    assert_eq!(found["faults"][0]["pointer"], "/recordings");
    let detail = found["faults"][0]["detail"].as_str().unwrap_or_default();
    assert!(
        detail.starts_with("broken.csv, line 2, column s2"),
        "{detail}"
    );
    let series = &found["recordings"][0]["series"];
    let columns = series["columns"].as_array().expect("columns");
    let drawn: Vec<&str> = columns
        .iter()
        .filter_map(|each| each["column"].as_str())
        .collect();
    assert_eq!(drawn, ["s1", "s2", "fz_n"]);
    // A bin a row.
    assert_eq!(columns[2]["least"].as_array().map(Vec::len), Some(150));
    assert_eq!(columns[2]["least"], columns[2]["greatest"]);
    for (document, pointer) in [
        (json!({"name": "rig", "recordings": recordings()}), "/name"),
        (json!({"recordings": []}), "/recordings"),
        (
            json!({"recipe": {"columns": {"time": 1}}, "recordings": recordings()}),
            "/recipe/columns/time",
        ),
    ] {
        let refused = post(&app, "/v1/recordings:look", &document).await;
        let refused = problem(refused, StatusCode::UNPROCESSABLE_ENTITY).await;
        assert_eq!(refused["errors"][0]["pointer"], pointer);
    }
}
