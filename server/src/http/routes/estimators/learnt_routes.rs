//! Results of learning from recordings: report, model, rows that were left out; and estimates by it.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::post;
use document::fault::Fault;
use estimation::fit_report::Report;
use tokio::sync::Semaphore;
use tokio::time::timeout;
use utoipa::OpenApi;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::answer_limits::Making;
use crate::http::edge::conditional::{has, tagged};
use crate::http::edge::extract::{AppliedId, EstimatorId, EstimatorPath, no_method};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::estimators::estimator_routes::known;
use crate::http::routes::long_body::LongBody;
use service::export::FileFormat;
use service::forces::applying::{Bounds, Zero, apply_within};
use service::forces::model_file::read_model;
use service::forces::recorded_texts::NamedText;
use service::forces::submission_reader::{of_recording, read_recording};
use service::wire::estimator_examples as examples;
use service::wire::estimator_wire::{LeftOutForces, RecordingDocument};
use service::wire::study_wire::ProblemDocument;
use store::Store;
use store::queue::estimator_parts::{self, Part};

/// Bytes of estimates that are made at once.
const MOST_ESTIMATES: usize = 128 << 20;
/// A recording that waits longer for its estimates is refused.
const PATIENCE: Duration = Duration::from_secs(30);

/// Recordings estimated at once. A process takes some milliseconds for a row, so that a long recording takes minutes: other answers have places of their own.
static APPLIERS: Semaphore = Semaphore::const_new(2);

/// Returns the routes below `/v1/estimators/{id}`, and `/v1/estimators/{id}:apply`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::with_openapi(Applying::openapi())
        .routes(routes!(estimator_report))
        .routes(routes!(estimator_model))
        .routes(routes!(estimator_left_out))
        // Described as {id}:apply, which the router can't tell from {id}: AppliedId does.
        .route(
            "/v1/estimators/{id}",
            post(apply_estimator).fallback(no_method),
        )
}

#[derive(OpenApi)]
#[openapi(paths(apply_estimator))]
struct Applying;

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

/// Estimate the forces of a recording
///
/// CSV as `strainsite force apply` prints it: a row for each of the recording, or for each tick of the recipe's clock, with every force, its interval, and whether the signals are outside of
/// what was learnt from. Nothing is stored. The whole document has at most 64 MiB.
#[utoipa::path(post, path = "/v1/estimators/{id}:apply", tag = "estimators", params(EstimatorPath),
    request_body(description = "A recording", content((RecordingDocument = "application/json", example = json!(examples::unmeasured())))),
    responses((status = 200, description = "The estimates", content((String = "text/csv", example = json!(examples::estimates())))),
              (status = 404, description = "There is no such estimator", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
              (status = 409, description = "It isn't done; the detail says what became of it", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unlearnt())),
              (status = 413, description = "The document has more than 64 MiB", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::too_large())),
              (status = 422, description = "The recording has faults: all of them, with line and column", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
async fn apply_estimator(
    State(state): State<AppState>,
    AppliedId(id): AppliedId,
    body: LongBody,
) -> Result<Response, Problem> {
    ready(&state.store, &id, Part::Model).await?;
    let (recording, _held) = body.checked(read_recording).await?;
    let place = timeout(PATIENCE, APPLIERS.acquire()).await;
    let _place = place.ok().and_then(Result::ok).ok_or_else(|| {
        let detail = "others have recordings estimated just now: ask again later";
        Problem::new(StatusCode::SERVICE_UNAVAILABLE, detail)
    })?;
    let model = text(&state.store, &id, Part::Model).await?;
    let waiting = Waiting::default();
    let stop = waiting.stop.clone();
    let work = tokio::task::spawn_blocking(move || estimates(&model, &recording, &stop));
    let mut shutdown = state.shutdown.clone();
    let estimates = tokio::select! {
        made = work => made.unwrap_or(Err(Unestimated::Broken)),
        () = shutdown.wait() => Err(Unestimated::Stopped),
    };
    let kind = [(header::CONTENT_TYPE, FileFormat::Csv.media_type())];
    Ok((kind, estimates?).into_response())
}

/// Stops the estimates that nobody waits for any more.
#[derive(Default)]
struct Waiting {
    stop: Arc<AtomicBool>,
}

impl Drop for Waiting {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// Reason why there are no estimates.
enum Unestimated {
    /// The recording is wrong.
    Input(Vec<Fault>),
    /// The stored model can't be read.
    Model(String),
    /// The service ends.
    Stopped,
    /// A panic.
    Broken,
}

fn estimates(model: &str, recording: &NamedText, stop: &AtomicBool) -> Result<String, Unestimated> {
    let unreadable = |faults: Vec<Fault>| {
        let faults: Vec<String> = faults.iter().map(Fault::to_string).collect();
        Unestimated::Model(faults.join("; "))
    };
    let estimator = read_model(model).map_err(unreadable)?;
    let bounds = Bounds {
        zero: &Zero::AsLearnt,
        most_bytes: MOST_ESTIMATES,
        stop,
    };
    let found = apply_within(&estimator, &recording.name, &recording.text, bounds);
    found
        .map_err(|faults| Unestimated::Input(of_recording(faults)))?
        .ok_or(Unestimated::Stopped)
}

impl From<Unestimated> for Problem {
    fn from(error: Unestimated) -> Self {
        match error {
            Unestimated::Input(faults) => Self::faults(faults),
            Unestimated::Model(detail) => Self::new(
                StatusCode::CONFLICT,
                format!("the estimator can't be used any more, so learn it anew: {detail}"),
            ),
            Unestimated::Stopped => {
                Self::new(StatusCode::SERVICE_UNAVAILABLE, "the service is stopping")
            }
            Unestimated::Broken => Self::new(
                StatusCode::INTERNAL_SERVER_ERROR,
                "the service has a fault; its log says where",
            ),
        }
    }
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

/// Hash of a part of what was learnt, or 409 with what became of the estimator.
async fn ready(store: &Store, id: &str, part: Part) -> Result<String, Problem> {
    let row = known(store, id).await?;
    let mut connection = store.read().await?;
    let sha256 = estimator_parts::part_sha256(&mut connection, id, part).await?;
    sha256.ok_or_else(|| {
        let error = row.error.as_deref();
        let cause = error.map_or(String::new(), |error| format!(": {error}"));
        let (state, what) = (row.state().as_str(), nameable(part));
        Problem::new(
            StatusCode::CONFLICT,
            format!("the estimator is {state} and has no {what}{cause}"),
        )
    })
}

fn nameable(part: Part) -> &'static str {
    match part {
        Part::Report => "report",
        Part::Model => "model",
        Part::LeftOut => "rows that were left out",
    }
}

/// A part of what was learnt, or 404 when it was removed meanwhile.
async fn text(store: &Store, id: &str, part: Part) -> Result<String, Problem> {
    let mut connection = store.read().await?;
    let text = estimator_parts::part(&mut connection, id, part).await?;
    text.ok_or_else(|| Problem::not_found(format!("there is no estimator {id:?}")))
}
