//! Submit, list, look at, cancel and remove estimators.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::conditional;
use crate::http::edge::extract::{EstimatorId, EstimatorPath, Params, RemovalQuery};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::entry_list::PageQuery;
use crate::http::routes::estimators::stored_estimator::{known, zero_of};
use crate::http::routes::long_body::LongBody;
use crate::http::routes::study_routes::idempotency_key;
use service::forces::estimator_queue::UntakenError;
use service::forces::submission_reader::{FitLimits, read_submission};
use service::wire::estimator_examples as examples;
use service::wire::estimator_wire::{
    EstimatorDetail, EstimatorDocument, EstimatorPage, EstimatorSummary,
};
use service::wire::study_wire::ProblemDocument;
use store::queue::estimator_rows::{self, EstimatorRow};
use store::queue::study_rows::State as StudyState;

/// `/v1/estimators` and `/v1/estimators/{id}`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(list_estimators, submit_estimator))
        .routes(routes!(show_estimator, cancel_estimator))
}

/// Submit recordings
///
/// Takes recordings in that an estimator of forces is learnt from, one a run, and answers at once; it waits for its turn beside the studies. Every model is judged on rows
/// that it didn't learn from, and the best is kept. The same document sent again under the same `Idempotency-Key` finds the same estimator. The whole document has at most
/// 64 MiB.
#[utoipa::path(post, path = "/v1/estimators", tag = "estimators",
    params(("Idempotency-Key" = Option<String>, Header, description = "1 to 255 visible ASCII characters that stand for this submission", example = "rig-week-47")),
    request_body(description = "Recordings, with a recipe where the defaults won't do", content((EstimatorDocument = "application/json", example = json!(examples::document())))),
    responses(
        (status = 202, description = "Taken in; `Location` says where to look", body = EstimatorSummary, headers(("Location" = String, description = "Address of the estimator"), ("Retry-After" = String, description = "Seconds after which to look")),
            links(
                ("estimator" = (operation_id = "show_estimator", parameters(("id" = "$response.body#/id")))),
                ("cancel" = (operation_id = "cancel_estimator", parameters(("id" = "$response.body#/id")))),
                ("report" = (operation_id = "estimator_report", parameters(("id" = "$response.body#/id")))),
                ("model" = (operation_id = "estimator_model", parameters(("id" = "$response.body#/id")))),
                ("left-out" = (operation_id = "estimator_left_out", parameters(("id" = "$response.body#/id")))),
                ("apply" = (operation_id = "apply_estimator", parameters(("id" = "$response.body#/id")))),
                ("zero" = (operation_id = "zero_estimator", parameters(("id" = "$response.body#/id"))))
            )),
        (status = 413, description = "The document has more than 64 MiB", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::too_large())),
        (status = 429, description = "Too many estimators wait already; `Retry-After` says when to look again", body = ProblemDocument, content_type = "application/problem+json",
            headers(("Retry-After" = String, description = "Seconds after which to try again")), example = json!(examples::crowded())),
        (status = 422, description = "The document has faults: all of them, each with its JSON pointer, those of recordings with file, line and column; or learning would take more memory than there is; or the key stands for another document",
            body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
async fn submit_estimator(
    State(state): State<AppState>,
    headers: HeaderMap,
    body: LongBody,
) -> Result<Response, Problem> {
    let key = idempotency_key(&headers)?;
    let limits = FitLimits {
        threads: state.engine.threads,
        memory_bytes: state.memory_bytes,
    };
    let (submission, _held) = body
        .checked(move |document| read_submission(document, limits))
        .await?;
    let id = state.estimators.submit(&submission, key).await?;
    tracing::info!(estimator = id, name = ?submission.name, "estimator accepted");
    accepted(&state, &id).await
}

async fn accepted(state: &AppState, id: &str) -> Result<Response, Problem> {
    let headers = [
        (header::LOCATION, format!("/v1/estimators/{id}")),
        (header::RETRY_AFTER, "1".to_owned()),
    ];
    let row = known(&state.store, id).await?;
    let EstimatorDetail { summary, .. } = state.estimators.detail(&row)?;
    Ok((StatusCode::ACCEPTED, headers, Json(summary)).into_response())
}

/// List estimators
///
/// Newest first, a page at a time.
#[utoipa::path(get, path = "/v1/estimators", tag = "estimators",
    params(
        ("If-None-Match" = Option<String>, Header, description = "ETag of the page that the client has"),
        ("limit" = Option<u32>, Query, description = "Estimators of a page, 50 when left out", minimum = 1, maximum = 200, example = 20),
        ("cursor" = Option<String>, Query, description = "`next_cursor` of the page before", example = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6d"),
        ("search" = Option<String>, Query, description = "Estimators whose name has this, whatever the case of ASCII letters, or whose identifier begins so", max_length = 200, example = "rig"),
        ("state" = Option<StudyState>, Query, description = "Estimators of this state alone")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "A page", body = EstimatorPage)))]
