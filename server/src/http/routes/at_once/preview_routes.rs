//! A document's places and layouts at once, while somebody writes it.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use documents::study::plan::Estimable;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::document_body::EstimateBody;
use crate::http::edge::problem_document::Problem;
use service::at_once::previewer::PreviewError;
use service::wire::examples;
use service::wire::preview_wire::Preview;
use service::wire::study_wire::{ProblemDocument, StudyDocument};

/// `/v1/studies:preview`.
pub(super) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(preview))
}

/// Preview a study
///
/// Solves the document's points on the draft mesh at once, ranks the places and answers with a layout at the load in the middle: figures without a claim, for somebody who is still writing. Nothing is queued or stored.
/// One preview is solved at a time in the whole service: a newer one ends the one before, whose client is told so (409). A client that goes away ends its own.
#[utoipa::path(post, path = "/v1/studies:preview", tag = "studies",
    request_body(description = "A study, as JSON or TOML", content(
        (StudyDocument = "application/json", example = json!(examples::study())),
        (String = "application/toml", example = json!(examples::study_toml())))),
    responses(
        (status = 200, description = "The preview", body = Preview),
        (status = 409, description = "A newer preview was asked for", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::superseded())),
        (status = 422, description = "The document has faults, all of them with their JSON pointers; or it asks for too many points; or its loads have no equilibrium",
            body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults())),
        (status = 503, description = "It took longer than 10 s, or the service is stopping", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unready()))))]
async fn preview(
    State(state): State<AppState>,
    EstimateBody { study }: EstimateBody,
) -> Result<Json<Preview>, Problem> {
    let study = match study {
        Estimable::Planned(planned) => planned.study,
        Estimable::Counted(study) => study,
    };
    Ok(Json(state.previewer.preview(&study).await?))
}

impl From<PreviewError> for Problem {
    fn from(error: PreviewError) -> Self {
        let status = match error {
            PreviewError::TooLarge { .. }
            | PreviewError::Plan(_)
            | PreviewError::Unsolved { .. } => StatusCode::UNPROCESSABLE_ENTITY,
            PreviewError::Superseded => StatusCode::CONFLICT,
            PreviewError::OverTime { .. } | PreviewError::Stopping => {
                StatusCode::SERVICE_UNAVAILABLE
            }
            PreviewError::Broken => StatusCode::INTERNAL_SERVER_ERROR,
        };
        Self::new(status, error.to_string())
    }
}
