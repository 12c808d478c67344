//! Equilibrium of a scene, solved at once.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::document_body::SceneBody;
use crate::http::edge::problem_document::Problem;
use service::at_once::scene_solver::SceneError;
use service::wire::examples;
use service::wire::scene_wire::{SceneQuestionDocument, SolvedScene};
use service::wire::study_wire::ProblemDocument;

/// `/v1/scenes:solve`.
pub(super) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(solve_scene))
}

/// Solve a scene
///
/// One equilibrium: reaction, strains at P1, P2, ... and at gauges of your own, the film, and derivatives of all of it by numbers of the scene, as `strainsite solve --json` writes them. Nothing is queued or stored.
/// One scene is solved at a time in the whole service, in the order in which they come, beside the studies. A client that goes away ends its own.
#[utoipa::path(post, path = "/v1/scenes:solve", tag = "scenes",
    request_body(description = "A scene and what is read of it, as JSON or TOML", content(
        (SceneQuestionDocument = "application/json", example = json!(examples::scene_question())),
        (String = "application/toml", example = json!(examples::scene_question_toml())))),
    responses(
        (status = 200, description = "The equilibrium", body = SolvedScene),
        (status = 422, description = "The document has faults, all of them with their JSON pointers; or its loads have no equilibrium; or it would take more memory than there is",
            body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults())),
        (status = 503, description = "It took longer than 80 s, or the service is stopping", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unready()))))]
async fn solve_scene(
    State(state): State<AppState>,
    SceneBody { question }: SceneBody,
) -> Result<Json<SolvedScene>, Problem> {
    Ok(Json(state.scenes.solve(question).await?))
}

impl From<SceneError> for Problem {
    fn from(error: SceneError) -> Self {
        let status = match error {
            SceneError::Refused { faults } => return Self::faults(faults),
            SceneError::TooLarge { .. } | SceneError::NoEquilibrium { .. } => {
                StatusCode::UNPROCESSABLE_ENTITY
            }
            SceneError::OverTime { .. } | SceneError::Stopping => StatusCode::SERVICE_UNAVAILABLE,
            SceneError::Broken => StatusCode::INTERNAL_SERVER_ERROR,
        };
        Self::new(status, error.to_string())
    }
}
