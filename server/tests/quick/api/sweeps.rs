//! `/v1/sweeps` and `/v1/comparison`.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::{Response, StatusCode};
use serde_json::{Value, json};

use crate::app::{App, Home, PATIENCE, problem, slow, study};

async fn post(app: &App, path: &str, document: &Value) -> Response {
    let request = app.client.post(app.url(path)).json(document);
    request.send().await.expect("an answer")
}

/// Submits a sweep that must be accepted.
async fn submit(app: &App, rest: Value) -> Value {
    let mut document = json!({"study": study()});
    document
        .as_object_mut()
        .expect("a table")
        .extend(rest.as_object().expect("a table").clone());
    accepted(post(app, "/v1/sweeps", &document).await).await
}

async fn accepted(response: Response) -> Value {
    let (status, location) = (
        response.status(),
        response.headers().get("location").cloned(),
    );
    let body: Value = response.json().await.expect("JSON");
    assert_eq!(status, StatusCode::ACCEPTED, "{body}");
    let id = body["id"].as_str().expect("an id");
    let location = location.expect("a location");
    assert_eq!(location, format!("/v1/sweeps/{id}").as_str());
    body
}

async fn wait_for(app: &App, sweep: &Value, state: &str) -> Value {
    let path = format!("/v1/sweeps/{}", sweep["id"].as_str().expect("an id"));
    let begun = std::time::Instant::now();
    loop {
        let sweep = app.json(&path).await;
        if sweep["state"] == state {
            return sweep;
        }
        assert!(begun.elapsed() < PATIENCE, "still waiting: {sweep}");
        tokio::time::sleep(std::time::Duration::from_millis(5)).await;
    }
}

fn address(sweep: &Value, rest: &str) -> String {
    format!("/v1/sweeps/{}{rest}", sweep["id"].as_str().expect("an id"))
}

