//! Estimate, submit, list, look at and cancel studies.

use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use axum::{Json, Router};
use placement::result::Estimate;
use serde::Deserialize;
use serde_json::{Value, json};

use super::AppState;
use super::document::StudyBody;
use super::extract::{Params, StudyId};
use super::problem::Problem;
use crate::forecast::{ForecastError, forecast};
use crate::queue::SubmitError;
use crate::store::studies::{self, State as StudyState, StudyRow};
use crate::store::{Store, results, trades};

/// `/v1/studies` and `/v1/studies/{id}`.
pub fn router() -> Router<AppState> {
    Router::new()
        .route("/v1/studies", get(list).post(submit))
        .route("/v1/studies/{id}", get(show).delete(cancel))
        .route("/v1/studies:estimate", post(estimate))
}

async fn submit(
    State(state): State<AppState>,
    headers: HeaderMap,
    body: StudyBody,
) -> Result<Response, Problem> {
    let key = idempotency_key(&headers)?;
    let id = state
        .queue
        .submit(&body.study, key)
        .await
        .map_err(|error| match error {
            SubmitError::KeyTaken => Problem::new(
                StatusCode::UNPROCESSABLE_ENTITY,
                "this Idempotency-Key was used with another document",
            ),
            SubmitError::Store(error) => error.into(),
        })?;
    let study = known(&state.store, &id).await?;
    Ok(accepted(&study))
}

/// A key is 1 to 255 visible ASCII characters.
fn idempotency_key(headers: &HeaderMap) -> Result<Option<&str>, Problem> {
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
    (StatusCode::ACCEPTED, headers, Json(summary(study))).into_response()
}

#[derive(Deserialize)]
struct PageQuery {
    limit: Option<String>,
    cursor: Option<String>,
    state: Option<String>,
}

const PAGE: u32 = 50;
const LARGEST_PAGE: u32 = 200;

async fn list(
    State(state): State<AppState>,
    Params(query): Params<PageQuery>,
) -> Result<Response, Problem> {
    let wrong = |detail: &str| Problem::new(StatusCode::BAD_REQUEST, detail);
    let limit = query
        .limit
        .map_or(Ok(PAGE), |text| text.parse())
        .ok()
        .filter(|n| (1..=LARGEST_PAGE).contains(n));
    let limit = limit.ok_or_else(|| wrong("limit is a whole number from 1 to 200"))?;
    let filter = match query.state.as_deref() {
        None => None,
        Some(name) => Some(
            StudyState::named(name)
                .ok_or_else(|| wrong("state is one of queued, running, done, failed, cancelled"))?,
        ),
    };
    let mut connection = state.store.read().await?;
    let rows = studies::page(&mut connection, filter, query.cursor.as_deref(), limit + 1).await?;
    let page = &rows[..rows.len().min(limit as usize)];
    let next = page
        .last()
        .filter(|_| rows.len() > page.len())
        .map(|row| &row.id);
    Ok(
        Json(json!({"studies": page.iter().map(summary).collect::<Vec<_>>(), "next_cursor": next}))
            .into_response(),
    )
}

async fn show(State(state): State<AppState>, StudyId(id): StudyId) -> Result<Json<Value>, Problem> {
    let study = known(&state.store, &id).await?;
    let mut body = summary(&study);
    body["document"] = serde_json::from_str(&study.spec).unwrap_or(Value::Null);
    let estimate = study.estimate.as_deref().map(serde_json::from_str);
    body["estimate"] = estimate.and_then(Result::ok).unwrap_or(Value::Null);
    let mut connection = state.store.read().await?;
    body["result_sha256"] = json!(results::sha256_of(&mut connection, &id).await?);
    body["trade_measured"] = json!(trades::is_measured(&mut connection, &study.spec_sha256).await?);
    Ok(Json(body))
}

/// What a study would cost, without submitting it.
async fn estimate(
    State(state): State<AppState>,
    body: StudyBody,
) -> Result<Json<Estimate>, Problem> {
    let engine = &state.engine;
    let estimate = forecast(
        Some(&state.store),
        &engine.solver,
        engine.threads,
        &body.study,
    )
    .await;
    estimate.map(Json).map_err(|error| match error {
        ForecastError::Plan(error) => {
            Problem::new(StatusCode::UNPROCESSABLE_ENTITY, error.to_string())
        }
        ForecastError::Store(error) => error.into(),
        ForecastError::Broken => Problem::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()),
    })
}

/// Cancelling what has ended changes nothing and is no error.
async fn cancel(State(state): State<AppState>, StudyId(id): StudyId) -> Result<Response, Problem> {
    known(&state.store, &id).await?;
    state.queue.cancel(&id).await?;
    Ok(accepted(&known(&state.store, &id).await?))
}

/// The study of this identifier, or 404.
pub async fn known(store: &Store, id: &str) -> Result<StudyRow, Problem> {
    let mut connection = store.read().await?;
    let study = studies::find(&mut connection, id).await?;
    study.ok_or_else(|| Problem::not_found(format!("there is no study {id:?}")))
}

fn summary(study: &StudyRow) -> Value {
    json!({
        "id": study.id,
        "name": study.name,
        "state": study.state(),
        "spec_sha256": study.spec_sha256,
        "points_total": study.points_total,
        "points_done": study.points_done,
        "error": study.error,
        "created": study.created,
        "started": study.started,
        "finished": study.finished,
    })
}
