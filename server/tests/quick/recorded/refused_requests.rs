//! Requests that are refused: each with a problem document that says why, and every fault at its place.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::Method;
use serde_json::{Value, json};

use super::compare;
use super::session::Session;
use crate::app::{App, Home, study, study_of_layouts};
use crate::estimators::{quick, text};

const FILM: &str = r#"{"theta_deg": 0, "phi_deg": 0, "angle_deg": 90}"#;

#[tokio::test(flavor = "multi_thread")]
async fn faulty_documents_are_refused_as_recorded_and_nothing_is_stored() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut session = Session::new(&app);
    let mut post =
        async |path: &str, document: &Value| session.ask(Method::POST, path, Some(document)).await;

    let mut wrong = study();
    wrong["inputs"][0]["distribution"] = json!({"kind": "uniform", "min": 2.0, "max": 1.0});
    wrong["inputs"][2]["vary"] = json!("ground.depths_mm[9]");
    wrong["method"] = json!({"kind": "mdrm", "nodes": -3});
    wrong["colour"] = json!("black");
    for path in ["/v1/studies", "/v1/studies:estimate", "/v1/studies:preview"] {
        post(path, &wrong).await;
    }
    let mut of_file = study();
    of_file["scene"] = json!("/etc/passwd");
    post("/v1/studies", &of_file).await;
    let mut large = study();
    large["method"] = json!({"kind": "saltelli", "samples": 4096});
    post("/v1/studies:preview", &large).await;

    let scene = json!({"preset": "foot-tire", "contact": {"friction": 0.5, "fiction": 1}});
    let gauges = json!([{"theta_deg": 0, "phi_deg": 190}, {"phi_deg": 0, "angle": 90}]);
    let derivatives = json!(["pressure.internal_mpa", "pressure.internal_mpa", 7]);
    let question = json!({"scene": scene, "gauges": gauges, "derivatives": derivatives, "at": []});
    post("/v1/scenes:solve", &question).await;
    post("/v1/scenes:solve", &json!({"scene": "/etc/passwd"})).await;

    let grid = json!({"geometry.wall_mm": [2.5, -1], "geometry.wal_mm": [1]});
    let mut sweep = json!({"study": study(), "grid": grid});
    post("/v1/sweeps", &sweep).await;
    post("/v1/sweeps:estimate", &sweep).await;
    sweep["study"]["method"] = json!({"nodes": 0});
    post("/v1/sweeps", &sweep).await;

    let mut rig = quick();
    rig["recipe"]["models"] = json!({"kinds": ["lasso"]});
    rig["recordings"][1]["file"] = json!(3);
    rig["rows"] = json!(1);
    post("/v1/estimators", &rig).await;
    for recording in [
        "time_s,s1,s2,fz_n\n0,1,2,3\n1,x,2,3\n2,1,2,\"\n",
        "time_s,s1\n0,1\n",
        "",
    ] {
        let mut rig = quick();
        rig["recordings"][1]["text"] = json!(recording);
        post("/v1/estimators", &rig).await;
    }
    let mut endless = quick();
    endless["recipe"]["preprocess"] = json!({"start_value": "keep", "rate_hz": 50, "pause_s": 1e9});
    endless["recordings"][0]["text"] = json!(text(1, 150) + "1e8,1,1,1\n");
    post("/v1/estimators", &endless).await;
    for list in ["studies", "sweeps", "estimators"] {
        assert_eq!(app.json(&format!("/v1/{list}")).await[list], json!([]));
    }
    compare("faulty-documents", &session.record());
}

#[tokio::test(flavor = "multi_thread")]
async fn bodies_that_can_not_be_read_are_refused_as_recorded() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut session = Session::new(&app);
    for (what, kind, body) in [
        ("no document", "text/plain", study().to_string()),
        ("broken", "application/json", "{\"name\":".to_owned()),
        ("broken", "application/toml", "name = ".to_owned()),
        ("deep", "application/json", "[".repeat(900_000)),
        ("large", "application/json", " ".repeat((1 << 20) + 1)),
        ("no object", "application/json", "[1, 2]".to_owned()),
        (
            "infinite",
            "application/json",
            "{\"name\": 1e999}".to_owned(),
        ),
    ] {
        let request = app.client.post(app.url("/v1/studies"));
        let request = request.header("content-type", kind).body(body);
        session
            .send(&format!("POST /v1/studies {what}, {kind}"), request)
            .await;
    }
    for (kind, body) in [
        ("application/json", b"{\"recordings\": [".to_vec()),
        ("application/toml", b"recordings = []".to_vec()),
        ("application/json", vec![b' '; (64 << 20) + 1]),
        (
            "application/json",
            format!("[{}0]", "0,".repeat(1 << 20)).into(),
        ),
    ] {
        let request = app.client.post(app.url("/v1/estimators"));
        let request = request.header("content-type", kind).body(body);
        session
            .send(&format!("POST /v1/estimators {kind}"), request)
            .await;
    }
    let request = app.client.post(app.url("/v1/studies")).json(&study());
    for (name, value) in [
        ("content-encoding", "gzip"),
        ("origin", "http://evil.example"),
        ("host", "evil.example"),
    ] {
        let request = request.try_clone().expect("a body").header(name, value);
        session
            .send(&format!("POST /v1/studies {name}: {value}"), request)
            .await;
    }
    let request = app
        .client
        .delete(app.url("/v1/studies/x"))
        .header("origin", "null");
    session
        .send("DELETE /v1/studies/x origin: null", request)
        .await;
    assert_eq!(app.json("/v1/studies").await["studies"], json!([]));

    let own = request_of_own_page(&app).await;
    assert_eq!(own, reqwest::StatusCode::ACCEPTED);
    compare("unread-bodies", &session.record());
}

