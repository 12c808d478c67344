//! An estimator as the database has it: its row, what was learnt, its zero.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::http::StatusCode;
use document::fault::Fault;
use service::wire::estimator_wire::EstimatorZero;
use store::queue::estimator_parts::{self, Part};
use store::queue::estimator_rows::{self, EstimatorRow};
use store::queue::estimator_zeros;
use store::{Store, StoreError};

use crate::http::edge::problem_document::Problem;

/// The estimator of this identifier, or 404.
pub(super) async fn known(store: &Store, id: &str) -> Result<EstimatorRow, Problem> {
    let mut connection = store.read().await?;
    let row = estimator_rows::find(&mut connection, id).await?;
    row.ok_or_else(|| absent(id))
}

/// Hash of a part of what was learnt, or 409 with what became of the estimator.
pub(super) async fn ready(store: &Store, id: &str, part: Part) -> Result<String, Problem> {
    let row = known(store, id).await?;
    let mut connection = store.read().await?;
    let sha256 = estimator_parts::part_sha256(&mut connection, id, part).await?;
    sha256.ok_or_else(|| {
        let error = row.error.as_deref();
        let cause = error.map_or(String::new(), |error| format!(": {error}"));
        let (state, what) = (row.state().as_str(), nameable(part));
        Problem::new(
            StatusCode::CONFLICT,
            format!("the estimator is {state} and has no {what}{cause}"),
        )
    })
}

fn nameable(part: Part) -> &'static str {
    match part {
        Part::Report => "report",
        Part::Model => "model",
        Part::LeftOut => "rows that were left out",
    }
}

/// A part of what was learnt, or 404 when it was removed meanwhile.
pub(super) async fn text(store: &Store, id: &str, part: Part) -> Result<String, Problem> {
    let mut connection = store.read().await?;
    let text = estimator_parts::part(&mut connection, id, part).await?;
    text.ok_or_else(|| absent(id))
}

/// The zero that an estimator was given.
///
/// # Errors
/// When it can't be read.
pub(super) async fn zero_of(store: &Store, id: &str) -> Result<Option<EstimatorZero>, StoreError> {
    let mut connection = store.read().await?;
    let document = estimator_zeros::zero(&mut connection, id).await?;
    let read = |document: String| {
        serde_json::from_str(&document).map_err(|_| StoreError::Damaged {
            table: "estimator_zeros",
            row: id.to_owned(),
        })
    };
    document.map(read).transpose()
}

/// Refuses an identifier that no estimator has.
pub(super) fn absent(id: &str) -> Problem {
    Problem::not_found(format!("there is no estimator {id:?}"))
}

/// Answer to a panic.
pub(super) fn broken() -> Problem {
    Problem::new(
        StatusCode::INTERNAL_SERVER_ERROR,
        "the service has a fault; its log says where",
    )
}

/// Refuses a stored model that can't be read.
pub(super) fn unusable(faults: &[Fault]) -> Problem {
    let faults: Vec<String> = faults.iter().map(Fault::to_string).collect();
    Problem::new(
        StatusCode::CONFLICT,
        format!(
            "the estimator can't be used any more, so learn it anew: {}",
            faults.join("; ")
        ),
    )
}
