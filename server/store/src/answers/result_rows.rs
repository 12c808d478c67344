//! Results. The map, which is most of one, is kept apart, so that all else is read without it.

use std::borrow::Cow;

use placement::compare::Comparable;
use results::StudyResult;
use serde::de::DeserializeOwned;
use sqlx::sqlite::SqliteRow;
use sqlx::{Row, SqliteConnection};

use crate::answers::{content_hash, extracts};
use crate::clock::now;
use crate::column::{counted, whole};
use crate::content::{encode, sha256};
use crate::seals;
use crate::store_error::StoreError;

const RESULT: &str = "the result of a study";
/// Text that stands in a document where its map was.
pub(super) const NO_MAP: &str = "null";

/// Stores the result of a study.
///
/// # Errors
/// [`StoreError::NotFinite`] when a number isn't finite; when the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    result: &StudyResult,
) -> Result<(), StoreError> {
    let mut document = encode(RESULT, result)?;
    let content = match content_hash::of_text(&document, result)? {
        Some(content) => content,
        None => content_hash::of(result)?,
    };
    let map = take_map(&mut document, result);
    let taken = map.as_ref().map(|(place, map)| Taken {
        place: *place,
        sha256: sha256(&[study.as_bytes(), map.as_bytes()]),
    });
    let inserted = sqlx::query(
        "insert into results (study, document, map_place, map_sha256, document_sha256, content_sha256, created, brief)
         values (?, ?, ?, ?, ?, ?, ?, ?) on conflict do nothing",
    )
    .bind(study)
    .bind(&document)
    .bind(taken.as_ref().map(|taken| whole(taken.place)))
    .bind(taken.as_ref().map(|taken| &taken.sha256))
    .bind(document_sha256(study, &document, taken.as_ref()))
    .bind(content)
    .bind(now())
    .bind(brief(result))
    .execute(&mut *connection)
    .await?;
    if inserted.rows_affected() == 0 {
        return Ok(());
    }
    extracts::insert(connection, study, result).await?;
    let Some((_, map)) = map else {
        return Ok(());
    };
    sqlx::query("insert into result_maps (study, document) values (?, ?)")
        .bind(study)
        .bind(map)
        .execute(connection)
        .await?;
    Ok(())
}

/// The short answer, which lists show.
fn brief(result: &StudyResult) -> Option<&str> {
    result.answer.as_ref()?.brief.as_deref()
}

/// Takes the map out of a result's text, and returns the place where it stood.
fn take_map(text: &mut String, result: &StudyResult) -> Option<(usize, String)> {
    let map = serde_json::to_string(result.map.as_ref()?).ok()?;
    let field = "\"map\":";
    // Quotes within strings are escaped: what looks like the field is the field.
    let place = text.find(&format!("{field}{map}"))? + field.len();
    text.replace_range(place..place + map.len(), NO_MAP);
    Some((place, map))
}

/// Map that was taken out of a document, as the document's hash knows it.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct Taken {
    /// Byte of the document where it stood.
    pub(super) place: usize,
    pub(super) sha256: String,
}

impl Taken {
    /// Reads it from columns, which are null where there is no map.
    pub(super) fn of(place: Option<i64>, sha256: Option<String>) -> Option<Self> {
        Some(Self {
            place: place.and_then(counted)?,
            sha256: sha256?,
        })
    }

    pub(super) fn place_bytes(&self) -> [u8; 8] {
        (self.place as u64).to_le_bytes()
    }
}

/// Hashes a row of the table: study and document, and, where a map was taken out, where it stood and its own hash.
fn document_sha256(study: &str, document: &str, taken: Option<&Taken>) -> String {
    let parts = [study.as_bytes(), document.as_bytes()];
    match taken {
        Some(taken) => {
            let map = [&taken.place_bytes()[..], taken.sha256.as_bytes()];
            sha256(&[parts, map].concat())
        }
        None => sha256(&parts),
    }
}

/// Extent of what is read of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// Whole result.
    Whole,
    /// Result without its map, which is null.
    WithoutMap,
}

/// The row of a result, as SQLite gave it: its text is read where it lies.
pub struct ResultRow {
    study: String,
    extent: Extent,
    row: SqliteRow,
}

/// The row of a study's result, when there is one.
///
/// # Errors
/// When the database can't be read.
pub async fn row(
    connection: &mut SqliteConnection,
    study: &str,
    extent: Extent,
) -> Result<Option<ResultRow>, StoreError> {
    let query = match extent {
        Extent::Whole => {
            "select r.document, map_place, map_sha256, document_sha256, content_sha256, brief, m.document
             from results r left join result_maps m using (study) where study = ?"
        }
        Extent::WithoutMap => {
            "select document, map_place, map_sha256, document_sha256, content_sha256, brief, null from results where study = ?"
        }
    };
    seals::intact(connection, "results", "study = ?", study).await?;
    let row = sqlx::query(query)
        .bind(study)
        .fetch_optional(connection)
        .await?;
    Ok(row.map(|row| ResultRow {
        study: study.to_owned(),
        extent,
        row,
    }))
}

impl ResultRow {
    /// The result, or the part `R` of it, and the hash of its content.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when the row, or its map, doesn't match its hash.
    pub fn read<R: DeserializeOwned>(self) -> Result<(R, String), StoreError> {
        let result = serde_json::from_str(&self.text()?);
        let result = result.map_err(|_| damaged(&self.study))?;
        Ok((result, self.content_sha256()?))
    }

