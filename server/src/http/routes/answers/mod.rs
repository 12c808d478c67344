//! Answers of a study:
//!
//! - [`result_routes`], [`sent_result`]: result, locations, layouts, evaluations, map
//! - [`field_routes`]: the wheel at the means
//! - [`hand_layout_routes`]: layouts that somebody moves by hand
//! - [`export_routes`]: answers as files

pub(crate) mod export_routes;
pub(crate) mod field_routes;
pub(crate) mod hand_layout_routes;
pub(crate) mod result_routes;
pub(crate) mod sent_result;

use utoipa_axum::router::OpenApiRouter;

use crate::http::app_state::AppState;

/// Returns the routes of all of them.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    result_routes::router()
        .merge(field_routes::router())
        .merge(hand_layout_routes::router())
        .merge(export_routes::router())
}
