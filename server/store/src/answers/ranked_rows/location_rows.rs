//! Ranked locations with their scores.

use fem_client::solver::direction::Direction;
use placement::result::RankedLocation;
use placement::score::location_scores::{Figure, LocationScores, SCORES};
use serde::Serialize;
use sqlx::SqliteConnection;

use crate::column::{counted, whole};
use crate::row::from_row;
use crate::store_error::StoreError;

#[derive(Serialize)]
pub(super) struct LocationRow {
    rank: i64,
    name: String,
    input: Option<String>,
    rank_x: Option<i64>,
    rank_y: Option<i64>,
    rank_certain: bool,
    /// Where it isn't the row's place; left out of the hash there, which earlier versions made without it.
    #[serde(skip_serializing_if = "Option::is_none")]
    shared_rank: Option<i64>,
}

from_row!(LocationRow {
    rank,
    name,
    input,
    rank_x,
    rank_y,
    rank_certain,
    shared_rank
});

#[derive(Serialize)]
pub(super) struct ScoreRow {
    rank: i64,
    score: String,
    direction: String,
    value: Option<f64>,
    error: Option<f64>,
}

from_row!(ScoreRow {
    rank,
    score,
    direction,
    value,
    error
});

pub(super) async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    place: usize,
    location: &RankedLocation,
) -> Result<(), StoreError> {
    sqlx::query(
        "insert into locations (study, rank, name, input, rank_x, rank_y, rank_certain, shared_rank) values (?, ?, ?, ?, ?, ?, ?, ?)",
    )
    .bind(study)
    .bind(whole(place))
    .bind(&location.name)
    .bind(location.input.as_deref())
    .bind(location.ranks.x.map(whole))
    .bind(location.ranks.y.map(whole))
    .bind(location.rank_certain)
    .bind((location.rank != place).then(|| whole(location.rank)))
    .execute(&mut *connection)
    .await?;
    for score in SCORES {
        for direction in Direction::ALL {
            sqlx::query(
                "insert into location_scores (study, rank, score, direction, value, error) values (?, ?, ?, ?, ?, ?)",
            )
            .bind(study)
            .bind(whole(place))
            .bind(score.name)
            .bind(direction.as_str())
            .bind(location.value(score, direction))
            .bind(location.error(score, direction))
            .execute(&mut *connection)
            .await?;
        }
    }
    Ok(())
}

pub(super) async fn of(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Vec<LocationRow>, StoreError> {
    let query = "select rank, name, input, rank_x, rank_y, rank_certain, shared_rank from locations where study = ? order by rank";
    Ok(sqlx::query_as(query)
        .bind(study)
        .fetch_all(connection)
        .await?)
}

pub(super) async fn scores_of(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Vec<ScoreRow>, StoreError> {
    let query = "select rank, score, direction, value, error from location_scores where study = ?
                 order by rank, score, direction";
    Ok(sqlx::query_as(query)
        .bind(study)
        .fetch_all(connection)
        .await?)
}

impl LocationRow {
    /// With the scores of its rank among those of all; earlier versions knew fewer.
    pub(super) fn ranked(&self, scores: &[ScoreRow]) -> Option<RankedLocation> {
        let figure = |name: &str, direction: Direction| {
            let row = scores.iter().find(|row| {
                (row.rank, row.score.as_str(), row.direction.as_str())
                    == (self.rank, name, direction.as_str())
            });
            row.map_or_else(Figure::default, |row| Figure {
                value: row.value,
                error: row.error,
            })
        };
        Some(RankedLocation {
            name: self.name.clone(),
            input: self.input.clone(),
            rank: counted(self.shared_rank.unwrap_or(self.rank))?,
            scores: LocationScores::of(|score, direction| figure(score.name, direction)),
            ranks: [self.rank_x, self.rank_y]
                .map(|rank| rank.and_then(counted))
                .into(),
            rank_certain: self.rank_certain,
        })
    }
}
