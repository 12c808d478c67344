//! Forces from recordings.
//!
//! - [`look_routes`]: what recordings' columns are taken for
//! - [`estimator_routes`]: submit, list, look at, cancel
//! - [`learnt_routes`]: what was learnt
//! - [`stored_estimator`]: an estimator as the database has it
//! - [`apply_routes`]: estimates by it; [`zero_routes`]: the zero that they begin with

pub(crate) mod apply_routes;
pub(crate) mod estimator_routes;
pub(crate) mod learnt_routes;
pub(crate) mod look_routes;
mod stored_estimator;
pub(crate) mod zero_routes;

use utoipa_axum::router::OpenApiRouter;

use crate::http::app_state::AppState;

/// `/v1/estimators` and what is below it, and `/v1/recordings:look`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    look_routes::router()
        .merge(estimator_routes::router())
        .merge(learnt_routes::router())
        .merge(apply_routes::router())
}
