//! Answers taken from another study of the same document.
//!
//! A result is a function of the study's document, of the solver and of the analysis, whose sources its version names. Where a study of the same
//! document and version is done, and every one of its points is stored, there is nothing left to compute.

use documents::study::{Accuracy, Study};
use results::{StudyCost, StudyResult};
use sqlx::SqliteConnection;

use store::answers::result_rows::{self, Extent};
use store::points::study_points;
use store::queue::study_rows::{self, StudyRow};
use store::{Store, StoreError};

/// An answer that was there already.
pub struct Answered {
    /// The result, as this study's; its cost is still the other one's but for `reused`.
    pub result: StudyResult,
    /// Points that this study now shares with the other one.
    pub points: usize,
}

/// Finds the answer to a study, and notes that it shares the points.
///
/// # Errors
/// When the database can't be read or written.
pub async fn answered(
    store: &Store,
    row: &StudyRow,
    study: &Study,
    version: &str,
) -> Result<Option<Answered>, StoreError> {
    // What a budget buys depends on the hour.
    if matches!(study.accuracy, Accuracy::Budget(_)) {
        return Ok(None);
    }
    let found = {
        let mut connection = store.read().await?;
        result_of_twin(&mut connection, row, version).await?
    };
    let Some((twin, mut result)) = found else {
        return Ok(None);
    };
    let mut transaction = store.begin().await?;
    if study_rows::find(&mut transaction, &twin).await?.is_none() {
        // It was removed meanwhile, and its points may be on their way out.
        return Ok(None);
    }
    let points = study_points::share(&mut transaction, &twin, &row.id).await?;
    store.commit(transaction, 0).await?;
    result.study.id.clone_from(&row.id);
    result.cost = StudyCost {
        reused: result.cost.solves,
        rungs_wall_s: vec![0.0; result.cost.rungs_wall_s.len()],
        ..result.cost
    };
    Ok(Some(Answered { result, points }))
}

async fn result_of_twin(
    connection: &mut SqliteConnection,
    row: &StudyRow,
    version: &str,
) -> Result<Option<(String, StudyResult)>, StoreError> {
    let Some(twin) = study_rows::answered_twin(connection, &row.id, &row.spec_sha256).await? else {
        return Ok(None);
    };
    match result_rows::find::<StudyResult>(connection, &twin, Extent::Whole).await {
        Ok(Some((result, _))) if is_of(&result, row, version) => Ok(Some((twin, result))),
        Ok(_) => Ok(None),
        Err(error @ StoreError::Damaged { .. }) => {
            tracing::warn!(%error, "the study is computed again from its points");
            Ok(None)
        }
        Err(error) => Err(error),
    }
}

/// Whether a result was made from the document of a study by this version.
fn is_of(result: &StudyResult, row: &StudyRow, version: &str) -> bool {
    result.study.spec_sha256 == row.spec_sha256 && result.study.version == version
}
