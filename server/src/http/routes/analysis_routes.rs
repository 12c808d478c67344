//! Indices of models that others run: points out, values in, and nothing is kept in between.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use tokio::sync::Semaphore;
use tokio::time::timeout;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::problem_document::Problem;
use crate::http::routes::long_body::LongBody;
use service::wire::analysis_wire::{AnalysisDocument, ModelAnalysis};
use service::wire::study_wire::ProblemDocument;
use service::wire::{estimator_examples, examples};
use service::work::analysis_process::{self, Unanalysed};

/// An analysis that waits longer for its turn is refused.
const PATIENCE: Duration = Duration::from_secs(30);

/// Analyses at once: each takes a core.
static ANALYSTS: Semaphore = Semaphore::const_new(2);

/// `/v1/analyses`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(analyse))
}

/// Analyse a model of your own
///
/// Sobol indices of a model that you run yourself. Send its inputs, and the answer has the `points` to run; send the same with `values` of all points so far, and it has the
/// indices of each output with their errors, and the points that the method asks for next. The method `auto`, which is the default here, does so until its tolerance is met:
/// repeat until `wanted` is 0. Nothing is stored. At most 20 000 points, 1 000 000 numbers of them, and a minute: `strainsite gsa` takes more.
#[utoipa::path(post, path = "/v1/analyses", tag = "analyses",
    request_body(description = "Inputs, and values so far", content((AnalysisDocument = "application/json", example = json!(examples::analysis())))),
    responses(
        (status = 200, description = "Indices as far as the values tell, and the points that are still to be run", body = ModelAnalysis),
        (status = 413, description = "The document has more than 64 MiB", body = ProblemDocument, content_type = "application/problem+json", example = json!(estimator_examples::too_large())),
        (status = 422, description = "The document has faults: all of them, each with its JSON pointer, those of a CSV text with their line; or the analysis takes too long", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults())),
        (status = 503, description = "Others have models analysed, or the service is stopping", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unready()))))]
async fn analyse(
    State(state): State<AppState>,
    body: LongBody,
) -> Result<Json<ModelAnalysis>, Problem> {
    let (document, _held) = body.checked(Ok).await?;
    let place = timeout(PATIENCE, ANALYSTS.acquire()).await;
    let place = place.ok().and_then(Result::ok).ok_or_else(|| {
        let detail = "others have models analysed just now: ask again later";
        Problem::new(StatusCode::SERVICE_UNAVAILABLE, detail)
    })?;
    let waiting = Waiting::default();
    let (stop, command) = (waiting.0.clone(), (state.analyst)());
    let work = tokio::task::spawn_blocking(move || {
        let _place = place;
        analysis_process::analyse(command, &document, &stop)
    });
    let mut shutdown = state.shutdown.clone();
    let analysis = tokio::select! {
        made = work => made.unwrap_or(Err(Unanalysed::Broken)),
        () = shutdown.wait() => Err(Unanalysed::Stopped),
    };
    Ok(Json(analysis?))
}

/// Stops the analysis that nobody waits for any more.
#[derive(Default)]
struct Waiting(Arc<AtomicBool>);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

impl From<Unanalysed> for Problem {
    fn from(error: Unanalysed) -> Self {
        let status = match error {
            Unanalysed::Faulty(faults) => return Self::faults(faults),
            Unanalysed::TooLarge(_) => StatusCode::UNPROCESSABLE_ENTITY,
            Unanalysed::Stopped => StatusCode::SERVICE_UNAVAILABLE,
            Unanalysed::Broken => StatusCode::INTERNAL_SERVER_ERROR,
        };
        Self::new(status, error.to_string())
    }
}
