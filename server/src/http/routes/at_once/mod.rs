//! Answers at once, stored nowhere.
//!
//! - `preview_routes`: places of a document
//! - `scene_routes`: one equilibrium

mod preview_routes;
mod scene_routes;

use utoipa_axum::router::OpenApiRouter;

use crate::http::app_state::AppState;

/// `/v1/studies:preview` and `/v1/scenes:solve`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    preview_routes::router().merge(scene_routes::router())
}
