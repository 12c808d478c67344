//! Recordings before anything is learnt from them.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::Json;
use utoipa_axum::router::OpenApiRouter;
use utoipa_axum::routes;

use crate::http::app_state::AppState;
use crate::http::edge::problem_document::Problem;
use crate::http::routes::long_body::LongBody;
use service::forces::submission_reader::read_look;
use service::wire::estimator_examples as examples;
use service::wire::look_wire::{Look, LookDocument};
use service::wire::study_wire::ProblemDocument;

/// `/v1/recordings:look`.
pub(crate) fn router() -> OpenApiRouter<AppState> {
    OpenApiRouter::new().routes(routes!(look_at_recordings))
}

/// Look at recordings
///
/// What each column of recordings is taken for and what stands in it, before anything is learnt: range, noise, level without a force and its drift, gaps, samples that stand alone, columns that are hardly
/// sensors, and each column over time in at most 300 bins. A recording with faults is answered with them, and leaves the others as they are. Nothing is stored. The whole document has at most 64 MiB.
#[utoipa::path(post, path = "/v1/recordings:look", tag = "estimators",
    request_body(description = "Recordings, with a recipe where the defaults won't do", content((LookDocument = "application/json", example = json!(examples::looked_at())))),
    responses((status = 200, description = "What stands in them", body = Look),
              (status = 413, description = "The document has more than 64 MiB", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::too_large())),
              (status = 422, description = "The document has faults: all of them, each with its JSON pointer; or there are too many rows or columns", body = ProblemDocument, content_type = "application/problem+json", example = json!(examples::faults()))))]
async fn look_at_recordings(body: LongBody) -> Result<Json<Look>, Problem> {
    let (found, _held) = body.checked(read_look).await?;
    Ok(Json(found))
}
