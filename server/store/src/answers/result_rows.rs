//! Results with their ranked rows.

use fem_client::solver::direction::Direction;
use placement::result::{RankedLayout, RankedLocation, StudyCost, StudyResult};
use placement::score::location_scores::{GSI, MDRM_GSI, MEAN_GSI, OWN_GSI};
use serde::de::DeserializeOwned;
use sqlx::SqliteConnection;

use crate::clock::now;
use crate::content::{encode, sha256};
use crate::store_error::StoreError;

const RESULT: &str = "the result of a study";

/// Stores the result of a study with its ranked rows.
///
/// # Errors
/// [`StoreError::NotFinite`] when a number isn't finite; when the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    result: &StudyResult,
) -> Result<(), StoreError> {
    let document = encode(RESULT, result)?;
    sqlx::query(
        "insert into results (study, document, document_sha256, content_sha256, created) values (?, ?, ?, ?, ?)
         on conflict do nothing",
    )
    .bind(study)
    .bind(&document)
    .bind(sha256(&[study.as_bytes(), document.as_bytes()]))
    .bind(content_sha256(result)?)
    .bind(now())
    .execute(&mut *connection)
    .await?;
    for location in &result.locations {
        insert_location(connection, study, location).await?;
    }
    for layout in &result.layouts {
        insert_layout(connection, study, layout).await?;
    }
    Ok(())
}

/// SHA-256 of what a result says: without what it cost, what it was expected to cost, and without the identifier of its study, so that equal
/// documents give equal hashes in any database, on any number of threads, with any history of interruptions.
fn content_sha256(result: &StudyResult) -> Result<String, StoreError> {
    let mut content = result.clone();
    content.cost = StudyCost::default();
    content.estimate = None;
    content.study.id.clear();
    let text =
        serde_json::to_string(&content).map_err(|_| StoreError::NotFinite { what: RESULT })?;
    Ok(sha256(&[text.as_bytes()]))
}

/// The result of a study as its JSON text, and the hash of its content.
///
/// # Errors
/// [`StoreError::Damaged`] when the row doesn't match its hash; when the database can't be read.
pub async fn find_text(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<(String, String)>, StoreError> {
    let query = "select document, document_sha256, content_sha256 from results where study = ?";
    let row: Option<(String, String, String)> = sqlx::query_as(query)
        .bind(study)
        .fetch_optional(connection)
        .await?;
    let Some((document, stored, content)) = row else {
        return Ok(None);
    };
    if sha256(&[study.as_bytes(), document.as_bytes()]) != stored {
        return Err(damaged(study));
    }
    Ok(Some((document, content)))
}

/// The result of a study, or the part `R` of it, and the hash of its content.
///
/// # Errors
/// As for [`find_text`].
pub async fn find<R: DeserializeOwned>(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<(R, String)>, StoreError> {
    let Some((document, content)) = find_text(connection, study).await? else {
        return Ok(None);
    };
    let result = serde_json::from_str(&document).map_err(|_| damaged(study))?;
    Ok(Some((result, content)))
}

fn damaged(study: &str) -> StoreError {
    StoreError::Damaged {
        table: "results",
        row: study.to_owned(),
    }
}

/// The hash of the content of a study's result, when there is one.
///
/// # Errors
/// When the database can't be read.
pub async fn sha256_of(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<String>, StoreError> {
    Ok(
        sqlx::query_scalar("select content_sha256 from results where study = ?")
            .bind(study)
            .fetch_optional(connection)
            .await?,
    )
}

async fn insert_location(
    connection: &mut SqliteConnection,
    study: &str,
    location: &RankedLocation,
) -> Result<(), StoreError> {
    sqlx::query(
        "insert into locations (study, name, rank, gsi_x_percent, gsi_y_percent, mean_gsi_x_percent,
             mean_gsi_y_percent, own_gsi_x_percent, own_gsi_y_percent, mdrm_gsi_x_percent, mdrm_gsi_y_percent,
             rank_x, rank_y, rank_certain)
         values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) on conflict do nothing",
    )
    .bind(study)
    .bind(&location.name)
    .bind(whole(location.rank))
    .bind(location.value(GSI, Direction::X))
    .bind(location.value(GSI, Direction::Y))
    .bind(location.value(MEAN_GSI, Direction::X))
    .bind(location.value(MEAN_GSI, Direction::Y))
    .bind(location.value(OWN_GSI, Direction::X))
    .bind(location.value(OWN_GSI, Direction::Y))
    .bind(location.value(MDRM_GSI, Direction::X))
    .bind(location.value(MDRM_GSI, Direction::Y))
    .bind(location.ranks.x.map(whole))
    .bind(location.ranks.y.map(whole))
    .bind(location.rank_certain)
    .execute(connection)
    .await?;
    Ok(())
}

async fn insert_layout(
    connection: &mut SqliteConnection,
    study: &str,
    layout: &RankedLayout,
) -> Result<(), StoreError> {
    sqlx::query(
        "insert into layouts (study, rank, spacing_deg, units, position, films, weakest_signal,
             worst_angle_error_deg, rms_angle_error_deg, worst_depth_error_mm, noise_strain, reason)
         values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) on conflict do nothing",
    )
    .bind(study)
    .bind(whole(layout.rank))
    .bind(layout.spacing_deg)
    .bind(whole(layout.units))
    .bind(&layout.position)
    .bind(encode("the films of a layout", &layout.films)?)
    .bind(layout.score.weakest_signal)
    .bind(layout.score.worst_angle_error_deg)
    .bind(layout.score.rms_angle_error_deg)
    .bind(layout.score.worst_depth_error_mm)
    .bind(layout.score.noise_strain)
    .bind(layout.score.reason.as_deref())
    .execute(connection)
    .await?;
    Ok(())
}

fn whole(number: usize) -> i64 {
    i64::try_from(number).unwrap_or(i64::MAX)
}
