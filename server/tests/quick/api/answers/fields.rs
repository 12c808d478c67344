//! Fields over the wheel, from what a study has stored.

use std::sync::Arc;
use std::time::Duration;

use fem_client::closed_form::ClosedFormSolver;
use fem_client::solver::Solver;
use reqwest::StatusCode;
use serde_json::{Value, json};
use service::solving::solver_choice::{SolverName, solver};

use crate::app::{App, Home, problem, study, study_of_layouts};

/// Time far beyond what a draft takes.
const LIMIT: Duration = Duration::from_secs(600);

fn embedded() -> Arc<dyn Solver> {
    solver(SolverName::Embedded, LIMIT).expect("a solver")
}

/// Two depths on a draft with a small map.
fn draft() -> Value {
    let mut document = study();
    document["inputs"]
        .as_array_mut()
        .expect("inputs")
        .truncate(2);
    document["candidates"]["grid"] = json!({"circumferential": 5, "meridional": 3});
    document["method"] = json!({"kind": "mdrm", "nodes": 3});
    document["accuracy"] = json!({"preset": "draft"});
    document
}

async fn done(app: &App, document: &Value) -> String {
    let id = app.submit(document).await;
    app.wait_for(&id, "done").await;
    id
}

/// The header of a surface and its lists of points.
fn surface_of(bytes: &[u8]) -> (Value, Vec<Vec<[f32; 3]>>) {
    let length = u32::from_le_bytes(bytes[..4].try_into().expect("four bytes")) as usize;
    assert_eq!(length % 4, 0);
    let header: Value = serde_json::from_slice(&bytes[4..4 + length]).expect("JSON");
    let numbers = &bytes[4 + length..];
    let list = |array: &Value| {
        let number = |name: &str| array[name].as_u64().expect("a number") as usize;
        assert_eq!((number("components"), &array["unit"]), (3, &json!("mm")));
        let (at, count) = (number("offset"), number("count"));
        let words = numbers[at..at + 12 * count].as_chunks::<4>().0;
        let singles: Vec<f32> = words.iter().map(|word| f32::from_le_bytes(*word)).collect();
        singles.as_chunks::<3>().0.to_vec()
    };
    let arrays = header["arrays"].as_array().expect("a list");
    let lists = arrays.iter().map(list).collect();
    (header, lists)
}

#[tokio::test(flavor = "multi_thread")]
async fn the_surface_lies_where_the_map_does_and_is_packed() {
    let home = Home::new();
    let app = home.start_on(embedded()).await;
    let id = done(&app, &draft()).await;
    let address = format!("/v1/studies/{id}/surface");
    let response = app.get(&address).await;
    assert_eq!(response.status(), StatusCode::OK);
    assert_eq!(
        response.headers()["content-type"],
        "application/octet-stream"
    );
    let tag = response.headers()["etag"].clone();
    let (header, lists) = surface_of(&response.bytes().await.expect("a body"));
    assert_eq!(
        (&header["study"], &header["level"]),
        (&json!(id), &json!("draft"))
    );
    let angles = |name: &str| -> Vec<f64> {
        let list = header[name].as_array().expect("a list").iter();
        list.map(|angle| angle.as_f64().expect("a number"))
            .collect()
    };
    let (phi, theta) = (angles("phi_deg"), angles("theta_deg"));
    assert_eq!(
        (&header["rows"], &header["columns"]),
        (&json!(phi.len()), &json!(theta.len()))
    );
    assert!(
        lists.len() == 4
            && lists
                .iter()
                .all(|list| list.len() == phi.len() * theta.len())
    );

    // The map has the crown above the contact's centre, which is a node.
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let shape = &result["map"]["shape"];
    let zero = |angles: &[f64]| {
        angles
            .iter()
            .position(|angle| *angle == 0.0)
            .expect("a line")
    };
    let node = zero(&phi) * theta.len() + zero(&theta);
    for (list, field) in [(0, "inflated_mm"), (1, "displacement_mm")] {
        for i in 0..3 {
            let of_map = shape[field][7][i].as_f64().expect("a number");
            let sent = f64::from(lists[list][node][i]);
            assert!((sent - of_map).abs() < 1e-5, "{field}: {sent} {of_map}");
        }
    }

    let get = |name, value| app.client.get(app.url(&address)).header(name, value).send();
    let unchanged = get("if-none-match", tag.to_str().expect("text")).await;
    assert_eq!(
        unchanged.expect("an answer").status(),
        StatusCode::NOT_MODIFIED
    );
    let packed = get("accept-encoding", "gzip").await.expect("an answer");
    assert_eq!(packed.headers()["content-encoding"], "gzip");

    let file = app
        .get(&format!("/v1/studies/{id}/export?format=glb"))
        .await;
    assert_eq!(file.headers()["content-type"], "model/gltf-binary");
    let file = file.bytes().await.expect("a body");
    let length = u32::from_le_bytes(file[12..16].try_into().expect("four bytes")) as usize;
    let document: Value = serde_json::from_slice(&file[20..20 + length]).expect("JSON");
    let origin = &document["asset"]["extras"];
    assert_eq!(
        (&origin["study"], &origin["version"]),
        (&json!(id), &result["study"]["version"])
    );
    assert_eq!(document["accessors"][0]["count"], phi.len() * theta.len());
}

