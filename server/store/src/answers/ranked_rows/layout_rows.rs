//! Ranked layouts.

use placement::result::{LayoutScore, RankedLayout};
use serde::Serialize;
use sqlx::SqliteConnection;

use crate::column::{counted, whole};
use crate::content::encode;
use crate::row::from_row;
use crate::store_error::StoreError;

#[derive(Serialize)]
pub(super) struct LayoutRow {
    rank: i64,
    spacing_deg: f64,
    units: i64,
    position: String,
    films: String,
    weakest_signal: Option<f64>,
    worst_angle_error_deg: Option<f64>,
    rms_angle_error_deg: Option<f64>,
    worst_depth_error_mm: Option<f64>,
    noise_strain: f64,
    reason: Option<String>,
    /// The whole layout, JSON; rows of earlier versions have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    details: Option<String>,
}

from_row!(LayoutRow {
    rank,
    spacing_deg,
    units,
    position,
    films,
    weakest_signal,
    worst_angle_error_deg,
    rms_angle_error_deg,
    worst_depth_error_mm,
    noise_strain,
    reason,
    details
});

pub(super) async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    place: i64,
    layout: &RankedLayout,
) -> Result<(), StoreError> {
    sqlx::query(
        "insert into layouts (study, rank, spacing_deg, units, position, films, weakest_signal,
             worst_angle_error_deg, rms_angle_error_deg, worst_depth_error_mm, noise_strain, reason, details)
         values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
    )
    .bind(study)
    .bind(place)
    // A layout without units has none; its details say so.
    .bind(layout.spacing_deg.unwrap_or(0.0))
    .bind(whole(layout.units))
    .bind(&layout.position)
    .bind(encode("the films of a layout", &layout.films)?)
    .bind(layout.score.weakest_signal)
    .bind(layout.score.worst_angle_error_deg)
    .bind(layout.score.rms_angle_error_deg)
    .bind(layout.score.worst_depth_error_mm)
    .bind(layout.score.noise_strain)
    .bind(layout.score.reason.as_deref())
    .bind(encode("a layout", layout)?)
    .execute(connection)
    .await?;
    Ok(())
}

pub(super) async fn of(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Vec<LayoutRow>, StoreError> {
    let query =
        "select rank, spacing_deg, units, position, films, weakest_signal, worst_angle_error_deg,
                     rms_angle_error_deg, worst_depth_error_mm, noise_strain, reason, details
                 from layouts where study = ? order by rank";
    Ok(sqlx::query_as(query)
        .bind(study)
        .fetch_all(connection)
        .await?)
}

impl LayoutRow {
    pub(super) fn ranked(&self) -> Option<RankedLayout> {
        if let Some(details) = &self.details {
            return serde_json::from_str(details).ok();
        }
        Some(RankedLayout {
            rank: counted(self.rank)?,
            spacing_deg: Some(self.spacing_deg),
            units: counted(self.units)?,
            position: self.position.clone(),
            films: serde_json::from_str(&self.films).ok()?,
            score: LayoutScore {
                weakest_signal: self.weakest_signal,
                worst_angle_error_deg: self.worst_angle_error_deg,
                rms_angle_error_deg: self.rms_angle_error_deg,
                worst_depth_error_mm: self.worst_depth_error_mm,
                noise_strain: self.noise_strain,
                reason: self.reason.clone(),
                ..LayoutScore::default()
            },
            ..RankedLayout::default()
        })
    }
}
