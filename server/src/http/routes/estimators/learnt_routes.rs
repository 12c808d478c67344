//! Results of learning from recordings: report, model, rows that were left out.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::extract::State;
use axum::http::{HeaderMap, header};
use axum::response::Response;
use estimation::fit_report::Report;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::answer_limits::Making;
use crate::http::edge::conditional::{has, tagged};
use crate::http::edge::extract::{EstimatorId, EstimatorPath};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::estimators::stored_estimator::{ready, text};
use service::wire::estimator_examples as examples;
use service::wire::estimator_wire::LeftOutForces;
use service::wire::study_wire::ProblemDocument;
use store::Store;
use store::queue::estimator_parts::Part;

/// Returns the routes below `/v1/estimators/{id}`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(estimator_report))
        .routes(routes!(estimator_model))
        .routes(routes!(estimator_left_out))
}

/// Get the report
///
/// What the validation found: each model's error on rows that it didn't learn from, on every split, with what chance would do, what the intervals promise, and what a reader
/// should know before believing it.
#[utoipa::path(get, path = "/v1/estimators/{id}/report", tag = "estimators",
    params(EstimatorPath, ("If-None-Match" = Option<String>, Header, description = "ETag of the report that the client has")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The report", body = Report),
              (status = 404, description = "There is no such estimator", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
              (status = 409, description = "It isn't done; the detail says what became of it", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unlearnt()))))]
async fn estimator_report(
    State(state): State<AppState>,
    EstimatorId(id): EstimatorId,
    headers: HeaderMap,
    _making: Making,
) -> Result<Response, Problem> {
    sent(&state.store, &id, Part::Report, &headers).await
}

/// Get the model
///
/// The model file, for `strainsite force apply`: data in one line of JSON, versioned.
#[utoipa::path(get, path = "/v1/estimators/{id}/model", tag = "estimators",
    params(EstimatorPath, ("If-None-Match" = Option<String>, Header, description = "ETag of the model that the client has")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The model", content_type = "application/json", body = Object, example = json!(examples::model())),
              (status = 404, description = "There is no such estimator", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
              (status = 409, description = "It isn't done; the detail says what became of it", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unlearnt()))))]
async fn estimator_model(
    State(state): State<AppState>,
    EstimatorId(id): EstimatorId,
    headers: HeaderMap,
    _making: Making,
) -> Result<Response, Problem> {
    sent(&state.store, &id, Part::Model, &headers).await
}

/// Get the rows that weren't learnt from
///
/// What was measured, what the chosen model of each force said of it without having learnt from it, and the interval, for plots. Of more than 20 000 rows of a force an even
/// subset of so many.
#[utoipa::path(get, path = "/v1/estimators/{id}/left-out", tag = "estimators",
    params(EstimatorPath, ("If-None-Match" = Option<String>, Header, description = "ETag of the rows that the client has")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The rows", body = LeftOutForces),
              (status = 404, description = "There is no such estimator", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
              (status = 409, description = "It isn't done; the detail says what became of it", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unlearnt()))))]
async fn estimator_left_out(
    State(state): State<AppState>,
    EstimatorId(id): EstimatorId,
    headers: HeaderMap,
    _making: Making,
) -> Result<Response, Problem> {
    sent(&state.store, &id, Part::LeftOut, &headers).await
}

/// A part of what was learnt as JSON, which never changes.
async fn sent(
    store: &Store,
    id: &str,
    part: Part,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    let tag = ready(store, id, part).await?;
    if has(headers, &tag) {
        return Ok(tagged(headers, &tag, "no-cache", ()));
    }
    let text = text(store, id, part).await?;
    let kind = [(header::CONTENT_TYPE, "application/json")];
    Ok(tagged(headers, &tag, "no-cache", (kind, text)))
}