async fn list_estimators(
    State(state): State<AppState>,
    Params(query): Params<PageQuery>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let (limit, of_state, listed) = (query.limit()?, query.of_state()?, query.listed()?);
    let mut connection = state.store.read().await?;
    let filter = (of_state, listed.search);
    let cursor = query.cursor.as_deref();
    let rows = estimator_rows::page(&mut connection, filter, cursor, limit + 1).await?;
    drop(connection);
    let page = rows.get(..limit as usize).unwrap_or(&rows);
    let next = page.last().filter(|_| rows.len() > page.len());
    let summary = |row: &EstimatorRow| -> Result<EstimatorSummary, Problem> {
        Ok(state.estimators.detail(row)?.summary)
    };
    let page = EstimatorPage {
        estimators: page.iter().map(summary).collect::<Result<_, _>>()?,
        next_cursor: next.map(|row| row.id.clone()),
    };
    conditional::json(&headers, &page)
}

/// Look at an estimator
///
/// Its state, how far it is, its recipe and what it is learnt from.
#[utoipa::path(get, path = "/v1/estimators/{id}", tag = "estimators",
    params(EstimatorPath, ("If-None-Match" = Option<String>, Header, description = "ETag of the estimator as the client has it")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The estimator", body = EstimatorDetail),
              (status = 404, description = "There is no such estimator", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn show_estimator(
    State(state): State<AppState>,
    EstimatorId(id): EstimatorId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let row = known(&state.store, &id).await?;
    let mut detail = state.estimators.detail(&row)?;
    detail.zero = zero_of(&state.store, &id).await?;
    conditional::json(&headers, &detail)
}

/// Cancel or remove an estimator
///
/// The process of one that is being learnt ends at once. Cancelling what has ended changes nothing and is no error. With `purge` the estimator is removed, with
/// its recordings and what was learnt: nothing brings it back.
#[utoipa::path(delete, path = "/v1/estimators/{id}", tag = "estimators", params(EstimatorPath, RemovalQuery),
    responses((status = 202, description = "Cancelled, or ended before", body = EstimatorSummary, headers(("Location" = String, description = "Address of the estimator"), ("Retry-After" = String, description = "Seconds after which to look"))),
              (status = 204, description = "Removed"),
              (status = 404, description = "There is no such estimator", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn cancel_estimator(
    State(state): State<AppState>,
    EstimatorId(id): EstimatorId,
    Params(query): Params<RemovalQuery>,
) -> Result<Response, Problem> {
    known(&state.store, &id).await?;
    if query.removes()? {
        state.estimators.remove(&id).await?;
        tracing::info!(estimator = id, "estimator removed");
        return Ok(StatusCode::NO_CONTENT.into_response());
    }
    state.estimators.cancel(&id).await?;
    accepted(&state, &id).await
}

impl From<UntakenError> for Problem {
    fn from(error: UntakenError) -> Self {
        let status = match error {
            UntakenError::KeyTaken => StatusCode::UNPROCESSABLE_ENTITY,
            UntakenError::TooMany => StatusCode::TOO_MANY_REQUESTS,
            UntakenError::Store(error) => return error.into(),
        };
        Self::new(status, error.to_string())
    }
}