#[tokio::test(flavor = "multi_thread")]
async fn a_sweep_is_run_extended_and_compared() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let sweep = submit(
        &app,
        json!({"name": "walls", "grid": {"geometry.wall_mm": [2.5, 3]}}),
    )
    .await;
    assert_eq!(sweep["name"], "walls");
    assert_eq!(sweep["designs"][0]["name"], "wall_mm = 2.5");
    let done = wait_for(&app, &sweep, "done").await;
    assert_eq!(done["counts"]["done"], 2);
    assert_eq!(
        (&done["points_done"], &done["points_total"]),
        (&json!(52), &json!(52))
    );
    assert!(done["finished"].is_string());

    let design = done["designs"][0]["study"]["id"].as_str().expect("an id");
    let detail = app.json(&format!("/v1/studies/{design}")).await;
    assert_eq!(detail["sweep"], sweep["id"], "a design names its sweep");
    let alone = app.submit(&study()).await;
    let detail = app.json(&format!("/v1/studies/{alone}")).await;
    assert_eq!(detail.get("sweep"), Some(&Value::Null));

    let listed = async |sweep: &str| {
        let list = app.json(&format!("/v1/studies?sweep={sweep}")).await;
        let studies = list["studies"].as_array().expect("a list").clone();
        studies
            .iter()
            .map(|study| study["id"].clone())
            .collect::<Vec<_>>()
    };
    let id = |place: usize| sweep["designs"][place]["study"]["id"].clone();
    assert_eq!(
        listed(sweep["id"].as_str().expect("an id")).await,
        [id(1), id(0)]
    );
    assert_eq!(listed("none").await, [json!(alone)]);
    assert_eq!(listed("unknown").await, [json!(null); 0]);

    // The second design is there already, the third is new.
    let further = json!({"grid": {"geometry.wall_mm": [3, 3.5]}});
    let extended = accepted(post(&app, &address(&sweep, "/designs"), &further).await).await;
    assert_eq!(extended["designs"].as_array().map(Vec::len), Some(3));
    let done = wait_for(&app, &sweep, "done").await;
    assert_eq!(done["designs"][2]["set"], json!({"geometry.wall_mm": 3.5}));
    for design in [0, 1] {
        assert_eq!(
            done["designs"][design]["study"]["id"],
            extended["designs"][design]["study"]["id"]
        );
    }

    let compared = app
        .json(&format!(
            "/v1/comparison?sweep={}",
            sweep["id"].as_str().expect("an id")
        ))
        .await;
    let id = |design: usize| {
        done["designs"][design]["study"]["id"]
            .as_str()
            .expect("an id")
    };
    assert_eq!(
        (
            compared["studies"].as_array().map(Vec::len),
            &compared["baseline"]
        ),
        (Some(3), &json!(id(0)))
    );
    assert_eq!(compared["rows"].as_array().map(Vec::len), Some(15));
    let result = app.json(&format!("/v1/studies/{}/result", id(2))).await;
    let base = app.json(&format!("/v1/studies/{}/result", id(0))).await;
    for (place, location) in result["locations"]
        .as_array()
        .expect("a list")
        .iter()
        .enumerate()
    {
        let row = &compared["rows"][10 + place];
        assert_eq!(
            (&row["location"], &row["rank"]),
            (&location["name"], &location["rank"])
        );
        assert_eq!(row["x"]["gsi_percent"], location["gsi_x_percent"]);
        let same = |other: &&Value| other["name"] == location["name"];
        let other = base["locations"]
            .as_array()
            .and_then(|list| list.iter().find(same))
            .expect("the same location");
        let difference = location["gsi_x_percent"]
            .as_f64()
            .zip(other["gsi_x_percent"].as_f64())
            .map(|(a, b)| a - b);
        assert_eq!(row["x"]["difference_percent"].as_f64(), difference);
    }
    // By themselves, in another order, from another baseline.
    let path = format!(
        "/v1/comparison?studies={},{}&baseline={}",
        id(2),
        id(0),
        id(0)
    );
    let pair = app.json(&path).await;
    assert_eq!(pair["rows"][0]["x"], compared["rows"][10]["x"]);
    let list = app.json("/v1/sweeps?limit=1").await;
    assert_eq!(
        (&list["sweeps"][0]["id"], &list["next_cursor"]),
        (&sweep["id"], &Value::Null)
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_sweep_is_cancelled_and_resumed_as_one_and_keeps_what_it_has() {
    let home = Home::new();
    let app = home.start(slow()).await;
    let sweep = submit(&app, json!({"grid": {"geometry.wall_mm": [2.5, 3]}})).await;
    let first = sweep["designs"][0]["study"]["id"].as_str().expect("an id");
    app.wait(first, |study| study["points_done"].as_i64() > Some(3))
        .await;
    let cancelled = app.delete(&address(&sweep, "")).await;
    assert_eq!(cancelled.status(), StatusCode::ACCEPTED);
    let cancelled = wait_for(&app, &sweep, "cancelled").await;
    assert_eq!(cancelled["counts"]["cancelled"], 2);

    let resumed = accepted(post(&app, &address(&sweep, "/resume"), &json!({})).await).await;
    assert_ne!(
        resumed["designs"][0]["study"]["id"],
        sweep["designs"][0]["study"]["id"]
    );
    let done = wait_for(&app, &sweep, "done").await;
    let again = done["designs"][0]["study"]["id"].as_str().expect("an id");
    let result = app.json(&format!("/v1/studies/{again}/result")).await;
    assert!(
        result["cost"]["reused"].as_i64() > Some(3),
        "{}",
        result["cost"]
    );
    // Nothing is left to resume.
    let same = accepted(post(&app, &address(&sweep, "/resume"), &json!({})).await).await;
    assert_eq!(same["designs"], done["designs"]);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_design_without_an_equilibrium_is_told_and_the_others_go_on() {
    let home = Home::new();
    let app = home
        .start(ClosedFormSolver::new().with_depth_limit(1.35))
        .await;
    let depths = json!({"designs": [
        {"name": "as it is", "set": {}},
        {"name": "hopeless", "set": {"inputs[0].distribution": {"kind": "uniform", "min": 1.3, "max": 1.5}}},
    ]});
    let sweep = submit(&app, depths).await;
    let done = wait_for(&app, &sweep, "done").await;
    assert_eq!(
        (&done["counts"]["done"], &done["counts"]["failed"]),
        (&json!(1), &json!(1)),
        "{done}"
    );
    let compared = app
        .json(&format!(
            "/v1/comparison?sweep={}",
            sweep["id"].as_str().expect("an id")
        ))
        .await;
    let reason = compared["studies"][1]["reason"].as_str().expect("a reason");
    assert!(reason.contains("the first is point 0"), "{reason}");
    assert_eq!(compared["rows"].as_array().map(Vec::len), Some(5));
}

#[tokio::test(flavor = "multi_thread")]
async fn the_same_sweep_under_the_same_key_is_taken_in_once() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let send = |wall: f64| {
        let document = json!({"study": study(), "grid": {"geometry.wall_mm": [wall]}});
        let request = app
            .client
            .post(app.url("/v1/sweeps"))
            .header("idempotency-key", "walls");
        async move { request.json(&document).send().await.expect("an answer") }
    };
    let first = accepted(send(2.5).await).await;
    let again = accepted(send(2.5).await).await;
    assert_eq!(first["id"], again["id"]);
    problem(send(3.0).await, StatusCode::UNPROCESSABLE_ENTITY).await;
    assert_eq!(
        app.json("/v1/sweeps").await["sweeps"]
            .as_array()
            .map(Vec::len),
        Some(1)
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn an_estimate_counts_what_designs_share_once() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    // Two designs that differ in what is asked of the same points.
    let document =
        json!({"study": study(), "grid": {"layouts.spacings_deg": [[30, 60], [45, 90]]}});
    let response = post(&app, "/v1/sweeps:estimate", &document).await;
    assert_eq!(response.status(), StatusCode::OK);
    let estimate: Value = response.json().await.expect("JSON");
    let left =
        |design: usize| &estimate["designs"][design]["estimate"]["solves"]["left"]["expected"];
    assert_eq!((left(0), left(1)), (&json!(31), &json!(0)), "{estimate}");
    assert_eq!(estimate["left"]["expected"], 31);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_part_of_the_designs_and_the_best_of_them_are_told_where_that_is_asked() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let grid = json!({"geometry.wall_mm": [2.5, 3, 3.5]});
    let sweep = submit(&app, json!({"grid": grid})).await;
    let done = wait_for(&app, &sweep, "done").await;
    assert!(done["worked_s"].as_f64().expect("a number") > 0.0);
    for (part, ordinals) in [
        ("?from=1", &[1, 2][..]),
        ("?limit=2", &[0, 1]),
        ("?from=1&limit=1", &[1]),
        ("?from=3", &[]),
    ] {
        let told = app.json(&address(&sweep, part)).await;
        let designs = told["designs"].as_array().expect("a list");
        let places = designs
            .iter()
            .filter_map(|design| design["ordinal"].as_i64());
        assert_eq!(places.collect::<Vec<i64>>(), ordinals, "{part}");
        assert_eq!(told["counts"], done["counts"]);
    }
    let comparison = format!(
        "/v1/comparison?sweep={}",
        sweep["id"].as_str().expect("an id")
    );
    let all = app.json(&comparison).await;
    // Without layouts none is better: the first are told, of which one is the baseline.
    let told = app.json(&format!("{comparison}&best=2")).await;
    let of = |list: &Value, places: std::ops::Range<usize>| {
        list.as_array().map(|all| all[places].to_vec())
    };
    assert_eq!(of(&told["studies"], 0..2), of(&all["studies"], 0..2));
    assert_eq!(of(&told["rows"], 0..10), of(&all["rows"], 0..10));
    let counts = ["studies", "rows"].map(|list| told[list].as_array().map(Vec::len));
    assert_eq!(counts, [Some(2), Some(10)]);
    let note = told["notes"]
        .as_array()
        .and_then(|notes| notes.last()?.as_str());
    assert!(note.is_some_and(|note| note.starts_with("the best 2 of 3 studies are told")));
    for wrong in [
        address(&sweep, "?limit=0"),
        address(&sweep, "?limit=1001"),
        address(&sweep, "?from=-1"),
        address(&sweep, "?from=100001"),
        format!("{comparison}&best=0"),
        format!("{comparison}&best=all"),
    ] {
        problem(app.get(&wrong).await, StatusCode::BAD_REQUEST).await;
    }
}
