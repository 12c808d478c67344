//! What a study found, as a file for other programs.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use super::AppState;
use super::examples;
use super::extract::{Params, StudyId, StudyPath};
use super::problem::Problem;
use super::results::ready;
use super::studies::known;
use super::wire::ProblemDocument;
use crate::export::{Table, csv};
use crate::points;

/// `/v1/studies/{id}/export`.
pub fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(export))
}

#[derive(Deserialize)]
struct ExportQuery {
    format: Option<String>,
    table: Option<String>,
}

/// Download a table or the result
///
/// As CSV one table, each of its rows with the study, the hash of its document and the version of the program; as JSON the whole result.
#[utoipa::path(get, path = "/v1/studies/{id}/export", tag = "answers", params(StudyPath,
        ("format" = Option<String>, Query, description = "csv or json; csv when left out", example = "csv"),
        ("table" = Option<Table>, Query, description = "What the CSV holds: indices (when left out), locations, layouts or points", example = "points")),
    responses((status = 200, description = "The file", content(
                  (String = "text/csv", example = json!(examples::csv())),
                  (placement::result::StudyResult = "application/json", example = json!(examples::result())))),
              (status = 404, description = "There is no such study, or it hasn't this yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn export(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    Params(query): Params<ExportQuery>,
) -> Result<Response, Problem> {
    let wrong = |detail: &str| Problem::new(StatusCode::BAD_REQUEST, detail);
    let name = query.table.as_deref().unwrap_or("indices");
    let table = Table::named(name)
        .ok_or_else(|| wrong("table is one of indices, locations, layouts, points"))?;
    let format = query.format.as_deref().unwrap_or("csv");
    if !["csv", "json"].contains(&format) {
        return Err(wrong("format is csv or json"));
    }
    let (result, _) = ready(&state.store, &id).await?;
    if format == "json" {
        let text = serde_json::to_string_pretty(&result)
            .map_err(|error| Problem::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()))?;
        return Ok(file("application/json", &format!("{id}.json"), text));
    }
    let points = match table {
        Table::Points => {
            let study = known(&state.store, &id).await?;
            let mut connection = state.store.read().await?;
            points::of(&mut connection, &study).await?
        }
        _ => Vec::new(),
    };
    let text = csv(table, &result, &points);
    let name = format!("{id}-{}.csv", table.as_str());
    Ok(file("text/csv; charset=utf-8", &name, text))
}

/// A download; the identifier of a known study is a UUID and needs no quoting.
fn file(kind: &'static str, name: &str, text: String) -> Response {
    let disposition = format!("attachment; filename=\"{name}\"");
    let headers = [
        (header::CONTENT_TYPE, kind.to_owned()),
        (header::CONTENT_DISPOSITION, disposition),
    ];
    (headers, text).into_response()
}
