//! Estimate, submit, list, look at, extend, resume and cancel sweeps.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::ops::Range;

use axum::Json;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use documents::sweep::{Design, MOST_DESIGNS, MOST_SUBMITTED, designs_of};
use futures_util::{StreamExt, TryStreamExt, stream};
use placement::compare::MOST_TOLD;
use serde::Deserialize;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::conditional;
use crate::http::edge::document_body::{Document, SweepBody};
use crate::http::edge::extract::{Params, RemovalQuery, SweepId, SweepPath};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::entry_list::PageQuery;
use crate::http::routes::study_routes::{idempotency_key, priority, refused, unsubmitted};
use crate::http::routes::upkeep::engine_routes::willing;
use service::forecast::{admit, forecast_sweep, plan_study};
use service::study_document::stored_base;
use service::wire::entry_change::{self, EntryChange, read_change};
use service::wire::examples::{absent, crowded, faults, unknown_engine, unwilling};
use service::wire::study_wire::ProblemDocument;
use service::wire::sweep_examples as examples;
use service::wire::sweep_wire::{
    FurtherDesignsDocument, SweepDetail, SweepDocument, SweepEstimate, SweepPage, SweepSummary,
};
use store::Store;
use store::queue::design_rows;
use store::queue::sweep_rows::{self, SweepRow};

/// `/v1/sweeps` and what is below it.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(list_sweeps, submit_sweep))
        .routes(routes!(show_sweep, cancel_sweep, change_sweep))
        .routes(routes!(extend_sweep))
        .routes(routes!(resume_sweep))
        .routes(routes!(estimate_sweep))
}

/// Submit a sweep
///
/// One study and its designs: lists of values by path, or the designs one by one. Each design is a study in the queue; points that designs share are solved
/// once. The same document sent again under the same `Idempotency-Key` finds the same sweep.
#[utoipa::path(post, path = "/v1/sweeps", tag = "sweeps",
    params(
        ("priority" = Option<i64>, Query, description = "Priority of all its studies: those of a higher one go first, those of the same in turns; 0 when left out", minimum = -100, maximum = 100, example = 10),
        ("engine" = Option<String>, Query, description = "Engine of `GET /v1/engines` whose machines solve the designs; what they leave is solved here. The same answer, whoever solves", example = "slurm"),
        ("Idempotency-Key" = Option<String>, Header, description = "1 to 255 visible ASCII characters that stand for this submission", example = "walls-17")),
    request_body(description = "A sweep, as JSON or TOML", content(
        (SweepDocument = "application/json", example = json!(examples::document())),
        (String = "application/toml", example = json!(examples::document_toml())))),
    responses(
        (status = 202, description = "Taken in; `Location` says where to look", body = SweepDetail, headers(("Location" = String, description = "Address of the sweep"), ("Retry-After" = String, description = "Seconds after which to look")),
            links(
                ("sweep" = (operation_id = "show_sweep", parameters(("id" = "$response.body#/id")))),
                ("extend" = (operation_id = "extend_sweep", parameters(("id" = "$response.body#/id")))),
                ("resume" = (operation_id = "resume_sweep", parameters(("id" = "$response.body#/id")))),
                ("cancel" = (operation_id = "cancel_sweep", parameters(("id" = "$response.body#/id")))),
                ("comparison" = (operation_id = "compare", parameters(("sweep" = "$response.body#/id"))))
            )),
        (status = 429, description = "Too many studies would wait; `Retry-After` says when to look again", body = ProblemDocument, content_type = "application/problem+json",
            headers(("Retry-After" = String, description = "Seconds after which to try again")), example = json!(crowded())),
        (status = 422, description = "The document has faults: all of them, each with its JSON pointer; or a design would take more memory than there is; or the key stands for another document",
            body = ProblemDocument, content_type = "application/problem+json", example = json!(faults())),
        (status = 503, description = "The engine is missing, or refuses, in its own words", body = ProblemDocument, content_type = "application/problem+json", example = json!(unwilling()))))]
