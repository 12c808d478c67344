//! Ranked locations and layouts, as they are served.
//!
//! A hash over a study's rows tells when one is missing or isn't what was written.

mod layout_rows;
mod location_rows;

use placement::result::{RankedLayout, RankedLocation};
use serde::{Deserialize, Serialize};
use sqlx::SqliteConnection;

use self::layout_rows::LayoutRow;
use self::location_rows::{LocationRow, ScoreRow};
use crate::content::sha256;
use crate::store_error::StoreError;

/// What a result ranks.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Ranked {
    /// Best first.
    pub locations: Vec<RankedLocation>,
    /// Best first.
    pub layouts: Vec<RankedLayout>,
}

/// Stores what the result of a study ranks.
///
/// # Errors
/// When the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    locations: &[RankedLocation],
    layouts: &[RankedLayout],
) -> Result<(), StoreError> {
    for (place, location) in (1..).zip(locations) {
        location_rows::insert(connection, study, place, location).await?;
    }
    for (place, layout) in (1..).zip(layouts) {
        layout_rows::insert(connection, study, place, layout).await?;
    }
    let rows_sha256 = Rows::of(connection, study).await?.sha256();
    sqlx::query("insert into rankings (study, rows_sha256) values (?, ?)")
        .bind(study)
        .bind(rows_sha256)
        .execute(connection)
        .await?;
    Ok(())
}

/// What the result of a study ranks, when there is a result.
///
/// # Errors
/// [`StoreError::Damaged`] when rows are missing or don't match their hash; when the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<Ranked>, StoreError> {
    let query = "select rows_sha256 from results left join rankings using (study) where study = ?";
    let stored: Option<Option<String>> = sqlx::query_scalar(query)
        .bind(study)
        .fetch_optional(&mut *connection)
        .await?;
    let Some(stored) = stored else {
        return Ok(None);
    };
    let rows = Rows::of(connection, study).await?;
    let intact = stored.is_some_and(|stored| stored == rows.sha256());
    let ranked = intact.then(|| rows.ranked()).flatten();
    ranked.map(Some).ok_or_else(|| StoreError::Damaged {
        table: "rankings",
        row: study.to_owned(),
    })
}

/// All rows of a study, in order.
#[derive(Serialize)]
struct Rows {
    locations: Vec<LocationRow>,
    scores: Vec<ScoreRow>,
    layouts: Vec<LayoutRow>,
}

impl Rows {
    async fn of(connection: &mut SqliteConnection, study: &str) -> Result<Self, StoreError> {
        Ok(Self {
            locations: location_rows::of(connection, study).await?,
            scores: location_rows::scores_of(connection, study).await?,
            layouts: layout_rows::of(connection, study).await?,
        })
    }

    fn sha256(&self) -> String {
        // Columns of text and numbers are always JSON.
        let text = serde_json::to_string(self).unwrap_or_default();
        sha256(&[text.as_bytes()])
    }

    /// `None` where a row isn't one of this program's.
    fn ranked(&self) -> Option<Ranked> {
        let locations = self.locations.iter().map(|row| row.ranked(&self.scores));
        let layouts = self.layouts.iter().map(LayoutRow::ranked);
        Some(Ranked {
            locations: locations.collect::<Option<_>>()?,
            layouts: layouts.collect::<Option<_>>()?,
        })
    }
}
