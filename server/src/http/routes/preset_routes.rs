//! Studies and scenes to start from: the documents that ship.

use axum::Json;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use service::study_document::shipped::shipped;
use service::wire::examples;
use service::wire::study_wire::Presets;

/// `/v1/presets`.
pub fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(presets))
}

/// List the shipped documents
///
/// Studies and scenes to start from, to show, to change and to submit.
#[utoipa::path(get, path = "/v1/presets", tag = "service",
    responses((status = 200, description = "The documents", body = Presets, example = json!({"studies": [examples::preset()], "scenes": []}))))]
async fn presets() -> Json<Presets> {
    Json(shipped())
}
