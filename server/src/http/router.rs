//! All routes, guarded, with the dashboard.

use std::any::Any;

use axum::http::StatusCode;
use axum::middleware::{from_fn, from_fn_with_state, map_response};
use axum::response::{IntoResponse, Response};
use axum::{Router, body::Body};
use tower_http::catch_panic::CatchPanicLayer;

use crate::http::app_state::AppState;
use crate::http::edge::problem_document::Problem;
use crate::http::edge::{access, answer_limits, guard, packed, request_id};
use crate::http::mount::{self, Mounting};
use crate::http::routes::assets;
use crate::http::routes::openapi::description;
use crate::http::routes::upkeep::metric_routes;
use crate::http::short_ids;

/// All routes, guarded: the innermost layer stands first.
pub fn app(state: AppState, hosts: guard::HostList, mounting: Mounting) -> Router {
    let (router, _) = description::routes().split_for_parts();
    let (access, counted) = (state.access.clone(), state.metrics.clone());
    let (answers, store) = (state.answers.clone(), state.store.clone());
    let router = router
        // The dashboard's files, which no route answers, lie in the program and cost nothing.
        .route_layer(from_fn_with_state(answers, answer_limits::count))
        .method_not_allowed_fallback(wrong_method)
        .fallback(assets::fallback)
        .with_state(state)
        .layer(CatchPanicLayer::custom(panicked))
        .layer(packed::layer())
        .layer(map_response(packed::weaken))
        .layer(from_fn_with_state(access, access::authorise))
        .layer(from_fn_with_state(hosts, guard::admit))
        .layer(from_fn_with_state(counted, metric_routes::measure));
    // A layer of the router itself would come after it has looked at the path.
    Router::new()
        .fallback_service(router)
        .layer(from_fn_with_state(store, short_ids::lengthen))
        .layer(from_fn_with_state(mounting, mount::unmount))
        .layer(from_fn(guard::harden))
        .layer(from_fn(request_id::assign))
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
