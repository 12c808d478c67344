//! `/metrics`, and what is counted of requests.

use std::sync::Arc;
use std::time::Instant;

use axum::extract::{MatchedPath, Request, State};
use axum::http::{Method, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use placement::points::usage::memory_bytes;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::problem_document::Problem;
use service::metrics::{MEDIA_TYPE, Metrics, Snapshot};
use store::queue::{estimator_rows, study_rows};
use tasks::away::away_report::EngineView;

/// Label of what no route answers: the dashboard's files, and what isn't there.
const NO_ROUTE: &str = "other";

/// `/metrics`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(metrics))
}

/// Measure the service
///
/// For Prometheus: studies, estimators and tasks of engines by state, points by what came of them, times of solves and requests, sizes. The format is OpenMetrics text.
#[utoipa::path(get, path = "/metrics", tag = "service",
    responses((status = 200, description = "The measurements", content_type = "application/openmetrics-text", body = String,
        example = json!("# HELP strainsite_studies Studies by state.\n# TYPE strainsite_studies gauge\nstrainsite_studies{state=\"queued\"} 2\n# EOF\n"))))]
async fn metrics(State(state): State<AppState>) -> Result<Response, Problem> {
    let engines = state.away.list().await?.engines;
    let mut connection = state.store.read().await?;
    let snapshot = Snapshot {
        studies: study_rows::counts(&mut connection).await?,
        estimators: estimator_rows::counts(&mut connection).await?,
        engine_tasks: engines.iter().flat_map(EngineView::counts).collect(),
        database_bytes: state.store.bytes(),
        event_streams: state.streams.open(),
        memory_bytes: memory_bytes(),
    };
    let kind = [(header::CONTENT_TYPE, MEDIA_TYPE)];
    Ok((kind, state.metrics.text(&snapshot)).into_response())
}

/// Counts the request and its time. It stands outside of all that may refuse one.
pub async fn measure(
    State(metrics): State<Arc<Metrics>>,
    request: Request,
    next: Next,
) -> Response {
    let route = request.extensions().get::<MatchedPath>().cloned();
    let (method, started) = (name(request.method()), Instant::now());
    let response = next.run(request).await;
    let route = route.as_ref().map_or(NO_ROUTE, MatchedPath::as_str);
    metrics.request(
        method,
        route,
        response.status().as_u16(),
        started.elapsed().as_secs_f64(),
    );
    response
}

/// Clients may make methods up.
fn name(method: &Method) -> &'static str {
    let known = ["GET", "HEAD", "POST", "DELETE", "PUT", "PATCH", "OPTIONS"];
    let found = known.into_iter().find(|name| method.as_str() == *name);
    found.unwrap_or(NO_ROUTE)
}
