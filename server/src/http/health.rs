//! Is the service up, and can it work.

use axum::extract::State;
use axum::routing::get;
use axum::{Json, Router};
use serde_json::{Value, json};

use super::AppState;
use super::problem::Problem;
use crate::store::studies;

/// `/healthz` and `/readyz`.
pub fn router() -> Router<AppState> {
    Router::new()
        .route("/healthz", get(alive))
        .route("/readyz", get(ready))
}

async fn alive() -> Json<Value> {
    Json(json!({"status": "ok", "version": env!("CARGO_PKG_VERSION")}))
}

/// Ready means that the database answers.
async fn ready(State(state): State<AppState>) -> Result<Json<Value>, Problem> {
    let mut connection = state.store.read().await?;
    studies::oldest_queued(&mut connection).await?;
    Ok(Json(json!({"status": "ready"})))
}