async fn submit_sweep(
    State(state): State<AppState>,
    Params(query): Params<SweepQuery>,
    headers: HeaderMap,
    SweepBody { sweep }: SweepBody,
) -> Result<Response, Problem> {
    let key = idempotency_key(&headers)?;
    let priority = priority(query.priority.as_deref())?;
    let engine = willing(&state.away, query.engine.as_deref()).await?;
    admit_all(&state, &sweep.designs).await?;
    let submitted = state.queue.submit_sweep(&sweep, priority, key, engine);
    let id = submitted.await.map_err(unsubmitted)?;
    state.away.look();
    tracing::info!(sweep = id, name = ?sweep.name, designs = sweep.designs.len(), "sweep accepted");
    accepted(&state.store, &id).await
}

/// Query of a sweep that is submitted.
#[derive(Deserialize)]
struct SweepQuery {
    priority: Option<String>,
    engine: Option<String>,
}

/// Query of a sweep that is looked at.
#[derive(Deserialize)]
struct DesignsQuery {
    from: Option<usize>,
    limit: Option<usize>,
}

/// Query of a sweep that goes on.
#[derive(Deserialize)]
struct EngineQuery {
    engine: Option<String>,
}

/// Refuses designs that would take more memory than they may; as many are planned side by side as there are threads to solve.
async fn admit_all(state: &AppState, designs: &[Design]) -> Result<(), Problem> {
    let (threads, memory_bytes) = (state.engine.threads, state.memory_bytes);
    let admitted = designs.iter().map(|design| {
        let (solver, study) = (state.engine.solver.clone(), design.study.clone());
        async move {
            let planned = plan_study(&study).await?;
            admit(&solver, threads, memory_bytes, &planned).await
        }
    });
    let admitted: Vec<_> = admitted.collect();
    let admitted = stream::iter(admitted).buffered(threads);
    admitted.try_collect::<()>().await.map_err(refused)
}

/// List sweeps
///
/// Newest first, a page at a time.
#[utoipa::path(get, path = "/v1/sweeps", tag = "sweeps",
    params(
        ("If-None-Match" = Option<String>, Header, description = "ETag of the page that the client has"),
        ("limit" = Option<u32>, Query, description = "Sweeps of a page, 50 when left out", minimum = 1, maximum = 200, example = 20),
        ("cursor" = Option<String>, Query, description = "`next_cursor` of the page before", example = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b"),
        ("search" = Option<String>, Query, description = "Sweeps whose name has this, whatever the case of ASCII letters, or whose identifier begins so", max_length = 200, example = "two walls"),
        ("archived" = Option<String>, Query, description = "`true`: archived ones alone; `all`: those, too; when left out, or `false`, they aren't listed", pattern = "^(true|false|all)$", example = "all")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "A page", body = SweepPage)))]
async fn list_sweeps(
    State(state): State<AppState>,
    Params(query): Params<PageQuery>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let (limit, listed) = (query.limit()?, query.listed()?);
    let mut connection = state.store.read().await?;
    let rows =
        sweep_rows::page(&mut connection, listed, query.cursor.as_deref(), limit + 1).await?;
    let page = rows.get(..limit as usize).unwrap_or(&rows);
    let mut summaries = Vec::new();
    for row in page {
        let standing = design_rows::standing(&mut connection, &row.id).await?;
        summaries.push(SweepSummary::of(row, &standing));
    }
    let next = page.last().filter(|_| rows.len() > page.len());
    let page = SweepPage {
        sweeps: summaries,
        next_cursor: next.map(|row| row.id.clone()),
    };
    conditional::json(&headers, &page)
}

/// Look at a sweep
///
/// How far it is, and its designs with their studies, a part of them at a time.
#[utoipa::path(get, path = "/v1/sweeps/{id}", tag = "sweeps",
    params(SweepPath,
        ("from" = Option<u32>, Query, description = "Place of the first design that is told, 0 when left out", minimum = 0, maximum = 10000, example = 200),
        ("limit" = Option<u32>, Query, description = "Designs that are told at most, 1000 when left out; `counts` has them all", minimum = 1, maximum = 1000, example = 100),
        ("If-None-Match" = Option<String>, Header, description = "ETag of the sweep as the client has it")),
    responses((status = 304, description = "The client has it"),
              (status = 200, description = "The sweep", body = SweepDetail),
              (status = 404, description = "There is no such sweep", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent()))))]
