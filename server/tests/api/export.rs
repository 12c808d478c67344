//! Answers as files.

use fem_client::closed_form::ClosedFormSolver;
use reqwest::StatusCode;
use serde_json::Value;

use crate::support::{App, Home, problem, study};

/// A table as another program reads it, by columns.
struct Columns {
    names: csv::StringRecord,
    rows: Vec<csv::StringRecord>,
}

impl Columns {
    fn of(text: &str) -> Self {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let names = reader.headers().expect("a header").clone();
        let rows = reader.records();
        let rows = rows
            .map(|row| row.expect("as long as the header"))
            .collect();
        Self { names, rows }
    }

    fn at(&self, row: usize, name: &str) -> &str {
        let column = self.names.iter().position(|n| n == name);
        &self.rows[row][column.expect("the column")]
    }

    /// A field as the number of the REST answer that it must be, bit for bit.
    fn equals(&self, row: usize, name: &str, expected: &Value) {
        let field = self.at(row, name);
        match expected.as_f64() {
            Some(number) => assert_eq!(field.parse::<f64>().expect("a number"), number, "{name}"),
            None => assert_eq!(field, "", "{name}"),
        }
    }
}

async fn table(app: &App, id: &str, name: &str) -> Columns {
    let address = format!("/v1/studies/{id}/export?format=csv&table={name}");
    let response = app.get(&address).await;
    assert_eq!(response.status(), StatusCode::OK);
    assert_eq!(
        response.headers()["content-type"],
        "text/csv; charset=utf-8"
    );
    let disposition = response.headers()["content-disposition"].to_str();
    let expected = format!("attachment; filename=\"{id}-{name}.csv\"");
    assert_eq!(disposition.expect("text"), expected);
    Columns::of(&response.text().await.expect("text"))
}

#[tokio::test(flavor = "multi_thread")]
async fn tables_say_what_the_result_says() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    app.wait_for(&id, "done").await;
    let result = app.json(&format!("/v1/studies/{id}/result")).await;

    let indices = table(&app, &id, "indices").await;
    assert_eq!(indices.rows.len(), 10 * 5);
    for row in 0..indices.rows.len() {
        let (output, k) = (&result["outputs"][row / 5], row % 5);
        assert_eq!(indices.at(row, "location"), output["location"]);
        assert_eq!(indices.at(row, "direction"), output["direction"]);
        assert_eq!(indices.at(row, "input"), result["inputs"][k]["name"]);
        indices.equals(row, "first_order", &output["first_order"][k]);
        indices.equals(row, "total", &output["total"][k]);
        indices.equals(row, "error_total", &output["error"]["total"]);
        indices.equals(row, "std_strain", &output["std"]);
        assert_eq!(indices.at(row, "study"), id);
        assert_eq!(
            indices.at(row, "spec_sha256"),
            result["study"]["spec_sha256"]
        );
        assert_eq!(indices.at(row, "version"), result["study"]["version"]);
    }

    let locations = table(&app, &id, "locations").await;
    for (row, location) in result["locations"]
        .as_array()
        .expect("a list")
        .iter()
        .enumerate()
    {
        assert_eq!(locations.at(row, "name"), location["name"]);
        for column in [
            "rank",
            "gsi_x_percent",
            "gsi_y_error_percent",
            "own_gsi_x_percent",
        ] {
            locations.equals(row, column, &location[column]);
        }
    }

    let layouts = table(&app, &id, "layouts").await;
    for (row, layout) in result["layouts"]
        .as_array()
        .expect("a list")
        .iter()
        .enumerate()
    {
        layouts.equals(row, "spacing_deg", &layout["spacing_deg"]);
        layouts.equals(
            row,
            "worst_angle_error_deg",
            &layout["score"]["worst_angle_error_deg"],
        );
    }

    let points = table(&app, &id, "points").await;
    let body = app.json(&format!("/v1/studies/{id}/evaluations")).await;
    for (row, point) in body["evaluations"]
        .as_array()
        .expect("a list")
        .iter()
        .enumerate()
    {
        points.equals(row, "P3", &point["values"][2]);
        points.equals(row, "reaction_n", &point["reaction_n"]);
        points.equals(row, "P3_strain_y", &point["locations"][2]["strain_y"]);
    }
    assert_eq!(points.rows.len(), 26);

    let json = app
        .get(&format!("/v1/studies/{id}/export?format=json"))
        .await;
    assert_eq!(json.json::<Value>().await.expect("JSON"), result);
}

#[tokio::test(flavor = "multi_thread")]
async fn what_can_not_be_exported_is_refused() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    app.wait_for(&id, "done").await;
    for (query, named) in [("format=xls", "format"), ("table=all", "table")] {
        let answer = app.get(&format!("/v1/studies/{id}/export?{query}")).await;
        let body = problem(answer, StatusCode::BAD_REQUEST).await;
        assert!(body["detail"].as_str().expect("text").contains(named));
    }
    let absent = app.get("/v1/studies/none/export").await;
    problem(absent, StatusCode::NOT_FOUND).await;
}
