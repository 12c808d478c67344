//! The zero of an estimator: what its signals are without a force, given after it was learnt.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use serde_json::Value;

use crate::http::app_state::AppState;
use crate::http::edge::extract::EstimatorPath;
use crate::http::edge::problem_document::Problem;
use crate::http::routes::estimators::stored_estimator::{absent, broken, ready, text, unusable};
use crate::http::routes::long_body::LongBody;
use service::forces::applying::measured_zero;
use service::forces::model_file::read_model;
use service::forces::recorded_texts::NamedText;
use service::forces::submission_reader::{of_recording, read_recording};
use service::wire::estimator_examples as examples;
use service::wire::estimator_wire::{EstimatorZero, ZeroDocument};
use service::wire::study_wire::ProblemDocument;
use store::Store;
use store::clock::now;
use store::content::encode;
use store::queue::estimator_parts::Part;
use store::queue::{estimator_rows, estimator_zeros};

/// Give an estimator its zero
///
/// Takes a recording without load. The signals' medians are the zero of all recordings that are estimated from then on, however these begin. An empty document, `{}`, forgets it:
/// recordings then begin as they did when the estimator was learnt. The model file stays as it is. The whole document has at most 64 MiB.
#[utoipa::path(post, path = "/v1/estimators/{id}:zero", tag = "estimators", params(EstimatorPath),
    request_body(description = "A recording without load, or an empty document", content((ZeroDocument = "application/json", example = json!(examples::unmeasured())))),
    responses((status = 200, description = "The zero", body = EstimatorZero),
              (status = 204, description = "Forgotten"),
              (status = 404, description = "There is no such estimator", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::absent())),
              (status = 409, description = "It isn't done; the detail says what became of it", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::unlearnt())),
              (status = 413, description = "The document has more than 64 MiB", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::too_large())),
              (status = 422, description = "The recording has faults: all of them, with line and column; or a force acts in all its rows", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
pub(super) async fn zero_estimator(
    state: AppState,
    id: String,
    body: LongBody,
) -> Result<Response, Problem> {
    ready(&state.store, &id, Part::Model).await?;
    let read = |document: Value| match document.as_object() {
        Some(fields) if fields.is_empty() => Ok(None),
        _ => read_recording(document).map(Some),
    };
    let (recording, _held) = body.checked(read).await?;
    let Some(recording) = recording else {
        keep(&state.store, &id, None).await?;
        return Ok(StatusCode::NO_CONTENT.into_response());
    };
    let model = text(&state.store, &id, Part::Model).await?;
    // A model and a recording may be long: other answers have their threads meanwhile.
    let measured = tokio::task::spawn_blocking(move || measured(&model, recording));
    let zero = measured.await.unwrap_or_else(|_| Err(broken()))?;
    keep(&state.store, &id, Some(&encode("a zero", &zero)?)).await?;
    tracing::info!(estimator = id, file = ?zero.file, "estimator zeroed");
    Ok(Json(zero).into_response())
}

fn measured(model: &str, recording: NamedText) -> Result<EstimatorZero, Problem> {
    let estimator = read_model(model).map_err(|faults| unusable(&faults))?;
    let zero = measured_zero(&estimator, &recording.name, &recording.text)
        .map_err(|faults| Problem::faults(of_recording(faults)))?;
    Ok(EstimatorZero {
        file: recording.name,
        set: now(),
        signals: estimator.columns.signals,
        zero,
    })
}

/// Keeps the zero of an estimator, or none; 404 when it was removed meanwhile.
async fn keep(store: &Store, id: &str, zero: Option<&str>) -> Result<(), Problem> {
    let mut transaction = store.begin().await?;
    if estimator_rows::find(&mut transaction, id).await?.is_none() {
        return Err(absent(id));
    }
    match zero {
        Some(zero) => estimator_zeros::set(&mut transaction, id, zero).await?,
        None => estimator_zeros::forget(&mut transaction, id).await?,
    }
    store.commit(transaction, 0).await?;
    Ok(())
}
