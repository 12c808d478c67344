//! The service's outside: routes under `/v1`, health, and the dashboard.
//!
//! - [`problem`]: what a client is told when a request can't be answered
//! - [`request_id`]: every request has an identifier
//! - [`guard`]: who may ask
//! - [`access`]: the token, where one is asked for
//! - [`wire`], [`examples`]: the documents that go in and out
//! - [`extract`]: reads addresses and queries
//! - [`conditional`]: answers that needn't be sent again
//! - [`document`]: reads the body of a submitted study
//! - [`studies`]: submit, list, look at, cancel
//! - [`sweeps`], [`sweep_wire`], [`sweep_examples`]: the same for many designs at once
//! - [`comparison`]: studies side by side
//! - [`events`]: progress as server-sent events
//! - [`results`]: result, locations, layouts, evaluations, map
//! - [`export`]: the same as tables
//! - [`presets`]: studies and scenes to start from
//! - [`health`]: is it up, can it work
//! - [`metrics`]: how it does
//! - [`openapi`], [`docs`]: the description of all this
//! - [`assets`]: the dashboard
//! - [`listener`], [`reading`]: accepts connections, and drops those that nobody reads from

pub mod access;
pub mod assets;
pub mod comparison;
pub mod conditional;
pub mod docs;
pub mod document;
pub mod events;
pub mod export;
pub mod extract;
pub mod guard;
pub mod health;
pub mod listener;
pub mod metrics;
pub mod openapi;
pub mod presets;
pub mod problem;
pub mod reading;
pub mod request_id;
pub mod results;
pub mod studies;
pub mod sweeps;

use std::any::Any;
use std::sync::Arc;

use axum::http::StatusCode;
use axum::middleware::{from_fn, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::{Router, body::Body};
use tower_http::catch_panic::CatchPanicLayer;
use utoipa_axum::router::OpenApiRouter;

use access::Access;
use events::Streams;
use problem::Problem;
use service::engine::Engine;
use service::metrics::Metrics;
use service::queue::Queue;
use service::shutdown::Shutdown;
use store::Store;

/// What every handler may use.
#[derive(Clone)]
pub struct AppState {
    /// The database.
    pub store: Arc<Store>,
    /// Solves, and knows on how many threads.
    pub engine: Engine,
    /// The queue of studies.
    pub queue: Arc<Queue>,
    /// Memory that a study may take, bytes.
    pub memory_bytes: u64,
    /// Hears when the service is to stop.
    pub shutdown: Shutdown,
    /// Who is let in.
    pub access: Access,
    /// Counts requests and whatever else.
    pub metrics: Arc<Metrics>,
    /// Places for event streams.
    pub streams: Streams,
}

/// All routes with their operations.
fn routes() -> OpenApiRouter<AppState> {
    openapi::described()
        .merge(studies::router())
        .merge(sweeps::router())
        .merge(comparison::router())
        .merge(events::router())
        .merge(results::router())
        .merge(export::router())
        .merge(presets::router())
        .merge(health::router())
        .merge(access::router())
        .merge(metrics::router())
        .merge(openapi::router())
}

/// All routes, guarded: the innermost layer stands first.
pub fn app(state: AppState, hosts: guard::HostList) -> Router {
    let (router, _) = routes().split_for_parts();
    let (access, counted) = (state.access.clone(), state.metrics.clone());
    router
        .method_not_allowed_fallback(wrong_method)
        .fallback(assets::fallback)
        .with_state(state)
        .layer(CatchPanicLayer::custom(panicked))
        .layer(from_fn_with_state(access, access::authorise))
        .layer(from_fn_with_state(hosts, guard::admit))
        .layer(from_fn(guard::harden))
        .layer(from_fn(request_id::assign))
        .layer(from_fn_with_state(counted, metrics::measure))
}

async fn wrong_method() -> Problem {
    Problem::new(
        StatusCode::METHOD_NOT_ALLOWED,
        "this address does not take that method; see the Allow header",
    )
}

/// The panic itself is in the log already.
fn panicked(_: Box<dyn Any + Send>) -> Response<Body> {
    Problem::new(
        StatusCode::INTERNAL_SERVER_ERROR,
        "the service has a fault; its log says where",
    )
    .into_response()
}
