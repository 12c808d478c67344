//! Results of a study.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;
use serde_json::{Value, json};
use store::answers::trades;

use crate::app::{Home, problem, study, study_of_layouts};

#[tokio::test(flavor = "multi_thread")]
async fn a_done_study_has_its_result_locations_layouts_and_points() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study_of_layouts()).await;
    let done = app.wait_for(&id, "done").await;
    let at = |part: &str| format!("/v1/studies/{id}/{part}");

    let response = app.get(&at("result")).await;
    let etag = response.headers()["etag"].clone();
    assert_eq!(
        etag,
        format!("\"{}\"", done["result_sha256"].as_str().expect("a hash"))
    );
    let result: Value = response.json().await.expect("JSON");
    let unchanged = app
        .client
        .get(app.url(&at("result")))
        .header("if-none-match", etag)
        .send()
        .await;
    assert_eq!(
        unchanged.expect("an answer").status(),
        StatusCode::NOT_MODIFIED
    );

    assert_eq!(
        app.json(&at("locations")).await["locations"],
        result["locations"]
    );
    assert_eq!(app.json(&at("layouts")).await["layouts"], result["layouts"]);
    assert_eq!(result["locations"].as_array().map(Vec::len), Some(5));
    assert_eq!(result["outputs"].as_array().map(Vec::len), Some(10));

    let body = app.json(&at("evaluations")).await;
    let points = body["evaluations"].as_array().expect("a list");
    assert_eq!(points.len(), 26 + 5);
    for (ordinal, point) in points.iter().enumerate() {
        assert_eq!(point["ordinal"], ordinal);
        assert_eq!(point["values"].as_array().map(Vec::len), Some(5));
        assert_eq!(point["locations"].as_array().map(Vec::len), Some(5));
        assert!(
            point["reaction_n"].is_number()
                && point["wall_s"].is_number()
                && point["newton_iterations"].is_u64()
        );
    }
    assert_eq!(
        points[0]["values"],
        json!([1.0, 1.0, 1.0, 1.0, 1.0]),
        "the cut point lies at the means"
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_result_without_its_map_is_the_same_but_for_that() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut document = study();
    document["candidates"]["grid"] = json!({"circumferential": 5, "meridional": 3});
    let id = app.submit(&document).await;
    app.wait_for(&id, "done").await;
    let address = format!("/v1/studies/{id}/result");
    let mut whole = app.json(&address).await;
    assert!(whole["map"]["layers"].is_array());
    assert_eq!(app.json(&format!("{address}?map=true")).await, whole);

    let mapless = format!("{address}?map=false");
    let response = app.get(&mapless).await;
    let tags = [&app.get(&address).await, &response].map(|answer| answer.headers()["etag"].clone());
    assert_ne!(tags[0], tags[1], "another content has another tag");
    whole["map"] = Value::Null;
    assert_eq!(response.json::<Value>().await.expect("JSON"), whole);
    for (tag, status) in tags.iter().zip([StatusCode::OK, StatusCode::NOT_MODIFIED]) {
        let asked = app
            .client
            .get(app.url(&mapless))
            .header("if-none-match", tag);
        let again = asked.send().await.expect("an answer");
        assert_eq!(again.status(), status, "{tag:?}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_point_without_equilibrium_is_named_with_its_inputs_and_its_reason() {
    let home = Home::new();
    // The outermost of a depth's five nodes lies near 1.27 mm.
    let app = home
        .start(ClosedFormSolver::new().with_depth_limit(1.26))
        .await;
    let id = app.submit(&study()).await;
    let done = app.wait_for(&id, "done").await;
    assert_eq!(
        (&done["points_done"], &done["error"]),
        (&json!(26), &Value::Null)
    );
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let failed = result["failed_points"].as_array().expect("a list");
    assert!((5..20).contains(&failed.len()), "{failed:?}");

    let body = app.json(&format!("/v1/studies/{id}/evaluations")).await;
    let points = body["evaluations"].as_array().expect("a list");
    assert_eq!(points.len(), 26);
    for point in points {
        let entry = failed.iter().find(|f| f["ordinal"] == point["ordinal"]);
        let Some(entry) = entry else {
            assert!(
                point["reaction_n"].is_number() && point.get("reason").is_none(),
                "{point}"
            );
            continue;
        };
        assert_eq!(
            (&point["values"], &point["reason"]),
            (&entry["values"], &entry["cause"])
        );
        for field in ["reaction_n", "locations", "newton_iterations"] {
            assert_eq!(point[field], Value::Null, "{field}");
        }
        let deepest = point["reached"]["depths_mm"]
            .as_array()
            .expect("depths")
            .iter()
            .filter_map(Value::as_f64)
            .fold(0.0, f64::max);
        assert!((deepest - 1.26).abs() < 1e-12, "{point}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn ranked_rows_can_be_queried_in_sql() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study_of_layouts()).await;
    app.wait_for(&id, "done").await;
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let mut sql = home.sql().await;
    for list in ["locations", "layouts"] {
        let query =
            format!("select place, rank, document from {list} where study = ? order by place");
        let rows: Vec<(i64, i64, String)> = sqlx::query_as(sqlx::AssertSqlSafe(query))
            .bind(&id)
            .fetch_all(&mut sql)
            .await
            .expect("rows");
        let expected = result[list].as_array().expect("a list");
        assert!(!rows.is_empty() && rows.len() == expected.len(), "{list}");
        for ((place, rank, document), (index, row)) in rows.iter().zip((1..).zip(expected)) {
            assert_eq!((*place, Some(*rank)), (index, row["rank"].as_i64()));
            let document: Value = serde_json::from_str(document).expect("JSON");
            assert_eq!(&document, row);
        }
    }
    let scores: Vec<(String, String, Option<f64>)> = sqlx::query_as(
        "select name, score, location_scores.value from location_scores join locations using (study, place) where study = ?",
    )
    .bind(&id)
    .fetch_all(&mut sql)
    .await
    .expect("rows");
    let location = |name: &str| {
        let mut all = result["locations"].as_array().expect("a list").iter();
        all.find(|location| location["name"] == name)
    };
    for (name, score, value) in &scores {
        let shown = location(name).expect("a location")[score].as_f64();
        // SQLite reads decimals to the last digit but one.
        let close = shown
            .zip(*value)
            .map(|(a, b)| (a - b).abs() <= 1e-15 * a.abs());
        assert!(close.unwrap_or(shown == *value), "{name} {score}");
    }
    assert_eq!(scores.len(), 5 * 10);
}

#[tokio::test(flavor = "multi_thread")]
async fn nothing_of_a_damaged_result_is_served() {
    let mut document = study_of_layouts();
    document["candidates"]["grid"] = json!({"circumferential": 5, "meridional": 3});
    for (damage, table, parts) in [
        (
            "update results set document = replace(document, '\"rank\":1', '\"rank\":2')",
            "results",
            &[
                "locations",
                "layouts",
                "signals",
                "map",
                "result",
                "result?map=false",
            ][..],
        ),
        (
            "update result_maps set document = replace(document, '0', '1')",
            "result_maps",
            &["map", "result"],
        ),
        ("delete from result_maps", "result_maps", &["map", "result"]),
        (
            "update results set map_place = null, map_sha256 = null",
            "results",
            &["locations", "map", "result"],
        ),
    ] {
        let home = Home::new();
        let app = home.start(ClosedFormSolver::new()).await;
        let id = app.submit(&document).await;
        app.wait_for(&id, "done").await;
        let at = |part: &str| format!("/v1/studies/{id}/{part}");
        let result = app.json(&at("result")).await;
        for part in ["locations", "layouts"] {
            assert_eq!(app.json(&at(part)).await[part], result[part]);
        }

        let mut sql = home.sql().await;
        let damaged = sqlx::query(damage).execute(&mut sql).await;
        assert!(damaged.expect("damages").rows_affected() > 0, "{damage}");
        for part in parts {
            let refused = app.get(&at(part)).await;
            let body = problem(refused, StatusCode::INTERNAL_SERVER_ERROR).await;
            let detail = body["detail"].as_str().expect("a sentence");
            let named = detail.contains(&format!("table {table} ")) && detail.contains(&id);
            assert!(named, "{damage}: {part}: {body}");
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn the_map_is_served_layer_by_layer() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut document = study();
    document["candidates"]["grid"] = json!({"circumferential": 7, "meridional": 5});
    let id = app.submit(&document).await;
    app.wait_for(&id, "done").await;
    let at = |query: &str| format!("/v1/studies/{id}/map{query}");

    let map = app.json(&at("?direction=y&input=P3")).await;
    assert_eq!(
        (&map["direction"], &map["input"]),
        (&json!("y"), &json!("P3"))
    );
    assert_eq!(map["theta_deg"].as_array().map(Vec::len), Some(7));
    assert_eq!(map["phi_deg"].as_array().map(Vec::len), Some(5));
    for field in ["first_order", "std", "strain", "error", "status"] {
        assert_eq!(map[field].as_array().map(Vec::len), Some(35), "{field}");
    }
    assert_eq!(map["total"], Value::Null, "only where it is asked for");
    let both = app.json(&at("?direction=y&input=P3&index=total")).await;
    assert_eq!(both["first_order"], map["first_order"]);
    // The crown above the contact centre is the middle of the grid: the fourth column of the third row.
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let centre = &result["outputs"]
        .as_array()
        .expect("a list")
        .iter()
        .find(|output| output["location"] == "P3" && output["direction"] == "y");
    let at_centre = map["first_order"][2 * 7 + 3].as_f64().expect("an index");
    let expected = centre.expect("P3")["first_order"][2]
        .as_f64()
        .expect("an index");
    let total = both["total"][2 * 7 + 3].as_f64().expect("an index");
    let total_there = centre.expect("P3")["total"][2].as_f64();
    // A map keeps seven digits.
    assert!((total - total_there.expect("an index")).abs() < 5e-7);
    // The same numbers through the same formula.
    assert!(
        (at_centre - expected).abs() < 5e-7,
        "{at_centre} against {expected}"
    );
    let p3 = |location: &&Value| location["name"] == "P3";
    let ranked = result["locations"]
        .as_array()
        .and_then(|all| all.iter().find(p3));
    let shown = ranked.expect("P3")["gsi_y_error_percent"]
        .as_f64()
        .expect("an error");
    let error = map["error"][2 * 7 + 3].as_f64().expect("an error");
    assert!(
        (100.0 * error - shown).abs() < 1e-9,
        "{error} against {shown}"
    );

    assert_ne!(
        app.json(&at("?direction=x&input=P3")).await["strain"],
        map["strain"]
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_damaged_row_is_named_and_never_served() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    app.wait_for(&id, "done").await;
    let mut sql = home.sql().await;
    let key: String = sqlx::query_scalar("select key from evaluations limit 1")
        .fetch_one(&mut sql)
        .await
        .expect("a key");
    let damage = "update evaluations set response = replace(response, '\"reaction_n\":', '\"reaction_n\":1') where key = ?";
    sqlx::query(damage)
        .bind(&key)
        .execute(&mut sql)
        .await
        .expect("damages");
    sqlx::query("update results set document = replace(document, '\"rank\":1', '\"rank\":2')")
        .execute(&mut sql)
        .await
        .expect("damages");

    let points = app.get(&format!("/v1/studies/{id}/evaluations")).await;
    let body = problem(points, StatusCode::INTERNAL_SERVER_ERROR).await;
    assert!(
        body["detail"]
            .as_str()
            .is_some_and(|detail| detail.contains(&key)),
        "{body}"
    );
    let result = app.get(&format!("/v1/studies/{id}/result")).await;
    let body = problem(result, StatusCode::INTERNAL_SERVER_ERROR).await;
    assert!(
        body["detail"]
            .as_str()
            .is_some_and(|detail| detail.contains(&id)),
        "{body}"
    );

    // A study that needs the damaged point fails by its name instead of using it.
    let next = app.submit(&study()).await;
    let failed = app.wait_for(&next, "failed").await;
    assert!(
        failed["error"]
            .as_str()
            .is_some_and(|error| error.contains(&key)),
        "{failed}"
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn presets_can_be_submitted_as_they_are() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let presets = app.json("/v1/presets").await;
    assert!(
        presets["scenes"]
            .as_array()
            .is_some_and(|scenes| !scenes.is_empty())
    );
    let studies = presets["studies"].as_array().expect("a list");
    assert!(!studies.is_empty());
    for preset in studies {
        let id = app.submit(&preset["document"]).await;
        // A search takes half a minute of simulations, whatever solves.
        if preset["document"]["layouts"]["search"].is_null() {
            app.wait_for(&id, "done").await;
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_measured_trade_is_shown_with_every_study_of_its_document() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    let before = app.wait_for(&id, "done").await;
    assert_eq!(before["trade_measured"], false);
    let address = format!("/v1/studies/{id}/trade");
    let missing = problem(app.get(&address).await, StatusCode::NOT_FOUND).await;
    let detail = missing["detail"].as_str().expect("a sentence");
    assert!(detail.contains("strainsite trade"), "{detail}");

    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let rung = json!({
        "label": "draft mdrm 3", "wall_s": 0.2, "cpu_s": 0.3, "solves": 16, "error_true": 0.02, "error_claimed": null,
        "fidelity": {"level": "draft", "method": "mdrm", "nodes": 3, "check_points": 5},
        "covered": 1.0, "ranking_agrees": true, "pareto": true, "indices": [],
    });
    let trade = json!({
        "study": "a study", "spec_sha256": result["study"]["spec_sha256"], "reference": rung, "rungs": [rung],
    });
    let measured = serde_json::from_value(trade.clone()).expect("a trade");
    let stored = trades::insert(&mut home.sql().await, &measured).await;
    stored.expect("stores");
    assert_eq!(app.json(&address).await, trade);
    let after = app.json(&format!("/v1/studies/{id}")).await;
    assert_eq!(after["trade_measured"], true);
}
