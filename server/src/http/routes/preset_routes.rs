//! Documents to start from, those that ship, and the schemas of all.

use axum::Json;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use document::fields::alternatives;
use documents::schemas::DocumentKind;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::extract::DocumentName;
use crate::http::edge::problem_document::Problem;
use service::study_document::shipped::shipped;
use service::wire::study_wire::Presets;

/// `/v1/presets` and `/v1/schemas/{name}`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(presets))
        .routes(routes!(schema))
}

/// List the shipped documents
///
/// Studies and scenes to start from, to show, to change and to submit.
#[utoipa::path(get, path = "/v1/presets", tag = "service",
    responses((status = 200, description = "The documents", body = Presets)))]
async fn presets() -> Json<Presets> {
    Json(shipped())
}

/// Get the schema of a document
///
/// JSON Schema, draft 2020-12, with every bound, default, unit and description: of a `study`, a `scene`, a `sweep`, a `recipe` of forces, or of the inputs of
/// `gsa`. Rules between fields aren't in it: a document that fits its schema may still have faults.
#[utoipa::path(get, path = "/v1/schemas/{name}", tag = "service",
    params(("name" = String, Path, description = "study, scene, sweep, recipe or gsa", example = "study")),
    responses((status = 200, description = "The schema", content_type = "application/schema+json", body = Object, example = json!({"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "strainsite study"}))))]
async fn schema(DocumentName(name): DocumentName) -> Result<Response, Problem> {
    let kind = DocumentKind::named(&name).ok_or_else(|| {
        let names = alternatives(DocumentKind::ALL.map(DocumentKind::as_str));
        Problem::not_found(format!("there is no schema {name:?}; there are {names}"))
    })?;
    let media = [(CONTENT_TYPE, "application/schema+json")];
    Ok((media, kind.schema().to_string()).into_response())
}
