//! Every operation of the service, asked for once with success.

use std::sync::Arc;

use reqwest::Method;
use serde_json::{Value, json};

use super::compare;
use super::session::{DEPTH, Session};
use crate::app::{App, ByForce, Home, study_of_layouts};
use crate::estimators::{quick, wait_for as wait_for_estimator};

/// A study with something for every part of an answer.
fn whole_study() -> Value {
    let mut document = study_of_layouts();
    document["candidates"]["grid"] = json!({"circumferential": 5, "meridional": 3});
    document["method"] = json!({"kind": "mdrm", "nodes": 3, "check_points": 3});
    document["signals"] =
        json!({"loads_n": [2, 5], "films": ["bare"], "positions": ["crown"], "directions": ["x"]});
    document
}

#[tokio::test(flavor = "multi_thread")]
async fn every_operation_answers_as_recorded() {
    let home = Home::new();
    let app = home.start_without_turns(Arc::new(ByForce)).await;
    let mut asked = studies(&app).await;
    asked.extend(sweeps(&app).await);
    asked.extend(estimators(&app).await);
    asked.extend(analyses(&app).await);
    asked.extend(service(&app).await);

    let described = app.json("/openapi.json").await;
    for (path, item) in described["paths"].as_object().expect("paths") {
        let (begin, end) = path.split_once('{').unwrap_or((path, ""));
        let end = end.split_once('}').map_or("", |(_, end)| end);
        let is_this = |path: &str| {
            let path = path.split('?').next().unwrap_or(path);
            let middle = path
                .strip_prefix(begin)
                .and_then(|rest| rest.strip_suffix(end));
            middle.is_some_and(|middle| {
                !middle.contains(['/', ':']) && middle.is_empty() != begin.ends_with('/')
            })
        };
        let methods = ["get", "post", "patch", "delete"];
        for method in methods
            .into_iter()
            .filter(|method| item.get(*method).is_some())
        {
            let method = method.to_uppercase();
            let found = asked
                .iter()
                .any(|(other, path)| *other == method && is_this(path));
            assert!(found, "{method} {path} is not recorded");
        }
    }
}

type Asked = std::collections::BTreeSet<(String, String)>;

async fn studies(app: &App) -> Asked {
    let mut session = Session::new(app);
    let document = whole_study();
    session
        .ask(Method::POST, "/v1/studies:estimate", Some(&document))
        .await;
    session.depth = 2;
    session
        .ask(Method::POST, "/v1/studies:preview", Some(&document))
        .await;
    session.depth = DEPTH;
    let scene = json!({"scene": document["scene"]});
    session
        .ask(Method::POST, "/v1/scenes:solve", Some(&scene))
        .await;
    let submitted = session
        .ask(Method::POST, "/v1/studies", Some(&document))
        .await;
    let id = submitted["id"].as_str().expect("an id").to_owned();
    app.wait_for(&id, "done").await;
    session.ask(Method::GET, "/v1/studies?limit=1", None).await;
    let path = format!("/v1/studies/{id}");
    session.depth = 3;
    session
        .ask(Method::GET, &format!("{path}/result"), None)
        .await;
    session.depth = DEPTH;
    for part in [
        "",
        "/locations",
        "/layouts",
        "/evaluations",
        "/signals",
        "/candidates",
        "/rings",
        "/sections?input=P3",
        "/surface",
        "/map?direction=y&input=P3&index=total",
        "/layouts/fields",
        "/trade",
        "/events",
        "/export?format=csv&table=indices",
        "/export?format=csv&table=layouts",
        "/export?format=csv&table=points",
        "/export?format=parquet&table=signals",
        "/export?format=vtu",
    ] {
        session
            .ask(Method::GET, &format!("{path}{part}"), None)
            .await;
    }
    let films = json!([{"theta_deg": 0, "phi_deg": 0, "angle_deg": 90}, {"theta_deg": 40, "phi_deg": 0, "angle_deg": 0}]);
    let layouts = json!({"layouts": [{"name": "mine", "films": films}]});
    session
        .ask(
            Method::POST,
            &format!("{path}/layouts:score"),
            Some(&layouts),
        )
        .await;
    let change = json!({"name": "renamed", "archived": true});
    session.ask(Method::PATCH, &path, Some(&change)).await;
    session
        .ask(Method::DELETE, &format!("{path}?purge"), None)
        .await;
    session.ask(Method::GET, &path, None).await;
    compare("studies", &session.record());
    session.asked
}