async fn show_sweep(
    State(state): State<AppState>,
    SweepId(id): SweepId,
    Params(query): Params<DesignsQuery>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let (from, limit) = (query.from.unwrap_or(0), query.limit.unwrap_or(MOST_TOLD));
    if from > MOST_DESIGNS || !(1..=MOST_TOLD).contains(&limit) {
        let detail =
            format!("from is between 0 and {MOST_DESIGNS}, limit between 1 and {MOST_TOLD}");
        return Err(Problem::new(StatusCode::BAD_REQUEST, &detail));
    }
    let sweep = detail(&state.store, &id, from..from + limit).await?;
    conditional::json(&headers, &sweep)
}

/// Rename or archive a sweep
///
/// Changes what lists say of it; its designs and their studies stay as they are. Lists leave out what is archived unless asked. The same change again changes
/// nothing.
#[utoipa::path(patch, path = "/v1/sweeps/{id}", tag = "sweeps", params(SweepPath),
    request_body(description = "The change, as JSON or TOML", content(
        (EntryChange = "application/json", example = json!(entry_change::example())),
        (String = "application/toml", example = json!("archived = true\n")))),
    responses((status = 200, description = "Changed", body = SweepSummary),
              (status = 404, description = "There is no such sweep", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent())),
              (status = 422, description = "The change has faults: all of them, each with its JSON pointer", body = ProblemDocument, content_type = "application/problem+json", example = json!(faults()))))]
async fn change_sweep(
    State(state): State<AppState>,
    SweepId(id): SweepId,
    document: Document,
) -> Result<Json<SweepSummary>, Problem> {
    known(&state.store, &id).await?;
    let change = document.checked(read_change).await?;
    let mut transaction = state.store.begin().await?;
    sweep_rows::change(&mut transaction, &id, &change).await?;
    state.store.commit(transaction, 0).await?;
    let sweep = known(&state.store, &id).await?;
    let mut connection = state.store.read().await?;
    let standing = design_rows::standing(&mut connection, &id).await?;
    Ok(Json(SweepSummary::of(&sweep, &standing)))
}

/// Extend a sweep
///
/// Adds designs; those that it has already are left as they are, and nothing that was solved is solved again.
#[utoipa::path(post, path = "/v1/sweeps/{id}/designs", tag = "sweeps", params(SweepPath),
    request_body(description = "Further designs, as JSON or TOML", content(
        (FurtherDesignsDocument = "application/json", example = json!(examples::further())),
        (String = "application/toml", example = json!("[grid]\n\"geometry.wall_mm\" = [3.5]\n")))),
    responses((status = 202, description = "Taken in", body = SweepDetail, headers(("Location" = String, description = "Address of the sweep"), ("Retry-After" = String, description = "Seconds after which to look"))),
              (status = 404, description = "There is no such sweep", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent())),
              (status = 422, description = "The document has faults: all of them, each with its JSON pointer", body = ProblemDocument, content_type = "application/problem+json", example = json!(faults())),
              (status = 429, description = "Too many studies would wait", body = ProblemDocument, content_type = "application/problem+json",
            headers(("Retry-After" = String, description = "Seconds after which to try again")), example = json!(crowded()))))]
async fn extend_sweep(
    State(state): State<AppState>,
    SweepId(id): SweepId,
    document: Document,
) -> Result<Response, Problem> {
    let sweep = known(&state.store, &id).await?;
    let outdated = |cause| Problem::new(StatusCode::CONFLICT, cause);
    let base = stored_base(&sweep).map_err(outdated)?;
    let designs = document
        .checked(move |value| designs_of(&base, value, MOST_SUBMITTED))
        .await?;
    admit_all(&state, &designs).await?;
    let extended = state.queue.extend_sweep(&sweep, designs).await;
    extended.map_err(unsubmitted)?;
    accepted(&state.store, &id).await
}

/// Resume a sweep
///
/// Puts designs that were cancelled or failed back into the queue, as new studies. What they had solved is kept; those with a result stay as they are.
#[utoipa::path(post, path = "/v1/sweeps/{id}/resume", tag = "sweeps", params(SweepPath,
        ("engine" = Option<String>, Query, description = "Engine of `GET /v1/engines` whose machines solve what the sweep lacks", example = "slurm")),
    responses((status = 202, description = "Taken in", body = SweepDetail, headers(("Location" = String, description = "Address of the sweep"), ("Retry-After" = String, description = "Seconds after which to look"))),
              (status = 404, description = "There is no such sweep", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent())),
              (status = 429, description = "Too many studies would wait", body = ProblemDocument, content_type = "application/problem+json",
            headers(("Retry-After" = String, description = "Seconds after which to try again")), example = json!(crowded())),
              (status = 422, description = "There is no such engine", body = ProblemDocument, content_type = "application/problem+json", example = json!(unknown_engine())),
              (status = 503, description = "The engine is missing, or refuses, in its own words", body = ProblemDocument, content_type = "application/problem+json", example = json!(unwilling()))))]
