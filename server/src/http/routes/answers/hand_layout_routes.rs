//! Layouts that somebody moves by hand, scored from what a study has stored: nothing is solved for them.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode};
use axum::response::Response;
use placement::layout::by_hand::film_fields::FilmFields;
use placement::layout::by_hand::hand_layout_reader;
use placement::layout::by_hand::scored_by_hand::HandError;
use results::LayoutFindings;
use serde::Deserialize;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::answer_limits::Making;
use crate::http::edge::conditional::{has, tagged};
use crate::http::edge::document_body::Document;
use crate::http::edge::extract::{StudyId, StudyPath};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::answers::result_routes::{hashed_part, part};
use crate::http::routes::study_routes::known;
use service::study_document::stored_study;
use service::views::hand_layouts::{self, HandLayoutsError};
use service::wire::examples;
use service::wire::layout_wire::{HandLayoutsDocument, ScoredLayouts};
use service::wire::study_wire::ProblemDocument;

/// `/v1/studies/{id}/layouts:score` and `/layouts/fields`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(score))
        .routes(routes!(fields))
}

/// Part of a result on its layouts.
#[derive(Deserialize)]
struct Found {
    layout_findings: Option<LayoutFindings>,
}

/// Score layouts of your own
///
/// Scores any layouts of the kinds of film that a finished study has stored, film by film, as it scored its own: bounds at every load, each with
/// the error that the coarser mesh shows; with `simulated` also errors of estimates from noisy readings, a second of a core for each layout. Nothing is solved or stored. They are in the order of the request, `rank` is the place in it, and `dead` is left out.
#[utoipa::path(post, path = "/v1/studies/{id}/layouts:score", tag = "answers", params(StudyPath),
    request_body(description = "1 to 50 layouts of 1 to 96 films each, as JSON or TOML", content(
        (HandLayoutsDocument = "application/json", example = json!(examples::hand_layouts())),
        (String = "application/toml", example = json!(examples::hand_layouts_toml())))),
    responses(
        (status = 200, description = "The scores", body = ScoredLayouts),
        (status = 404, description = "There is no such study, or it isn't done yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
        (status = 409, description = "The study asked for no layouts, or their solves are no longer stored", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::no_layouts())),
        (status = 422, description = "The document has faults, all of them with their JSON pointers; a film of a kind that isn't stored is one", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
async fn score(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    document: Document,
) -> Result<Json<ScoredLayouts>, Problem> {
    let Found { layout_findings } = part(&state.store, &id).await?;
    let row = known(&state.store, &id).await?;
    if layout_findings.is_none() {
        return Err(HandLayoutsError::from(HandError::NoLayouts).into());
    }
    let study = stored_study(&row).map_err(|cause| HandLayoutsError::Unreadable { cause })?;
    let asked = document.checked(move |value| hand_layout_reader::hand_layouts(value, &study));
    let asked = asked.await?;
    let _making = state.answers.make().await?;
    let solver = Arc::clone(&state.engine.solver);
    let work = hand_layouts::of(
        &state.store,
        &row,
        layout_findings,
        solver,
        move |stored, stop| stored.scores(&asked, stop),
    );
    Ok(Json(ScoredLayouts {
        layouts: work.await?,
    }))
}

/// Get the fields that layouts are scored by
///
/// What every kind of film that the study has stored reads around the wheel at every load, in full precision, and the noise: the bounds of a layout follow from it to
/// the last digits. With `u` the angle from the contact to a film, between whole degrees a cubic goes through values and slopes, which are central differences of fourth
/// order.
#[utoipa::path(get, path = "/v1/studies/{id}/layouts/fields", tag = "answers",
    params(StudyPath, ("If-None-Match" = Option<String>, Header, description = "ETag of the fields that the client has")),
    responses(
        (status = 304, description = "The client has it"),
        (status = 200, description = "The fields", body = FilmFields),
        (status = 404, description = "There is no such study, or it isn't done yet; the detail says which", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
        (status = 409, description = "The study asked for no layouts, or their solves are no longer stored", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::no_layouts()))))]
async fn fields(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    headers: HeaderMap,
    _making: Making,
) -> Result<Response, Problem> {
    let (Found { layout_findings }, content_sha256) = hashed_part(&state.store, &id).await?;
    let tag = format!("{content_sha256}-film-fields");
    if has(&headers, &tag) {
        return Ok(tagged(&headers, &tag, "no-cache", ()));
    }
    let row = known(&state.store, &id).await?;
    let solver = Arc::clone(&state.engine.solver);
    let work = hand_layouts::of(&state.store, &row, layout_findings, solver, |stored, _| {
        Some(stored.fields())
    });
    Ok(tagged(&headers, &tag, "no-cache", Json(work.await?)))
}

impl From<HandLayoutsError> for Problem {
    fn from(error: HandLayoutsError) -> Self {
        let status = match error {
            HandLayoutsError::Store(error) => return error.into(),
            HandLayoutsError::Lacking(HandError::Stopped) => StatusCode::SERVICE_UNAVAILABLE,
            HandLayoutsError::Lacking(_) => StatusCode::CONFLICT,
            HandLayoutsError::Unreadable { .. } | HandLayoutsError::Broken => {
                StatusCode::INTERNAL_SERVER_ERROR
            }
        };
        Self::new(status, error.to_string())
    }
}
