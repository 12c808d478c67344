//! Equilibrium of a scene at once: what it answers, and that nothing stays of it.

use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::Solver;
use reqwest::{RequestBuilder, StatusCode};
use serde_json::{Value, json};
use service::solving::isolated::child;
use service::solving::isolated::parent::Isolated;
use service::solving::solver_choice::{SolverName, solver};

use super::Counting;
use crate::app::{App, Home, PATIENCE, endless, problem, program, study};

/// The program's own finite elements, in a process of their own.
fn embedded() -> Arc<dyn Solver> {
    let solver = solver(SolverName::Embedded, PATIENCE).expect("a solver");
    Arc::new(Isolated::new(solver, || program(child::ARGUMENT)))
}

fn request(app: &App, document: &Value) -> RequestBuilder {
    let address = app.url("/v1/scenes:solve");
    app.client.post(address).json(document)
}

async fn solve(app: &App, document: &Value) -> Value {
    let response = request(app, document).send().await.expect("an answer");
    let status = response.status();
    let answer: Value = response.json().await.expect("JSON");
    assert_eq!(status, StatusCode::OK, "{answer}");
    answer
}

async fn refused(app: &App, document: &Value, status: StatusCode) -> Value {
    problem(
        request(app, document).send().await.expect("an answer"),
        status,
    )
    .await
}

fn draft(changes: &Value) -> Value {
    let mut scene = json!({"preset": "foot-tire", "model": {"level": "draft"}});
    for (name, value) in changes.as_object().expect("tables") {
        scene[name] = value.clone();
    }
    json!({"scene": scene})
}

#[tokio::test(flavor = "multi_thread")]
async fn a_scene_is_answered_with_its_gauges_and_derivatives() {
    let home = Home::new();
    let app = home.start_on(embedded()).await;
    let mut document = draft(&json!({}));
    document["gauges"] = json!([{"theta_deg": 0, "phi_deg": 0, "angle_deg": 90}]);
    document["derivatives"] = json!(["ground.depths_mm[2]", "pressure.internal_mpa"]);
    let answer = solve(&app, &document).await;
    assert_eq!(answer["status"], "converged");
    assert!(answer.get("map").is_none() && answer.get("rings").is_none());
    assert!(answer["wall_s"].is_number() && answer["unlikely"].is_array());
    // P3 is at the crown of the contact's centre: a gauge across the wheel reads its meridional strain.
    let strain = answer["gauges"][0]["strain"].as_f64().expect("a strain");
    let location = &answer["locations"][2];
    let meridional = location["strain_y"].as_f64().expect("a strain");
    assert!(
        (strain / meridional - 1.0).abs() < 1e-9,
        "{strain} {meridional}"
    );

    // Derivatives against a central difference of solves, whose own error is the square of the step: 1e-6 here.
    let by_pressure = &answer["derivatives"][1];
    assert_eq!(by_pressure["by"], "pressure.internal_mpa");
    let derivative = by_pressure["reaction_n"].as_f64().expect("a number");
    let mut reactions = [0.0; 2];
    let (pressure, step) = (0.2, 1e-4);
    for (reaction, side) in reactions.iter_mut().zip([-step, step]) {
        let beside = draft(&json!({"pressure": {"internal_mpa": pressure + side}}));
        let beside = solve(&app, &beside).await;
        *reaction = beside["reaction_n"].as_f64().expect("a number");
    }
    let difference = (reactions[1] - reactions[0]) / (2.0 * step);
    assert!(
        (derivative / difference - 1.0).abs() < 1e-4,
        "{derivative} {difference}"
    );
    assert!(derivative > 0.0, "a harder tire presses back more");
}

