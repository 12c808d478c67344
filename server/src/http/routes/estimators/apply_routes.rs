//! Estimates of a recording by what was learnt.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::post;
use document::fault::Fault;
use tokio::sync::Semaphore;
use tokio::time::timeout;
use utoipa::OpenApi;
use utoipa_axum::router::OpenApiRouter;

use crate::http::app_state::AppState;
use crate::http::edge::extract::{DoneWithId, EstimatorPath, Verb, no_method};
use crate::http::edge::problem_document::Problem;
use crate::http::routes::estimators::stored_estimator::{broken, ready, text, unusable, zero_of};
use crate::http::routes::estimators::zero_routes::{self, zero_estimator};
use crate::http::routes::long_body::LongBody;
use service::export::FileFormat;
use service::forces::applying::{Bounds, Estimates, Zero, apply_within};
use service::forces::model_file::read_model;
use service::forces::recorded_texts::NamedText;
use service::forces::submission_reader::{of_recording, read_recording};
use service::wire::estimator_examples as examples;
use service::wire::estimator_wire::RecordingDocument;
use service::wire::study_wire::ProblemDocument;
use store::queue::estimator_parts::Part;

/// Bytes of estimates that are made at once.
const MOST_ESTIMATES: usize = 128 << 20;
/// A recording that waits longer for its estimates is refused.
const PATIENCE: Duration = Duration::from_secs(30);
/// Header of what a reader should know of the estimates.
const WARNING: &str = "strainsite-warning";

/// Recordings estimated at once. A process takes some milliseconds for a row, so that a long recording takes minutes: other answers have places of their own.
static APPLIERS: Semaphore = Semaphore::const_new(2);

/// Returns `/v1/estimators/{id}:apply` and `/v1/estimators/{id}:zero`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    // Described by these addresses, which the router can't tell from {id}: DoneWithId does.
    OpenApiRouter::with_openapi(Verbs::openapi()).route(
        "/v1/estimators/{id}",
        post(done_with_estimator).fallback(no_method),
    )
}

#[derive(OpenApi)]
#[openapi(paths(apply_estimator, zero_routes::zero_estimator))]
struct Verbs;

async fn done_with_estimator(
    State(state): State<AppState>,
    DoneWithId(id, verb): DoneWithId,
    body: LongBody,
) -> Result<Response, Problem> {
    match verb {
        Verb::Apply => apply_estimator(state, id, body).await,
        Verb::Zero => zero_estimator(state, id, body).await,
    }
}

/// Estimate the forces of a recording
///
/// CSV as `strainsite force apply` prints it: a row for each of the recording, or for each tick of the recipe's clock, with every force, its interval, and whether the signals are outside of
/// what was learnt from. It begins with the zero that the estimator was given, or else as recordings did when it was learnt. Nothing is stored. The whole document has at most 64 MiB.
#[utoipa::path(post, path = "/v1/estimators/{id}:apply", tag = "estimators", params(EstimatorPath),
    request_body(description = "A recording", content((RecordingDocument = "application/json", example = json!(examples::unmeasured())))),
    responses((status = 200, description = "The estimates", content((String = "text/csv", example = json!(examples::estimates()))),
                headers(("Strainsite-Warning" = Option<String>, description = "Says under which load the recording begins, where that load is taken for nothing"))),
              (status = 404, description = "There is no such estimator", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
              (status = 409, description = "It isn't done; the detail says what became of it", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unlearnt())),
              (status = 413, description = "The document has more than 64 MiB", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::too_large())),
              (status = 422, description = "The recording has faults: all of them, with line and column", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
async fn apply_estimator(state: AppState, id: String, body: LongBody) -> Result<Response, Problem> {
    ready(&state.store, &id, Part::Model).await?;
    let (recording, _held) = body.checked(read_recording).await?;
    let place = timeout(PATIENCE, APPLIERS.acquire()).await;
    let _place = place.ok().and_then(Result::ok).ok_or_else(|| {
        let detail = "others have recordings estimated just now: ask again later";
        Problem::new(StatusCode::SERVICE_UNAVAILABLE, detail)
    })?;
    let model = text(&state.store, &id, Part::Model).await?;
    let zero = zero_of(&state.store, &id).await?;
    let zero = zero.map_or(Zero::AsLearnt, |given| Zero::Known(given.zero));
    let waiting = Waiting::default();
    let stop = waiting.stop.clone();
    let work = tokio::task::spawn_blocking(move || estimates(&model, &recording, &zero, &stop));
    let mut shutdown = state.shutdown.clone();
    let estimates = tokio::select! {
        made = work => made.unwrap_or(Err(Unestimated::Broken)),
        () = shutdown.wait() => Err(Unestimated::Stopped),
    };
    let Estimates { csv, begins_loaded } = estimates?;
    let kind = [(header::CONTENT_TYPE, FileFormat::Csv.media_type())];
    // Names of forces are any text, and headers are ASCII.
    let warning = begins_loaded.map(|warning| [(WARNING, warning.escape_default().to_string())]);
    Ok((kind, warning, csv).into_response())
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
    Model(Vec<Fault>),
    /// The service ends.
    Stopped,
    /// A panic.
    Broken,
}

fn estimates(
    model: &str,
    recording: &NamedText,
    zero: &Zero,
    stop: &AtomicBool,
) -> Result<Estimates, Unestimated> {
    let estimator = read_model(model).map_err(Unestimated::Model)?;
    let bounds = Bounds {
        zero,
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
            Unestimated::Model(faults) => unusable(&faults),
            Unestimated::Stopped => {
                Self::new(StatusCode::SERVICE_UNAVAILABLE, "the service is stopping")
            }
            Unestimated::Broken => broken(),
        }
    }
}
