//! Estimate, submit, list, look at and cancel studies.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use results::Estimate;
use serde::Deserialize;
use serde_json::Value;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::conditional;
use crate::http::edge::document_body::{Document, EstimateBody, StudyBody};
use crate::http::edge::extract::{Params, RemovalQuery, StudyId, StudyPath};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::entry_list::PageQuery;
use service::forecast::{ForecastError, admit, forecast_of};
use service::queue::SubmitError;
use service::wire::entry_change::{self, EntryChange, read_change};
use service::wire::examples;
use service::wire::study_wire::{
    ProblemDocument, StudyDetail, StudyDocument, StudyPage, StudySummary,
};
use store::Store;
use store::answers::result_rows;
use store::answers::trades;
use store::queue::design_rows;
use store::queue::study_rows::{self, Filter, State as StudyState, StudyRow};

/// `/v1/studies` and `/v1/studies/{id}`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(list, submit))
        .routes(routes!(show, cancel, change))
        .routes(routes!(estimate))
}

/// Submit a study
///
/// Takes the document in and answers at once; the study waits for its turn. The same document sent again under the same `Idempotency-Key` finds the same
/// study. Points that any study solved before are shared, not solved again.
#[utoipa::path(post, path = "/v1/studies", tag = "studies",
    params(
        ("priority" = Option<i64>, Query, description = "Studies of higher priority go first, those of the same in turns; 0 when left out", minimum = -100, maximum = 100, example = 10),
        ("Idempotency-Key" = Option<String>, Header, description = "1 to 255 visible ASCII characters that stand for this submission", example = "night-run-17")),
    request_body(description = "A study, as JSON or TOML", content(
        (StudyDocument = "application/json", example = json!(examples::study())),
        (String = "application/toml", example = json!(examples::study_toml())))),
    responses(
        (status = 202, description = "Taken in; `Location` says where to look", body = StudySummary, headers(("Location" = String, description = "Address of the study"), ("Retry-After" = String, description = "Seconds after which to look")),
            links(
                ("study" = (operation_id = "show", parameters(("id" = "$response.body#/id")))),
                ("cancel" = (operation_id = "cancel", parameters(("id" = "$response.body#/id")))),
                ("events" = (operation_id = "follow", parameters(("id" = "$response.body#/id")))),
                ("result" = (operation_id = "whole", parameters(("id" = "$response.body#/id")))),
                ("evaluations" = (operation_id = "evaluations", parameters(("id" = "$response.body#/id"))))
            )),
        (status = 429, description = "Too many studies wait already; `Retry-After` says when to look again", body = ProblemDocument, content_type = "application/problem+json",
            headers(("Retry-After" = String, description = "Seconds after which to try again")), example = json!(examples::crowded())),
        (status = 422, description = "The document has faults: all of them, each with its JSON pointer; or it would take more memory than there is; or the key stands for another document",
            body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
async fn submit(
    State(state): State<AppState>,
    Params(query): Params<SubmitQuery>,
    headers: HeaderMap,
    body: StudyBody,
) -> Result<Response, Problem> {
    let key = idempotency_key(&headers)?;
    let priority = priority(query.priority.as_deref())?;
    let engine = &state.engine;
    let admitted = admit(
        &engine.solver,
        engine.threads,
        state.memory_bytes,
        &body.planned,
    )
    .await;
    admitted.map_err(refused)?;
    let id = state
        .queue
        .submit(&body.planned.study, priority, key)
        .await
        .map_err(unsubmitted)?;
    tracing::info!(study = id, name = ?body.planned.study.name, "study accepted");
    let study = known(&state.store, &id).await?;
    Ok(accepted(&study))
}

/// Converts the reason why something was not taken in.
pub(super) fn unsubmitted(error: SubmitError) -> Problem {
    match error {
        SubmitError::KeyTaken => Problem::new(
            StatusCode::UNPROCESSABLE_ENTITY,
            "this Idempotency-Key was used with another document",
        ),
        SubmitError::TooMany { .. } => {
            Problem::new(StatusCode::TOO_MANY_REQUESTS, error.to_string())
        }
        SubmitError::TooManyDesigns(_) => {
            Problem::new(StatusCode::UNPROCESSABLE_ENTITY, error.to_string())
        }
        SubmitError::Broken => Problem::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()),
        SubmitError::Store(error) => error.into(),
    }
}

/// Query of a submission.
#[derive(Deserialize)]
pub(super) struct SubmitQuery {
    pub priority: Option<String>,
}

pub(super) fn priority(text: Option<&str>) -> Result<i64, Problem> {
    let number = text.map_or(Some(0), |text| text.parse().ok());
    let in_range = number.filter(|number| (-100..=100).contains(number));
    in_range.ok_or_else(|| {
        let detail = "priority is a whole number from -100 to 100";
        Problem::new(StatusCode::BAD_REQUEST, detail)
    })
}

/// A key is 1 to 255 visible ASCII characters.
pub(super) fn idempotency_key(headers: &HeaderMap) -> Result<Option<&str>, Problem> {
    let Some(value) = headers.get("idempotency-key") else {
        return Ok(None);
    };
    let fits = |key: &&str| {
        (1..=255).contains(&key.len()) && key.chars().all(|c| c.is_ascii_graphic() || c == ' ')
    };
    let wrong = || {
        Problem::new(
            StatusCode::BAD_REQUEST,
            "an Idempotency-Key is 1 to 255 visible ASCII characters",
        )
    };
    value.to_str().ok().filter(fits).map(Some).ok_or_else(wrong)
}

fn accepted(study: &StudyRow) -> Response {
    let location = format!("/v1/studies/{}", study.id);
    let headers = [
        (header::LOCATION, location),
        (header::RETRY_AFTER, "1".to_owned()),
    ];
    (StatusCode::ACCEPTED, headers, Json(StudySummary::of(study))).into_response()
}

/// List studies
///
/// Newest first, a page at a time.
#[utoipa::path(get, path = "/v1/studies", tag = "studies",
    params(
        ("If-None-Match" = Option<String>, Header, description = "ETag of the page that the client has"),
        ("limit" = Option<u32>, Query, description = "Studies of a page, 50 when left out", minimum = 1, maximum = 200, example = 20),
        ("cursor" = Option<String>, Query, description = "`next_cursor` of the page before", example = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b"),
        ("search" = Option<String>, Query, description = "Studies whose name has this, whatever the case of ASCII letters, or whose identifier begins so", max_length = 200, example = "two depths"),
        ("archived" = Option<String>, Query, description = "`true`: archived ones alone; `all`: those, too; when left out, or `false`, they aren't listed", pattern = "^(true|false|all)$", example = "all"),
        ("state" = Option<StudyState>, Query, description = "Studies of this state alone"),
        ("sweep" = Option<String>, Query, description = "Designs of the sweep of this identifier alone; `none`: studies that are no design of any", example = "none")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "A page", body = StudyPage)))]