async fn sweeps(app: &App) -> Asked {
    let mut session = Session::new(app);
    let mut study = whole_study();
    study.as_object_mut().expect("a table").remove("signals");
    let document = json!({"name": "walls", "study": study, "grid": {"geometry.wall_mm": [2.5, 3]}});
    session
        .ask(Method::POST, "/v1/sweeps:estimate", Some(&document))
        .await;
    let sweep = session
        .ask(Method::POST, "/v1/sweeps", Some(&document))
        .await;
    let path = format!("/v1/sweeps/{}", sweep["id"].as_str().expect("an id"));
    let further = json!({"grid": {"geometry.wall_mm": [3, 3.5]}});
    let further = session
        .ask(Method::POST, &format!("{path}/designs"), Some(&further))
        .await;
    for design in further["designs"].as_array().expect("designs") {
        app.wait_for(design["study"]["id"].as_str().expect("an id"), "done")
            .await;
    }
    session.ask(Method::GET, &path, None).await;
    session
        .ask(Method::POST, &format!("{path}/resume"), Some(&json!({})))
        .await;
    session.ask(Method::GET, "/v1/sweeps", None).await;
    let id = sweep["id"].as_str().expect("an id");
    session
        .ask(Method::GET, &format!("/v1/comparison?sweep={id}"), None)
        .await;
    for table in ["locations", "designs"] {
        let path = format!("/v1/comparison/export?sweep={id}&table={table}");
        session.ask(Method::GET, &path, None).await;
    }
    session
        .ask(Method::PATCH, &path, Some(&json!({"name": "thin walls"})))
        .await;
    session
        .ask(Method::DELETE, &format!("{path}?purge"), None)
        .await;
    compare("sweeps", &session.record());
    session.asked
}

async fn estimators(app: &App) -> Asked {
    let mut session = Session::new(app);
    let run = json!({"file": "friday.csv", "text": "time_ms;s1;note;fz_kn\n0;0,5;a;0\n10;1,5;;0,02\n20;60;b;\n"});
    let looked_at = json!({"recipe": {"columns": {"not_signals": "note"}}, "recordings": [run]});
    session
        .ask(Method::POST, "/v1/recordings:look", Some(&looked_at))
        .await;
    let submitted = session
        .ask(Method::POST, "/v1/estimators", Some(&quick()))
        .await;
    let id = submitted["id"].as_str().expect("an id").to_owned();
    wait_for_estimator(app, &id, "done").await;
    let path = format!("/v1/estimators/{id}");
    for part in ["", "/report", "/left-out"] {
        session
            .ask(Method::GET, &format!("{path}{part}"), None)
            .await;
    }
    session.depth = 1;
    session
        .ask(Method::GET, &format!("{path}/model"), None)
        .await;
    session.depth = DEPTH;
    let run = json!({"file": "friday.csv", "text": "time_s,s1,s2\n0,0.5,0.2\n0.01,1.5,0.1\n0.02,60,0.1\n"});
    session
        .ask(Method::POST, &format!("{path}:apply"), Some(&run))
        .await;
    session
        .ask(Method::POST, &format!("{path}:zero"), Some(&run))
        .await;
    session
        .ask(Method::POST, &format!("{path}:zero"), Some(&json!({})))
        .await;
    session
        .ask(Method::GET, "/v1/estimators?state=done", None)
        .await;
    session
        .ask(Method::DELETE, &format!("{path}?purge"), None)
        .await;
    compare("estimators", &session.record());
    session.asked
}

async fn analyses(app: &App) -> Asked {
    let mut session = Session::new(app);
    let law = json!({"kind": "uniform", "min": 0, "max": 1});
    let inputs = json!([{"name": "a", "distribution": law}, {"name": "b", "distribution": law}]);
    let method = json!({"kind": "mdrm", "nodes": 3, "check_points": 0});
    let mut document = json!({"inputs": inputs, "method": method});
    let post = Method::POST;
    session
        .ask(post.clone(), "/v1/analyses", Some(&document))
        .await;
    document["values"] = json!("id,y\n0,1.5\n1,1.39\n2,1.61\n3,1.27\n4,1.73\n");
    session
        .ask(post.clone(), "/v1/analyses", Some(&document))
        .await;
    document["method"]["colour"] = json!(1);
    session.ask(post, "/v1/analyses", Some(&document)).await;
    compare("analyses", &session.record());
    session.asked
}

async fn service(app: &App) -> Asked {
    let mut session = Session::new(app);
    for path in [
        "/healthz",
        "/readyz",
        "/metrics",
        "/v1/engines",
        "/docs",
        "/login",
    ] {
        session.ask(Method::GET, path, None).await;
    }
    session.ask(Method::POST, "/login", None).await;
    session.depth = 1;
    for path in ["/openapi.json", "/v1/presets"] {
        session.ask(Method::GET, path, None).await;
    }
    for name in ["study", "scene", "sweep", "recipe", "gsa"] {
        let path = format!("/v1/schemas/{name}");
        session.ask(Method::GET, &path, None).await;
    }
    compare("service", &session.record());
    session.asked
}