    /// The result, whose content has the hash that is stored, and which lists show by its own short answer.
    fn checked(&self) -> Result<StudyResult, StoreError> {
        let (text, stored) = (self.text()?, self.content_sha256()?);
        let result = serde_json::from_str(&text).map_err(|_| damaged(&self.study))?;
        let is_content = content_hash::of_text(&text, &result)?.as_ref() == Some(&stored)
            || content_hash::of(&result)? == stored;
        match is_content && self.row.try_get::<Option<&str>, _>(5)? == brief(&result) {
            true => Ok(result),
            false => Err(damaged(&self.study)),
        }
    }

    fn content_sha256(&self) -> Result<String, StoreError> {
        Ok(self.row.try_get(4)?)
    }

    /// The text of the result, or of its part without the map, which match their hashes.
    fn text(&self) -> Result<Cow<'_, str>, StoreError> {
        let document = self.row.try_get::<&str, _>(0)?;
        let taken = Taken::of(self.row.try_get(1)?, self.row.try_get(2)?);
        let stored = self.row.try_get::<&str, _>(3)?;
        if document_sha256(&self.study, document, taken.as_ref()) != stored {
            return Err(damaged(&self.study));
        }
        Ok(match taken.filter(|_| self.extent == Extent::Whole) {
            Some(taken) => Cow::Owned(self.with_map(document, &taken)?),
            None => Cow::Borrowed(document),
        })
    }

    fn with_map(&self, document: &str, taken: &Taken) -> Result<String, StoreError> {
        let map: Option<&str> = self.row.try_get(6)?;
        let intact = |map: &&str| sha256(&[self.study.as_bytes(), map.as_bytes()]) == taken.sha256;
        let map = map.filter(intact).ok_or_else(|| lost_map(&self.study))?;
        let mut whole = String::with_capacity(document.len() + map.len());
        whole.push_str(&document[..taken.place]);
        whole.push_str(map);
        whole.push_str(&document[taken.place + NO_MAP.len()..]);
        Ok(whole)
    }
}

/// Checks a study's whole result, also the hash of its content.
///
/// # Errors
/// [`StoreError::Damaged`] when something doesn't match; when the database can't be read.
pub(crate) async fn check(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<(), StoreError> {
    let Some(row) = row(&mut *connection, study, Extent::Whole).await? else {
        return Ok(());
    };
    let result = row.checked()?;
    extracts::check(connection, study, &result).await
}

/// The result of a study or the part `R` of it, and the hash of its content.
///
/// # Errors
/// [`StoreError::Damaged`] when the row doesn't match its hash; when the database can't be read.
pub async fn find<R: DeserializeOwned>(
    connection: &mut SqliteConnection,
    study: &str,
    extent: Extent,
) -> Result<Option<(R, String)>, StoreError> {
    row(connection, study, extent)
        .await?
        .map(ResultRow::read)
        .transpose()
}

/// The part of a study's result that a comparison reads, when there is a result.
///
/// # Errors
/// [`StoreError::Damaged`] when it doesn't match its hash; when the database can't be read.
pub async fn comparable(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<Comparable>, StoreError> {
    if let Some(part) = extracts::find(connection, study).await? {
        return Ok(Some(part));
    }
    let found = find::<StudyResult>(connection, study, Extent::WithoutMap).await?;
    Ok(found.map(|(result, _)| Comparable::of(&result)))
}

pub(super) fn damaged(study: &str) -> StoreError {
    StoreError::Damaged {
        table: "results",
        row: study.to_owned(),
    }
}

pub(super) fn lost_map(study: &str) -> StoreError {
    StoreError::Damaged {
        table: "result_maps",
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::tests::fresh;
    use crate::queue::study_rows;

    #[tokio::test]
    async fn an_extract_is_what_the_document_says_and_a_changed_one_is_refused() {
        let (_folder, store) = fresh().await;
        let mut tx = store.begin().await.expect("begins");
        let id = study_rows::insert(&mut tx, "a", "{}")
            .await
            .expect("inserts");
        let mut result = StudyResult::default();
        result.model.level = "coarse".to_owned();
        let stored = insert(&mut tx, &id, &result).await;
        stored.expect("stores");
        let expected = Comparable::of(&result);
        assert_eq!(
            comparable(&mut tx, &id).await.expect("reads"),
            Some(expected.clone())
        );
        check(&mut tx, &id).await.expect("whole");

        // A later version's is left alone, by reading and by checking.
        for change in [
            "update result_extracts set format = 2",
            "delete from result_extracts",
        ] {
            let changed = sqlx::query(change).execute(&mut *tx).await;
            assert_eq!(changed.expect("changes").rows_affected(), 1);
            assert_eq!(
                comparable(&mut tx, &id).await.expect("reads"),
                Some(expected.clone())
            );
            check(&mut tx, &id).await.expect("whole");
        }

        // Its hash is right, and it isn't the result's.
        result.model.level = "fine".to_owned();
        extracts::insert(&mut tx, &id, &result)
            .await
            .expect("stores");
        let checked = check(&mut tx, &id).await;
        assert!(matches!(
            checked,
            Err(StoreError::Damaged {
                table: "result_extracts",
                ..
            })
        ));
        let changed =
            sqlx::query("update result_extracts set document = replace(document, 'fine', 'good')");
        changed.execute(&mut *tx).await.expect("changes");
        assert!(comparable(&mut tx, &id).await.is_err());
    }
}
