//! Layouts moved by hand: scored as the study's own, from what it has stored.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::Response;
use serde_json::{Value, json};

use crate::app::{App, Home, study_of_layouts};

/// Six units of x and y at the crown, every 60 degrees, film by film.
fn pairs() -> Value {
    let films = (0..6).flat_map(|unit| [0.0, 90.0].map(|angle| (60.0 * f64::from(unit), angle)));
    films
        .map(|(theta, angle)| json!({"theta_deg": theta, "phi_deg": 0.0, "angle_deg": angle}))
        .collect()
}

/// A study whose layouts include those pairs as a free layout.
fn with_pairs() -> Value {
    let mut document = study_of_layouts();
    document["layouts"]["free"] = json!([{"name": "pairs", "films": pairs()}]);
    document["layouts"]["gain_std"] = 0.05.into();
    document
}

async fn done(app: &App, document: &Value) -> String {
    let id = app.submit(document).await;
    app.wait_for(&id, "done").await;
    id
}

async fn score(app: &App, id: &str, body: &Value) -> Response {
    let url = app.url(&format!("/v1/studies/{id}/layouts:score"));
    let request = reqwest::Client::new().post(url).json(body);
    request.send().await.expect("an answer")
}

#[tokio::test(flavor = "multi_thread")]
async fn the_study_s_own_layout_has_the_study_s_own_bounds() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = done(&app, &with_pairs()).await;
    let points = app.json(&format!("/v1/studies/{id}/evaluations")).await;
    let mut few = pairs();
    few.as_array_mut().expect("a list").truncate(7);
    let body = json!({"layouts": [{"name": "pairs", "films": pairs()}, {"films": few}], "simulated": true});
    let scored: Value = score(&app, &id, &body).await.json().await.expect("JSON");
    let layouts = app.json(&format!("/v1/studies/{id}/layouts")).await;
    let own = layouts["layouts"].as_array().expect("a list").iter();
    let own = own
        .filter(|layout| layout["name"] == "pairs")
        .collect::<Vec<_>>();
    let (own, found) = (
        &own[0]["loads"][0]["score"],
        &scored["layouts"][0]["loads"][0]["score"],
    );
    for bound in [
        "worst_angle_error_deg",
        "rms_angle_error_deg",
        "worst_depth_error_mm",
        "weakest_signal",
        "noise_strain",
        "reason",
    ] {
        assert_eq!(own[bound], found[bound], "{bound}");
    }
    // Other draws of the same noise.
    let p95 = |score: &Value| {
        score["simulated_p95_angle_error_deg"]
            .as_f64()
            .expect("a figure")
    };
    let se = own["simulated_p95_angle_error_deg_se"]
        .as_f64()
        .expect("an error");
    assert!((p95(own) - p95(found)).abs() < 4.0 * se.max(1e-3), "{se}");
    let other = &scored["layouts"][1];
    assert_eq!(
        (&other["name"], &other["film_count"]),
        (&json!("layout 2"), &json!(7))
    );
    // Nothing is solved, and whatever is asked beside it changes nothing.
    assert_eq!(
        points,
        app.json(&format!("/v1/studies/{id}/evaluations")).await
    );
    let alone = json!({"layouts": [body["layouts"][0]], "simulated": true});
    let alone: Value = score(&app, &id, &alone).await.json().await.expect("JSON");
    assert_eq!(alone["layouts"][0], scored["layouts"][0]);
    // Bounds alone are the same bounds.
    let plain = json!({"layouts": body["layouts"]});
    let plain: Value = score(&app, &id, &plain).await.json().await.expect("JSON");
    let plain = &plain["layouts"][0]["loads"][0]["score"];
    assert_eq!(plain["simulated_p95_angle_error_deg"], Value::Null);
    assert_eq!(
        plain["worst_angle_error_deg"],
        found["worst_angle_error_deg"]
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn fields_are_of_every_kind_and_the_rings_in_full() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = done(&app, &with_pairs()).await;
    let fields = app.json(&format!("/v1/studies/{id}/layouts/fields")).await;
    let kinds = fields["kinds"].as_array().expect("a list");
    assert!(kinds.contains(&json!({"phi_deg": 0.0, "angle_deg": 90.0})));
    assert_eq!(fields["noise"]["gain_std"], 0.05);
    let load = &fields["loads"][0];
    for lists in ["signals", "slopes_per_mm"] {
        let lists = load[lists].as_array().expect("a list for each kind");
        assert_eq!(lists.len(), kinds.len());
        assert!(
            lists
                .iter()
                .all(|list| list.as_array().is_some_and(|list| list.len() == 360))
        );
    }
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let rings = result["layout_findings"]["rings"]
        .as_array()
        .expect("rings");
    let ring = rings
        .iter()
        .find(|ring| ring["direction"] == "x")
        .expect("x");
    let exact = kinds
        .iter()
        .position(|kind| kind["phi_deg"] == 0.0 && kind["angle_deg"] == 0.0)
        .expect("x at the crown");
    let lists = load["signals"][exact]
        .as_array()
        .expect("a list")
        .iter()
        .zip(ring["strain"].as_array().expect("a list"));
    for (exact, rounded) in lists {
        let apart = exact.as_f64().expect("a number") - rounded.as_f64().expect("a number");
        assert!(apart.abs() <= 0.5000001e-9, "{exact} {rounded}");
    }
}
