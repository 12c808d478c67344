//! Engines that solve designs of sweeps on other machines, and what they are at.

use axum::extract::State;
use axum::http::{HeaderMap, StatusCode};
use axum::response::Response;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::conditional;
use crate::http::edge::problem_document::Problem;
use tasks::away::away_report::EngineList;
use tasks::away::{Away, Unwilling};

/// `/v1/engines`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(list_engines))
}

/// List engines
///
/// Schedulers and commands that the service was started with, with their tasks: those that wait, run and have ended, nodes that handed in nothing, and why. A sweep
/// is given to one by `POST /v1/sweeps?engine=NAME`.
#[utoipa::path(get, path = "/v1/engines", tag = "service",
    params(("If-None-Match" = Option<String>, Header, description = "ETag of the list that the client has")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The engines", body = EngineList)))]
async fn list_engines(
    State(state): State<AppState>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    conditional::json(&headers, &state.away.list().await?)
}

/// Asks an engine whether it would take a sweep, where one is named.
pub(crate) async fn willing(
    away: &Away,
    engine: Option<&str>,
) -> Result<Option<&'static str>, Problem> {
    let Some(name) = engine else {
        return Ok(None);
    };
    match away.willing(name).await {
        Ok(name) => Ok(Some(name.as_str())),
        Err(error @ Unwilling::Unknown(_)) => {
            let detail = error.to_string();
            Err(Problem::new(StatusCode::UNPROCESSABLE_ENTITY, detail))
        }
        Err(error) => Err(Problem::new(
            StatusCode::SERVICE_UNAVAILABLE,
            error.to_string(),
        )),
    }
}
