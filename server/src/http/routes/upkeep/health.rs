//! Is the service up, and can it work.

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::problem_document::Problem;
use service::wire::examples;
use service::wire::study_wire::{Health, ProblemDocument, Readiness};
use store::StoreError;
use store::queue::turns;

/// `/healthz` and `/readyz`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new()
        .routes(routes!(alive))
        .routes(routes!(ready))
}

/// Is the service up
///
/// It answers, whether or not it can work.
#[utoipa::path(get, path = "/healthz", tag = "service", security(()),
    responses((status = 200, description = "It is", body = Health)))]
async fn alive() -> Json<Health> {
    Json(Health {
        status: "ok".to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
    })
}

/// Can the service work
///
/// Its database answers.
#[utoipa::path(get, path = "/readyz", tag = "service", security(()),
    responses((status = 200, description = "It can", body = Readiness),
              (status = 503, description = "Its database doesn't answer", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unready()))))]
async fn ready(State(state): State<AppState>) -> Result<Json<Readiness>, Problem> {
    let readable = async {
        let mut connection = state.store.read().await?;
        turns::next(&mut connection).await
    };
    readable.await.map_err(|error: StoreError| {
        if matches!(error, StoreError::Gone { .. }) {
            return error.into();
        }
        tracing::error!(%error, "the service is not ready");
        let detail = "the database does not answer; the service's log says why";
        Problem::new(StatusCode::SERVICE_UNAVAILABLE, detail)
    })?;
    Ok(Json(Readiness {
        status: "ready".to_owned(),
    }))
}