#[tokio::test(flavor = "multi_thread")]
async fn every_fault_of_a_question_is_named_and_files_are_not_read() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut document = draft(&json!({"contact": {"friction": 0.5}, "geometry": {"wal_mm": 3}}));
    document["derivatives"] = json!(["no.such"]);
    document["gauges"] = json!([{"theta_deg": 400}]);
    let told = refused(&app, &document, StatusCode::UNPROCESSABLE_ENTITY).await;
    let pointers = |told: &Value| -> Vec<String> {
        let errors = told["errors"].as_array().expect("faults");
        let pointers = errors
            .iter()
            .map(|error| error["pointer"].as_str().expect("a pointer"));
        pointers.map(str::to_owned).collect()
    };
    assert_eq!(
        pointers(&told),
        [
            "/scene/geometry/wal_mm",
            "/gauges/0/theta_deg",
            "/gauges/0/phi_deg"
        ]
    );
    let file = json!({"scene": "/etc/passwd"});
    let told = refused(&app, &file, StatusCode::UNPROCESSABLE_ENTITY).await;
    assert_eq!(pointers(&told), ["/scene"]);

    // What only the solver refuses has its place in the question, too.
    let home = Home::new();
    let app = home.start_on(embedded()).await;
    let mut document = draft(&json!({"contact": {"friction": 0.5}}));
    document["derivatives"] = json!(["pressure.internal_mpa"]);
    let told = refused(&app, &document, StatusCode::UNPROCESSABLE_ENTITY).await;
    assert_eq!(pointers(&told), ["/scene/contact/friction"]);
}

#[tokio::test(flavor = "multi_thread")]
async fn loads_without_equilibrium_say_how_far_they_got() {
    let home = Home::new();
    let solver = ClosedFormSolver::new().with_depth_limit(0.5);
    let app = home.start(solver).await;
    let told = refused(&app, &draft(&json!({})), StatusCode::UNPROCESSABLE_ENTITY).await;
    let detail = told["detail"].as_str().expect("a sentence");
    assert!(detail.contains("the last equilibrium has"), "{detail}");
}

#[tokio::test(flavor = "multi_thread")]
async fn scenes_come_one_after_the_other_while_a_study_runs_and_nothing_is_stored() {
    let home = Home::new();
    let app = home.start_on(Counting::slow()).await;
    let id = app.submit(&study()).await;
    app.wait(&id, |study| study["points_done"].as_i64() >= Some(2))
        .await;
    let document = draft(&json!({}));
    let (first, second) = tokio::join!(solve(&app, &document), solve(&app, &document));
    assert_eq!(first["reaction_n"], second["reaction_n"]);
    let done = app.wait_for(&id, "done").await;
    assert_eq!(done["points_done"], 26);
    let mut sql = home.sql().await;
    let stored: i64 = sqlx::query_scalar("select count(*) from evaluations")
        .fetch_one(&mut sql)
        .await
        .expect("counts");
    assert_eq!(stored, 26);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_scene_beyond_its_limit_ends_and_so_does_one_whose_client_went_away() {
    let home = Home::new();
    let limit = Duration::from_millis(300);
    let app = home.start_with_limit(limit, Arc::new(endless())).await;
    let document = draft(&json!({}));
    for _ in 0..2 {
        // The second would wait for the first for ever, if that hadn't ended.
        let told = refused(&app, &document, StatusCode::SERVICE_UNAVAILABLE).await;
        let detail = told["detail"].as_str().expect("a sentence");
        assert!(detail.contains("longer than"), "{detail}");
    }

    let home = Home::new();
    let counting = Counting::slow();
    let app = home.start_on(counting.clone()).await;
    let impatient = request(&app, &document).timeout(Duration::from_millis(50));
    assert!(impatient.send().await.expect_err("too slow").is_timeout());
    solve(&app, &document).await;
    assert!(counting.begun.load(Ordering::Relaxed) <= 2);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_scene_that_would_take_more_memory_than_there_is_is_refused() {
    let home = Home::new();
    let limits = server::running::Limits {
        memory_bytes: 100 << 20,
        ..server::running::Limits::default()
    };
    let app = home.start_with(ClosedFormSolver::new(), limits).await;
    solve(&app, &draft(&json!({}))).await;
    let large = draft(&json!({"model": {"level": "reference"}}));
    let told = refused(&app, &large, StatusCode::UNPROCESSABLE_ENTITY).await;
    let detail = told["detail"].as_str().expect("a sentence");
    assert!(
        detail.contains("GB of memory, and 0.10 GB are there"),
        "{detail}"
    );
}
