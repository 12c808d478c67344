//! Answers as files.

use axum::body::Bytes;
use fem_client::closed_form::ClosedFormSolver;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use reqwest::StatusCode;
use serde_json::{Value, json};

use crate::app::{App, Home, study, study_of_layouts};

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

/// The bytes of an export, checked for their type and the name that they are offered under.
async fn download(app: &App, id: &str, query: &str, kind: &str, name: &str) -> Vec<u8> {
    let response = app.get(&format!("/v1/studies/{id}/export?{query}")).await;
    assert_eq!(response.status(), StatusCode::OK, "{query}");
    assert_eq!(response.headers()["content-type"], kind);
    let disposition = response.headers()["content-disposition"].to_str();
    let expected = format!("attachment; filename=\"{name}\"");
    assert_eq!(disposition.expect("text"), expected);
    response.bytes().await.expect("a body").to_vec()
}

async fn table(app: &App, id: &str, name: &str) -> Columns {
    let query = format!("format=csv&table={name}");
    let file = format!("{id}-{name}.csv");
    let text = download(app, id, &query, "text/csv; charset=utf-8", &file).await;
    Columns::of(&String::from_utf8(text).expect("UTF-8"))
}

#[tokio::test(flavor = "multi_thread")]
async fn tables_say_what_the_result_says() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study_of_layouts()).await;
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
    assert_eq!(points.rows.len(), 26 + 5);

    let json = app
        .get(&format!("/v1/studies/{id}/export?format=json"))
        .await;
    assert_eq!(json.json::<Value>().await.expect("JSON"), result);
}

#[tokio::test(flavor = "multi_thread")]
async fn parquet_has_the_rows_of_csv_with_their_types() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let id = app.submit(&study()).await;
    app.wait_for(&id, "done").await;
    for name in [
        "indices",
        "locations",
        "layouts",
        "points",
        "signals",
        "candidates",
    ] {
        let csv = table(&app, &id, name).await;
        let query = format!("format=parquet&table={name}");
        let (kind, file) = (
            "application/vnd.apache.parquet",
            format!("{id}-{name}.parquet"),
        );
        let bytes = download(&app, &id, &query, kind, &file).await;
        let reader = SerializedFileReader::new(Bytes::from(bytes)).expect("a file");
        let rows: Vec<_> = reader.get_row_iter(None).expect("rows").collect();
        assert_eq!(rows.len(), csv.rows.len(), "{name}");
        for (row, fields) in rows.into_iter().enumerate() {
            let fields = fields.expect("reads");
            assert!(
                fields
                    .get_column_iter()
                    .map(|(name, _)| name)
                    .eq(csv.names.iter())
            );
            for (column, field) in fields.get_column_iter() {
                let text = match field {
                    Field::Null => String::new(),
                    Field::Double(value) => value.to_string(),
                    Field::Long(value) => value.to_string(),
                    Field::Bool(value) => value.to_string(),
                    Field::Str(text) => text.clone(),
                    other => panic!("{column}: {other:?}"),
                };
                assert_eq!(text, csv.at(row, column), "{name}, {column}");
            }
        }
        let metadata = reader.metadata().file_metadata().key_value_metadata();
        let metadata = metadata.expect("metadata").iter();
        let keys: Vec<&str> = metadata.map(|entry| entry.key.as_str()).collect();
        assert_eq!(keys, ["study", "spec_sha256", "version", "table", "units"]);
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn vtu_has_the_map_on_its_surface() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut document = study();
    document["candidates"]["grid"] = json!({"circumferential": 5, "meridional": 3});
    let id = app.submit(&document).await;
    app.wait_for(&id, "done").await;
    let result = app.json(&format!("/v1/studies/{id}/result")).await;
    let bytes = download(
        &app,
        &id,
        "format=vtu",
        "application/xml",
        &format!("{id}.vtu"),
    )
    .await;
    let xml = String::from_utf8(bytes).expect("UTF-8");
    assert!(xml.contains("NumberOfPoints=\"15\" NumberOfCells=\"8\""));
    // The readers of other programs go through the numbers; see tests/exports.
    for name in [
        "displacement",
        "strain_x",
        "std_y",
        "first_order_x_P3",
        "first_order_y_P5",
        "first_order_error_y",
    ] {
        assert!(xml.contains(&format!("Name=\"{name}\"")), "{name}");
    }
    let study = &result["study"];
    for name in ["id", "spec_sha256", "version"] {
        assert!(xml.contains(study[name].as_str().expect("text")), "{name}");
    }
    assert_eq!(
        result["map"]["shape"]["inflated_mm"]
            .as_array()
            .map(Vec::len),
        Some(15)
    );
    // The positions are the cut point's alone.
    let mut sql = home.sql().await;
    let rows: Vec<String> =
        sqlx::query_scalar("SELECT response FROM evaluations WHERE response IS NOT NULL")
            .fetch_all(&mut sql)
            .await
            .expect("rows");
    assert_eq!(rows.len(), 26);
    assert_eq!(
        rows.iter()
            .filter(|row| row.contains("inflated_mm"))
            .count(),
        1
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_comparison_is_a_table_of_its_own() {
    let home = Home::new();
    let app = home.start(ClosedFormSolver::new()).await;
    let mut ids = Vec::new();
    for wall in [3.0, 2.5] {
        let mut document = study();
        document["scene"] = json!({"preset": "foot-tire", "geometry": {"wall_mm": wall}});
        let id = app.submit(&document).await;
        app.wait_for(&id, "done").await;
        ids.push(id);
    }
    let query = format!("studies={},{}", ids[0], ids[1]);
    let compared = app.json(&format!("/v1/comparison?{query}")).await;
    let file = async |rest: &str| {
        app.get(&format!("/v1/comparison/export?{query}&{rest}"))
            .await
    };

    let locations = file("table=locations").await;
    let named = |response: &reqwest::Response| {
        let headers = response.headers();
        let text = |name: &str| headers[name].to_str().expect("text").to_owned();
        (text("content-type"), text("content-disposition"))
    };
    assert_eq!(
        named(&locations),
        (
            "text/csv; charset=utf-8".to_owned(),
            "attachment; filename=\"comparison-locations.csv\"".to_owned()
        )
    );
    let locations = Columns::of(&locations.text().await.expect("text"));
    assert_eq!(locations.rows.len(), 10);
    for (place, row) in compared["rows"]
        .as_array()
        .expect("rows")
        .iter()
        .enumerate()
    {
        assert_eq!(locations.at(place, "study"), row["study"]);
        assert_eq!(locations.at(place, "location"), row["location"]);
        for direction in ["x", "y"] {
            for name in ["gsi_percent", "difference_percent"] {
                let column = format!("{name}_{direction}");
                locations.equals(place, &column, &row[direction][name]);
            }
        }
    }
    let designs = file("table=designs&format=parquet").await;
    assert_eq!(named(&designs).0, "application/vnd.apache.parquet");
    let designs = SerializedFileReader::new(designs.bytes().await.expect("a body"));
    let designs = designs.expect("a Parquet file");
    assert_eq!(designs.metadata().file_metadata().num_rows(), 2);
    let whole: Value = file("format=json").await.json().await.expect("JSON");
    assert_eq!(whole, compared);
}