#[tokio::test(flavor = "multi_thread")]
async fn another_solver_s_study_has_no_surface_and_says_so() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = done(&app, &draft()).await;
    for part in ["surface", "export?format=glb"] {
        let response = app.get(&format!("/v1/studies/{id}/{part}")).await;
        let missing = problem(response, StatusCode::NOT_FOUND).await;
        let detail = missing["detail"].as_str().expect("a sentence");
        assert!(detail.contains("cut point"), "{detail}");
    }
    let response = app.get("/v1/studies/x/surface").await;
    problem(response, StatusCode::NOT_FOUND).await;
}

/// All numbers of a list.
fn numbers(list: &Value) -> Vec<f64> {
    let list = list.as_array().expect("a list").iter();
    list.map(|number| number.as_f64().expect("a number"))
        .collect()
}

#[tokio::test(flavor = "multi_thread")]
async fn sections_have_the_solved_nodes_of_their_input_alone() {
    let home = Home::new();
    let app = home.start_on(embedded()).await;
    let id = done(&app, &draft()).await;
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let body = app.json(&format!("/v1/studies/{id}/evaluations")).await;
    let points = body["evaluations"].as_array().expect("a list");
    for (k, name) in ["P1", "P2"].into_iter().enumerate() {
        let sections = app
            .json(&format!("/v1/studies/{id}/sections?input={name}"))
            .await;
        assert_eq!(
            (&sections["input"], &sections["vary"]),
            (&json!(name), &result["inputs"][k]["vary"])
        );
        for lines in ["theta_deg", "phi_deg"] {
            assert_eq!(sections[lines], result["map"][lines]);
        }
        assert_eq!(
            sections["inflated_mm"],
            result["map"]["shape"]["inflated_mm"]
        );
        assert_eq!(sections["failed"], json!([]));
        let nodes = sections["nodes"].as_array().expect("a list");
        let values: Vec<f64> = nodes
            .iter()
            .map(|node| node["value"].as_f64().expect("a number"))
            .collect();
        assert!(
            values.len() == 3 && values.windows(2).all(|pair| pair[0] < pair[1]),
            "{values:?}"
        );
        for node in nodes {
            let point = &points[node["ordinal"].as_u64().expect("a number") as usize];
            assert_eq!(node["value"], point["values"][k]);
            assert_eq!(point["values"][1 - k], 1.0, "the other one is at its mean");
            assert_eq!(node["reaction_n"], point["reaction_n"]);
            // The middle of the map is P3's place, bit for bit.
            let strains = [&node["strain_x"], &node["strain_y"]].map(numbers);
            assert!(strains.iter().all(|strain| strain.len() == 15));
            for (strain, field) in strains.iter().zip(["strain_x", "strain_y"]) {
                let there = point["locations"][2][field].as_f64().expect("a number");
                assert!((strain[7] - there).abs() < 1e-12, "{field}");
            }
            let displacement = node["displacement_mm"].as_array().expect("a list");
            assert_eq!(displacement.len(), 15);
            let raised = displacement[7][2].as_f64().expect("a number");
            assert!((0.1..2.0).contains(&raised), "{raised}");
        }
        let cut = nodes
            .iter()
            .find(|node| node["cut_point"] == true)
            .expect("the means");
        assert_eq!((&cut["ordinal"], &cut["value"]), (&json!(0), &json!(1.0)));
        assert_eq!(
            cut["displacement_mm"],
            result["map"]["shape"]["displacement_mm"]
        );
        // A map keeps seven digits.
        let strains = |list: &Value| -> Vec<f64> {
            let list = list.as_array().expect("a list").iter();
            list.map(|strain| strain.as_f64().expect("a strain"))
                .collect()
        };
        let of_map = strains(&result["map"]["layers"][0]["strain"]);
        let solved = strains(&cut["strain_x"]);
        assert_eq!(of_map.len(), solved.len());
        for (told, exact) in of_map.iter().zip(&solved) {
            assert!(
                (told - exact).abs() <= 0.5e-6 * exact.abs(),
                "{told} {exact}"
            );
        }
    }
    let wrong = app
        .get(&format!("/v1/studies/{id}/sections?input=P9"))
        .await;
    let refusal = problem(wrong, StatusCode::BAD_REQUEST).await;
    assert_eq!(refusal["detail"], "input is one of P1, P2");
}

