//! Evaluations that answer for the points of a study's plan.

use serde_json::{Value, json};
use sqlx::SqliteConnection;

use crate::column::{counted, whole};
use crate::content::sha256;
use crate::store_error::StoreError;

/// Notes that those of these keys that have an evaluation answer for a study's ordinals from `first` on; returns for how many
/// of them that wasn't known.
///
/// # Errors
/// When the database can't be written.
pub async fn link(
    connection: &mut SqliteConnection,
    study: &str,
    first: usize,
    keys: &[String],
) -> Result<u64, StoreError> {
    let points = keys.iter().enumerate();
    let points = points.map(|(place, key)| (first + place, key.as_str()));
    insert(connection, study, points).await
}

/// Lets a study share all points of another one; returns how many points it has then.
///
/// # Errors
/// [`StoreError::Damaged`] when a row of the other study doesn't match its hash; when the database can't be written.
pub async fn share(
    connection: &mut SqliteConnection,
    from: &str,
    to: &str,
) -> Result<usize, StoreError> {
    let points = of(connection, from).await?;
    let shared = points.iter().map(|(ordinal, key)| (*ordinal, key.as_str()));
    insert(connection, to, shared).await?;
    Ok(of(connection, to).await?.len())
}

async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    points: impl Iterator<Item = (usize, &str)>,
) -> Result<u64, StoreError> {
    let row = |(ordinal, key)| {
        let ordinal = whole(ordinal);
        json!([ordinal, key, row_sha256(study, ordinal, key)])
    };
    let rows: Value = points.map(row).collect();
    let query = "insert into study_points (study, ordinal, evaluation, sha256)
                 select ?1, point.value ->> 0, e.key, point.value ->> 2
                 from json_each(?2) point join evaluations e on e.key = point.value ->> 1
                 where true on conflict do nothing";
    let inserted = sqlx::query(query)
        .bind(study)
        .bind(rows.to_string())
        .execute(connection)
        .await?;
    Ok(inserted.rows_affected())
}

/// The points of a study that have an evaluation, in order: ordinal and key.
///
/// # Errors
/// [`StoreError::Damaged`] when a row doesn't match its hash; when the database can't be read.
pub async fn of(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Vec<(usize, String)>, StoreError> {
    let query =
        "select ordinal, evaluation, sha256 from study_points where study = ? order by ordinal";
    let rows: Vec<(i64, String, String)> = sqlx::query_as(query)
        .bind(study)
        .fetch_all(connection)
        .await?;
    let point = |(ordinal, key, stored): (i64, String, String)| {
        let ordinal = checked(study, ordinal, &key, &stored)?;
        Ok((ordinal, key))
    };
    rows.into_iter().map(point).collect()
}

/// Studies, or this one, that count more points than they have with an evaluation: identifier, points counted, points there. A point whose solve broke counts, and
/// leaves an event alone.
///
/// # Errors
/// When the database can't be read.
pub(crate) async fn short(
    connection: &mut SqliteConnection,
    study: Option<&str>,
) -> Result<Vec<(String, i64, i64)>, StoreError> {
    let query = "select id, points_done,
             (select count(*) from study_points join evaluations on key = evaluation where study = id)
             + (select count(distinct payload ->> 'ordinal') from events
                where study = studies.id and kind = 'point-failed' and not exists
                    (select 1 from study_points where study = events.study and ordinal = events.payload ->> 'ordinal'))
             as points
         from studies where (?1 is null or id = ?1) and points_done > points";
    Ok(sqlx::query_as(query)
        .bind(study)
        .fetch_all(connection)
        .await?)
}

/// Points of this study that aren't there any more.
pub(crate) fn lost(study: &str) -> StoreError {
    StoreError::Damaged {
        table: "study_points",
        row: study.to_owned(),
    }
}

/// The ordinal of a row that matches its hash.
///
/// # Errors
/// [`StoreError::Damaged`] when it doesn't.
pub(crate) fn checked(
    study: &str,
    ordinal: i64,
    key: &str,
    stored: &str,
) -> Result<usize, StoreError> {
    let intact = stored == row_sha256(study, ordinal, key);
    let found = counted(ordinal).filter(|_| intact);
    found.ok_or_else(|| StoreError::Damaged {
        table: "study_points",
        row: format!("{study} {ordinal}"),
    })
}

fn row_sha256(study: &str, ordinal: i64, key: &str) -> String {
    sha256(&[study.as_bytes(), &ordinal.to_le_bytes(), key.as_bytes()])
}