async fn list(
    State(state): State<AppState>,
    Params(query): Params<PageQuery>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let (limit, of_state) = (query.limit()?, query.of_state()?);
    let mut connection = state.store.read().await?;
    let filter = Filter {
        state: of_state,
        sweep: query.sweep.as_deref(),
        listed: query.listed()?,
    };
    let rows =
        study_rows::page(&mut connection, filter, query.cursor.as_deref(), limit + 1).await?;
    let page = rows.get(..limit as usize).unwrap_or(&rows);
    let next = page
        .last()
        .filter(|_| rows.len() > page.len())
        .map(|row| &row.id);
    let page = StudyPage {
        studies: page.iter().map(StudySummary::of).collect(),
        next_cursor: next.cloned(),
    };
    conditional::json(&headers, &page)
}

/// Look at a study
///
/// Its state, its progress, its document, and what it is expected to take.
#[utoipa::path(get, path = "/v1/studies/{id}", tag = "studies",
    params(StudyPath, ("If-None-Match" = Option<String>, Header, description = "ETag of the study as the client has it")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The study", body = StudyDetail),
              (status = 404, description = "There is no such study", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn show(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let study = known(&state.store, &id).await?;
    let estimate = study.estimate.as_deref().map(serde_json::from_str);
    let mut connection = state.store.read().await?;
    let detail = StudyDetail {
        summary: StudySummary::of(&study),
        document: serde_json::from_str(study.document()?).unwrap_or(Value::Null),
        estimate: estimate.and_then(Result::ok),
        result_sha256: result_rows::sha256_of(&mut connection, &id).await?,
        trade_measured: trades::is_measured(&mut connection, &study.spec_sha256).await?,
        sweep: design_rows::of_study(&mut connection, &id).await?,
    };
    conditional::json(&headers, &detail)
}

/// Rename or archive a study
///
/// Changes what lists say of it; its document, hash and result stay as they were submitted. Lists leave out what is archived unless asked. The same change
/// again changes nothing.
#[utoipa::path(patch, path = "/v1/studies/{id}", tag = "studies", params(StudyPath),
    request_body(description = "The change, as JSON or TOML", content(
        (EntryChange = "application/json", example = json!(entry_change::example())),
        (String = "application/toml", example = json!("archived = true\n")))),
    responses((status = 200, description = "Changed", body = StudySummary),
              (status = 404, description = "There is no such study", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
              (status = 422, description = "The change has faults: all of them, each with its JSON pointer", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
async fn change(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    document: Document,
) -> Result<Json<StudySummary>, Problem> {
    known(&state.store, &id).await?;
    let change = document.checked(read_change).await?;
    let mut transaction = state.store.begin().await?;
    study_rows::change(&mut transaction, &id, &change).await?;
    state.store.commit(transaction, 0).await?;
    let study = known(&state.store, &id).await?;
    Ok(Json(StudySummary::of(&study)))
}

/// Estimate a study
///
/// What the document would cost, before anything is solved: solves, time, memory, and the accuracy to expect. Nothing is stored. What the database has
/// already costs nothing, and the times of its solves correct the estimate for this machine.
#[utoipa::path(post, path = "/v1/studies:estimate", tag = "studies",
    request_body(description = "A study, as JSON or TOML", content(
        (StudyDocument = "application/json", example = json!(examples::study())),
        (String = "application/toml", example = json!(examples::study_toml())))),
    responses(
        (status = 200, description = "The estimate", body = Estimate),
        (status = 422, description = "The document has faults: all of them, each with its JSON pointer",
            body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
async fn estimate(
    State(state): State<AppState>,
    EstimateBody { study }: EstimateBody,
) -> Result<Json<Estimate>, Problem> {
    let engine = &state.engine;
    let estimate = forecast_of(&state.store, &engine.solver, engine.threads, study).await;
    estimate.map(Json).map_err(refused)
}

/// A study that can't be planned, or would take too much.
pub(super) fn refused(error: ForecastError) -> Problem {
    match error {
        ForecastError::Plan(_) | ForecastError::Memory { .. } => {
            Problem::new(StatusCode::UNPROCESSABLE_ENTITY, error.to_string())
        }
        ForecastError::Store(error) => error.into(),
        ForecastError::Broken => Problem::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()),
    }
}

/// Cancel or remove a study
///
/// One that runs ends within a Newton iteration; what it has solved is kept. Cancelling what has ended changes nothing and is no error. With `purge` the study
/// is removed, with its result, its events and the points that no other study has: nothing brings it back.
#[utoipa::path(delete, path = "/v1/studies/{id}", tag = "studies", params(StudyPath, RemovalQuery),
    responses((status = 202, description = "Cancelled, or ended before", body = StudySummary, headers(("Location" = String, description = "Address of the study"), ("Retry-After" = String, description = "Seconds after which to look"))),
              (status = 204, description = "Removed"),
              (status = 409, description = "It is a design of a sweep, with which it can be removed", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::design())),
              (status = 404, description = "There is no such study", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent()))))]
async fn cancel(
    State(state): State<AppState>,
    StudyId(id): StudyId,
    Params(query): Params<RemovalQuery>,
) -> Result<Response, Problem> {
    known(&state.store, &id).await?;
    if query.removes()? {
        state.queue.remove(&id).await?;
        tracing::info!(study = id, "study removed");
        return Ok(StatusCode::NO_CONTENT.into_response());
    }
    state.queue.cancel(&id).await?;
    Ok(accepted(&known(&state.store, &id).await?))
}

/// The study of this identifier, or 404.
pub async fn known(store: &Store, id: &str) -> Result<StudyRow, Problem> {
    let mut connection = store.read().await?;
    let study = study_rows::find(&mut connection, id).await?;
    study.ok_or_else(|| Problem::not_found(format!("there is no study {id:?}")))
}