async fn resume_sweep(
    State(state): State<AppState>,
    SweepId(id): SweepId,
    Params(query): Params<EngineQuery>,
) -> Result<Response, Problem> {
    let sweep = known(&state.store, &id).await?;
    let engine = willing(&state.away, query.engine.as_deref()).await?;
    let resumed = state.queue.resume_sweep(&sweep, engine).await;
    resumed.map_err(unsubmitted)?;
    state.away.look();
    accepted(&state.store, &id).await
}

/// Cancel or remove a sweep
///
/// What runs ends within a Newton iteration; what was solved is kept. Designs that have ended stay as they are. With `purge` the sweep is removed, with the
/// studies of its designs, their results and the points that no other study has: nothing brings it back.
#[utoipa::path(delete, path = "/v1/sweeps/{id}", tag = "sweeps", params(SweepPath, RemovalQuery),
    responses((status = 202, description = "Cancelled, or ended before", body = SweepDetail, headers(("Location" = String, description = "Address of the sweep"), ("Retry-After" = String, description = "Seconds after which to look"))),
              (status = 204, description = "Removed"),
              (status = 404, description = "There is no such sweep", body = ProblemDocument, content_type = "application/problem+json", example = json!(absent()))))]
async fn cancel_sweep(
    State(state): State<AppState>,
    SweepId(id): SweepId,
    Params(query): Params<RemovalQuery>,
) -> Result<Response, Problem> {
    known(&state.store, &id).await?;
    if query.removes()? {
        state.queue.remove_sweep(&id).await?;
        tracing::info!(sweep = id, "sweep removed");
        return Ok(StatusCode::NO_CONTENT.into_response());
    }
    state.queue.cancel_sweep(&id).await?;
    accepted(&state.store, &id).await
}

/// Estimate a sweep
///
/// What its designs would cost, before anything is solved; a point that several designs share counts once. Nothing is stored.
#[utoipa::path(post, path = "/v1/sweeps:estimate", tag = "sweeps",
    request_body(description = "A sweep, as JSON or TOML", content(
        (SweepDocument = "application/json", example = json!(examples::document())),
        (String = "application/toml", example = json!(examples::document_toml())))),
    responses((status = 200, description = "The estimate", body = SweepEstimate),
              (status = 422, description = "The document has faults: all of them, each with its JSON pointer", body = ProblemDocument, content_type = "application/problem+json", example = json!(faults()))))]
async fn estimate_sweep(
    State(state): State<AppState>,
    SweepBody { sweep }: SweepBody,
) -> Result<Json<SweepEstimate>, Problem> {
    let engine = &state.engine;
    let store = Some(&*state.store);
    let estimate = forecast_sweep(store, &engine.solver, engine.threads, &sweep).await;
    estimate.map(Json).map_err(refused)
}

/// The sweep of this identifier, or 404.
pub async fn known(store: &Store, id: &str) -> Result<SweepRow, Problem> {
    let mut connection = store.read().await?;
    let absent = || Problem::not_found(format!("there is no sweep {id:?}"));
    sweep_rows::find(&mut connection, id)
        .await?
        .ok_or_else(absent)
}

/// The sweep of this identifier with its designs at these places, or 404.
async fn detail(store: &Store, id: &str, places: Range<usize>) -> Result<SweepDetail, Problem> {
    let sweep = known(store, id).await?;
    let mut connection = store.read().await?;
    let standing = design_rows::standing(&mut connection, id).await?;
    let designs = design_rows::designs(&mut connection, id, places).await?;
    Ok(SweepDetail::of(&sweep, &standing, &designs)?)
}

async fn accepted(store: &Store, id: &str) -> Result<Response, Problem> {
    let headers = [
        (header::LOCATION, format!("/v1/sweeps/{id}")),
        (header::RETRY_AFTER, "1".to_owned()),
    ];
    let sweep = Json(detail(store, id, 0..MOST_TOLD).await?);
    Ok((StatusCode::ACCEPTED, headers, sweep).into_response())
}