#[tokio::test(flavor = "multi_thread")]
async fn nodes_without_an_equilibrium_are_named() {
    let home = Home::new();
    // The outermost of a depth's five nodes lies near 1.27 mm.
    let app = home
        .start(ClosedFormSolver::new().with_depth_limit(1.26))
        .await;
    let mut document = study();
    document["candidates"]["grid"] = json!({"circumferential": 5, "meridional": 3});
    let id = done(&app, &document).await;
    let sections = app.json(&format!("/v1/studies/{id}/sections")).await;
    assert_eq!(
        (
            &sections["input"],
            sections["nodes"].as_array().map(Vec::len)
        ),
        (&json!("P1"), Some(4))
    );
    let failed = sections["failed"].as_array().expect("a list");
    assert_eq!(failed.len(), 1);
    assert!(failed[0]["value"].as_f64() > Some(1.26));
    let reason = failed[0]["reason"].as_str().expect("a sentence");
    assert!(!reason.is_empty());

    let id = done(&app, &study()).await;
    let missing = problem(
        app.get(&format!("/v1/studies/{id}/sections")).await,
        StatusCode::NOT_FOUND,
    )
    .await;
    assert!(missing["detail"].to_string().contains("no map"));
}

#[tokio::test(flavor = "multi_thread")]
async fn rings_are_those_of_the_layouts() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = done(&app, &study_of_layouts()).await;
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let stored = result["layout_findings"]["rings"]
        .as_array()
        .expect("a list");
    let body = app.json(&format!("/v1/studies/{id}/rings")).await;
    let rings = body["rings"].as_array().expect("a list");
    assert_eq!((&body["unit"], rings.len()), (&json!("strain"), 1));
    let ring = &rings[0];
    assert_eq!(ring["section_deg"], 0.0);
    assert_eq!(ring["load"]["depth_mm"], stored[0]["depth_mm"]);
    assert_eq!(
        ring["load"]["load_n"],
        result["layout_findings"]["loads"][0]["load_n"]
    );
    let theta = numbers(&ring["theta_deg"]);
    assert_eq!((theta.len(), theta[0], theta[359]), (360, -180.0, 179.0));
    assert!(!stored.is_empty());
    for of in stored {
        let direction = of["direction"].as_str().expect("a name");
        assert_eq!(ring[format!("strain_{direction}")], of["strain"]);
        assert_eq!(ring[format!("slope_{direction}_per_mm")], of["by_depth"]);
    }
    let id = done(&app, &study()).await;
    assert_eq!(
        app.json(&format!("/v1/studies/{id}/rings")).await,
        json!({"unit": "strain", "rings": []})
    );
}