async fn request_of_own_page(app: &App) -> reqwest::StatusCode {
    let request = app.client.post(app.url("/v1/studies")).json(&study());
    let answer = request.header("origin", app.url("")).send().await;
    answer.expect("an answer").status()
}

#[tokio::test(flavor = "multi_thread")]
async fn questions_without_an_answer_are_refused_as_recorded() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let plain = app.submit(&study()).await;
    let mut whole = study_of_layouts();
    whole["candidates"]["grid"] = json!({"circumferential": 5, "meridional": 3});
    let whole = app.submit(&whole).await;
    for id in [&plain, &whole] {
        app.wait_for(id, "done").await;
    }
    let mut session = Session::new(&app);
    for kind in ["studies", "sweeps", "estimators"] {
        for query in [
            "limit=0",
            "limit=201",
            "limit=x",
            "limit=1&limit=2",
            "state=lost",
            "archived=yes",
        ] {
            session
                .ask(Method::GET, &format!("/v1/{kind}?{query}"), None)
                .await;
        }
        let long = format!("/v1/{kind}?search={}", "x".repeat(201));
        let request = app.client.get(app.url(&long));
        session
            .send(&format!("GET /v1/{kind}?search=x.."), request)
            .await;
        session
            .ask(Method::DELETE, &format!("/v1/{kind}/none"), None)
            .await;
    }
    for path in [
        "/v1/nothing",
        "/v1/studies/%FF",
        "/v1/sweeps/none",
        "/v1/estimators/none",
        "/v1/estimators/none/report",
        "/v1/estimators/none/model",
        "/v1/estimators/none/left-out",
        "/v1/studies/none/export",
        "/v1/schemas/tire",
        "/v1/comparison",
        "/v1/comparison?studies=none",
        "/v1/comparison/export?format=csv",
        "/v1/comparison/export?studies=none",
        "/v1/comparison/export?studies=none&format=vtu&table=points",
    ] {
        session.ask(Method::GET, path, None).await;
    }
    for part in [
        "result?map=no",
        "map",
        "signals",
        "trade",
        "layouts/fields",
        "export?format=xls&table=all",
        "export?format=vtu",
    ] {
        session
            .ask(Method::GET, &format!("/v1/studies/{plain}/{part}"), None)
            .await;
    }
    for query in ["direction=z", "index=second", "input=P9"] {
        let path = format!("/v1/studies/{whole}/map?{query}");
        session.ask(Method::GET, &path, None).await;
    }
    for (method, path) in [
        (Method::PUT, "/v1/studies"),
        (Method::DELETE, "/v1/presets"),
        (Method::POST, "/healthz"),
        (Method::GET, "/v1/estimators/none:apply"),
        (Method::PUT, "/v1/estimators/none:apply"),
        (Method::GET, "/v1/estimators/none:zero"),
        (Method::POST, "/v1/estimators/none"),
        (Method::OPTIONS, "/v1/estimators/none"),
    ] {
        session.ask(method, path, None).await;
    }
    for kind in ["studies", "sweeps"] {
        let change = json!({"archived": true});
        session
            .ask(Method::PATCH, &format!("/v1/{kind}/none"), Some(&change))
            .await;
    }
    let run = json!({"file": "friday.csv", "text": "time_s,s1,s2\n0,0.5,0.2\n"});
    let path = "/v1/estimators/none:apply";
    session.ask(Method::POST, path, Some(&run)).await;
    let path = "/v1/estimators/none:zero";
    session.ask(Method::POST, path, Some(&run)).await;
    let sweep = json!({"study": study(), "grid": {"geometry.wall_mm": [2.5]}});
    let sweep = app.client.post(app.url("/v1/sweeps")).json(&sweep).send();
    let sweep: Value = sweep.await.expect("an answer").json().await.expect("JSON");
    let id = sweep["id"].as_str().expect("an id");
    let further = json!({"grid": {"geometry.wall_mm": [0]}});
    let path = format!("/v1/sweeps/{id}/designs");
    session.ask(Method::POST, &path, Some(&further)).await;
    let path = format!("/v1/comparison?sweep={id}&baseline=other");
    session.ask(Method::GET, &path, None).await;
    let change = json!({"name": "", "archived": 1, "priority": 3});
    session
        .ask(
            Method::PATCH,
            &format!("/v1/studies/{plain}"),
            Some(&change),
        )
        .await;
    let film: Value = serde_json::from_str(FILM).expect("JSON");
    for (id, layouts) in [
        (
            &whole,
            json!({"layouts": [{"films": [{"phi_deg": 3.0, "angle_deg": 90.0}]}, {"films": []}, {"film": 2, "films": [{"theta_deg": "far"}]}]}),
        ),
        (
            &whole,
            json!({"layouts": vec![json!({"films": [film]}); 5], "simulated": true}),
        ),
        (
            &whole,
            json!({"layouts": vec![json!({"films": [film]}); 51]}),
        ),
        (&plain, json!({"layouts": [{"films": [film]}]})),
    ] {
        let path = format!("/v1/studies/{id}/layouts:score");
        session.ask(Method::POST, &path, Some(&layouts)).await;
    }
    compare("refused-questions", &session.record());
}
