//! Lets a browser in, once for each address.

use std::time::Instant;

use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::{Extension, Json};
use serde::Deserialize;
use service::wire::examples;
use service::wire::study_wire::{LoginLink, ProblemDocument};
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::extract::Params;
use crate::http::edge::problem_document::Problem;
use crate::http::mount::Mount;

/// `/login`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(login, invite))
}

#[derive(Deserialize)]
struct LoginQuery {
    once: Option<String>,
}

/// Let a browser in
///
/// The address that the service prints at its start, or that `POST /login` answers with. It works once and for ten minutes: the browser gets a cookie and is sent to the
/// dashboard.
#[utoipa::path(get, path = "/login", tag = "service", security(()),
    params(("once" = Option<String>, Query, description = "The secret of the address", example = "af5570f5a1810b7af78caf4bc70a660f")),
    responses((status = 303, description = "The browser is in", headers(("Location" = String, description = "The dashboard"), ("Set-Cookie" = String, description = "Cookie that lets it in from now on"))),
              (status = 401, description = "The address was used, is older than ten minutes, or was never given", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::locked())),
              (status = 404, description = "This service asks for no token", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn login(
    State(state): State<AppState>,
    Extension(mount): Extension<Mount>,
    headers: HeaderMap,
    Params(query): Params<LoginQuery>,
) -> Result<Response, Problem> {
    let keys = state.access.keys().ok_or_else(no_token)?;
    let dashboard = (header::LOCATION, "/".to_owned());
    // Browsers open some addresses twice, the first time to be quick.
    if state.access.admits(&headers) {
        return Ok((StatusCode::SEE_OTHER, [dashboard]).into_response());
    }
    if !query
        .once
        .is_some_and(|said| keys.redeem(&said, Instant::now()))
    {
        let detail = "this address works once and for ten minutes, and was used, is too old, or was replaced by a newer one: POST /login with the token gives another";
        return Err(Problem::new(StatusCode::UNAUTHORIZED, detail));
    }
    let headers = [
        dashboard,
        (header::SET_COOKIE, keys.set_cookie(&mount)),
        (header::CACHE_CONTROL, "no-store".to_owned()),
    ];
    Ok((StatusCode::SEE_OTHER, headers).into_response())
}

/// Get an address for another browser
///
/// It lets one browser in, once and within ten minutes, without the token; the one before works no more.
#[utoipa::path(post, path = "/login", tag = "service",
    responses((status = 201, description = "The address", body = LoginLink, example = json!({"path": "/login?once=af5570f5a1810b7af78caf4bc70a660f"})),
              (status = 404, description = "This service asks for no token", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn invite(
    State(state): State<AppState>,
    Extension(mount): Extension<Mount>,
) -> Result<Response, Problem> {
    let link = state
        .access
        .link()
        .map_err(|error| Problem::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()))?;
    let path = mount.address(&link.ok_or_else(no_token)?);
    let headers = [(header::CACHE_CONTROL, "no-store")];
    Ok((StatusCode::CREATED, headers, Json(LoginLink { path })).into_response())
}

fn no_token() -> Problem {
    Problem::not_found("this service asks for no token: every browser on this machine is in")
}
