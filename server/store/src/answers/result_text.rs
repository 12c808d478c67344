//! Results as texts, read in pieces: one may have hundreds of megabytes.

use sqlx::SqliteConnection;

use crate::answers::result_rows::{NO_MAP, Taken, damaged, lost_map};
use crate::column::{counted, whole};
use crate::content::Digested;
use crate::row::from_row;
use crate::store_error::StoreError;

/// Row of a result without its text, which isn't read for that.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct ResultText {
    study: String,
    document_sha256: String,
    document_bytes: usize,
    map: Option<MapText>,
    /// The hash of its content.
    pub content_sha256: String,
    /// Length of the text with the map.
    pub bytes: usize,
}

/// Map as a part of the text.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct MapText {
    taken: Taken,
    bytes: usize,
}

/// The text of a study's result, when there is one.
///
/// # Errors
/// [`StoreError::Damaged`] when it is empty, or without the map that it had; when the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<ResultText>, StoreError> {
    let query = "select octet_length(r.document) as bytes, document_sha256, content_sha256, map_place, map_sha256, octet_length(m.document) as map_bytes
                 from results r left join result_maps m using (study) where study = ?";
    let row: Option<TextRow> = sqlx::query_as(query)
        .bind(study)
        .fetch_optional(connection)
        .await?;
    row.map(|row| row.text(study)).transpose()
}

struct TextRow {
    bytes: i64,
    document_sha256: String,
    content_sha256: String,
    map_place: Option<i64>,
    map_sha256: Option<String>,
    map_bytes: Option<i64>,
}

from_row!(TextRow {
    bytes,
    document_sha256,
    content_sha256,
    map_place,
    map_sha256,
    map_bytes
});

impl TextRow {
    fn text(self, study: &str) -> Result<ResultText, StoreError> {
        // No result is written as nothing.
        let bytes = counted(self.bytes).filter(|bytes| *bytes > 0);
        let document_bytes = bytes.ok_or_else(|| damaged(study))?;
        let map = match Taken::of(self.map_place, self.map_sha256) {
            None => None,
            Some(taken) => {
                if taken.place + NO_MAP.len() > document_bytes {
                    return Err(damaged(study));
                }
                let bytes = self.map_bytes.and_then(counted);
                let bytes = bytes.ok_or_else(|| lost_map(study))?;
                Some(MapText { taken, bytes })
            }
        };
        let added = map.as_ref().map_or(0, |map| map.bytes);
        let replaced = map.as_ref().map_or(0, |_| NO_MAP.len());
        Ok(ResultText {
            study: study.to_owned(),
            document_sha256: self.document_sha256,
            document_bytes,
            map,
            content_sha256: self.content_sha256,
            bytes: document_bytes - replaced + added,
        })
    }
}

impl ResultText {
    /// A reading from its beginning.
    pub fn reading(&self) -> Reading {
        let begun = |bytes: usize| {
            let mut digested = Digested::default();
            digested.begin(self.study.len());
            digested.update(self.study.as_bytes());
            digested.begin(bytes);
            digested
        };
        Reading {
            text: self.clone(),
            at: 0,
            document: begun(self.document_bytes),
            map: begun(self.map.as_ref().map_or(0, |map| map.bytes)),
        }
    }
}

/// A text that is being read, and the hashes of what was.
#[derive(Debug)]
pub struct Reading {
    text: ResultText,
    at: usize,
    document: Digested,
    map: Digested,
}

/// Stretch of the text that lies in one table: from which of its bytes on, and how many there are.
struct Stretch {
    is_map: bool,
    from: usize,
    bytes: usize,
}

impl Reading {
    /// The next piece, up to so many bytes; `None` at the end. SQLite reads the whole document or map for each.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] instead of the last piece when the whole doesn't match its hashes, and when a row is gone; when the database can't be read.
    pub async fn next(
        &mut self,
        connection: &mut SqliteConnection,
        bytes: usize,
    ) -> Result<Option<Vec<u8>>, StoreError> {
        if self.ended() {
            return Ok(None);
        }
        let mut piece = Vec::new();
        while piece.len() < bytes && !self.ended() {
            let more = self.stretch(connection, bytes - piece.len()).await?;
            if piece.is_empty() {
                piece = more;
            } else {
                piece.extend(more);
            }
        }
        if self.ended() {
            self.compare()?;
        }
        Ok(Some(piece))
    }

    /// Reads what comes next of one table, up to so many bytes.
    async fn stretch(
        &mut self,
        connection: &mut SqliteConnection,
        most: usize,
    ) -> Result<Vec<u8>, StoreError> {
        let Stretch {
            is_map,
            from,
            bytes,
        } = self.here();
        let query = if is_map {
            "select substr(cast(document as blob), ?, ?) from result_maps where study = ?"
        } else {
            "select substr(cast(document as blob), ?, ?) from results where study = ?"
        };
        let read: Option<Vec<u8>> = sqlx::query_scalar(query)
            .bind(whole(from + 1))
            .bind(whole(most.min(bytes)))
            .bind(&self.text.study)
            .fetch_optional(connection)
            .await?;
        let lost = if is_map { lost_map } else { damaged };
        let read = read.filter(|read| !read.is_empty());
        let read = read.ok_or_else(|| lost(&self.text.study))?;
        self.at += read.len();
        let digested = if is_map {
            &mut self.map
        } else {
            &mut self.document
        };
        digested.update(&read);
        let map = self.text.map.as_ref();
        if map.is_some_and(|map| map.taken.place == self.at) {
            self.document.update(NO_MAP.as_bytes());
        }
        Ok(read)
    }

    /// Finds where the next byte lies.
    fn here(&self) -> Stretch {
        let (at, document) = (self.at, self.text.document_bytes);
        let Some(MapText { taken, bytes }) = &self.text.map else {
            return Stretch {
                is_map: false,
                from: at,
                bytes: document - at,
            };
        };
        let (begin, end) = (taken.place, taken.place + bytes);
        if at < begin {
            Stretch {
                is_map: false,
                from: at,
                bytes: begin - at,
            }
        } else if at < end {
            Stretch {
                is_map: true,
                from: at - begin,
                bytes: end - at,
            }
        } else {
            let from = at - bytes + NO_MAP.len();
            Stretch {
                is_map: false,
                from,
                bytes: document - from,
            }
        }
    }

    /// Compares all that was read with its hashes.
    fn compare(&self) -> Result<(), StoreError> {
        let mut document = self.document.clone();
        if let Some(MapText { taken, .. }) = &self.text.map {
            if self.map.clone().end() != taken.sha256 {
                return Err(lost_map(&self.text.study));
            }
            for part in [&taken.place_bytes()[..], taken.sha256.as_bytes()] {
                document.begin(part.len());
                document.update(part);
            }
        }
        if document.end() != self.text.document_sha256 {
            return Err(damaged(&self.text.study));
        }
        Ok(())
    }

    /// Whether nothing is left.
    pub fn ended(&self) -> bool {
        self.at >= self.text.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::content::sha256;
    use crate::database::tests::fresh;

    const TEXT: &str = "{\"ä\": 1}";

    /// A database with a result of this text and hash.
    async fn stored(text: &str, hash: &str) -> (tempfile::TempDir, crate::Store) {
        let (folder, store) = fresh().await;
        let mut write = store.begin().await.expect("begins");
        let study = "insert into studies (id, name, spec, spec_sha256, state, created) values ('a', 'read', '{}', '', 'done', 't')";
        sqlx::query(study)
            .execute(&mut *write)
            .await
            .expect("stores");
        let result = "insert into results (study, document, document_sha256, content_sha256, created) values ('a', ?, ?, 'c', 't')";
        let inserted = sqlx::query(result).bind(text).bind(hash);
        inserted.execute(&mut *write).await.expect("stores");
        store.commit(write, 0).await.expect("commits");
        (folder, store)
    }

    /// All pieces of a size, or the fault where they end.
    async fn pieces(store: &crate::Store, size: usize) -> (Vec<u8>, Option<StoreError>) {
        let mut connection = store.read().await.expect("reads");
        let text = find(&mut connection, "a").await.expect("reads");
        let mut reading = text.expect("is there").reading();
        let mut read = Vec::new();
        loop {
            match reading.next(&mut connection, size).await {
                Ok(Some(piece)) => read.extend(piece),
                Ok(None) => return (read, None),
                Err(error) => return (read, Some(error)),
            }
        }
    }

    #[tokio::test]
    async fn the_pieces_of_a_text_are_the_text_wherever_they_are_cut() {
        let (_folder, store) = stored(TEXT, &sha256(&[b"a", TEXT.as_bytes()])).await;
        for size in 1..=TEXT.len() + 1 {
            let (read, fault) = pieces(&store, size).await;
            assert_eq!(read, TEXT.as_bytes(), "in pieces of {size} bytes");
            assert!(fault.is_none());
        }
    }

    #[tokio::test]
    async fn a_map_that_is_kept_apart_is_read_where_it_stood() {
        let (document, map, whole) = (
            "{\"map\":null,\"ä\":1}",
            "{\"é\":[2]}",
            "{\"map\":{\"é\":[2]},\"ä\":1}",
        );
        let map_sha256 = sha256(&[b"a", map.as_bytes()]);
        let place = "{\"map\":".len() as i64;
        let parts = [document.as_bytes(), &place.to_le_bytes()];
        let hash = sha256(&[b"a", parts[0], parts[1], map_sha256.as_bytes()]);
        let (_folder, store) = stored(document, &hash).await;
        let mut write = store.begin().await.expect("begins");
        for change in [
            sqlx::query("update results set map_place = ?, map_sha256 = ?")
                .bind(place)
                .bind(&map_sha256),
            sqlx::query("insert into result_maps (study, document) values ('a', ?)").bind(map),
        ] {
            change.execute(&mut *write).await.expect("stores");
        }
        store.commit(write, 0).await.expect("commits");
        for size in 1..=whole.len() + 1 {
            let (read, fault) = pieces(&store, size).await;
            assert_eq!(read, whole.as_bytes(), "in pieces of {size} bytes");
            assert!(fault.is_none());
        }

        let mut write = store.begin().await.expect("begins");
        let changed = sqlx::query("update result_maps set document = replace(document, '2', '3')");
        changed.execute(&mut *write).await.expect("changes");
        store.commit(write, 0).await.expect("commits");
        let (read, fault) = pieces(&store, 5).await;
        assert!(read.len() < whole.len());
        let named = matches!(
            fault,
            Some(StoreError::Damaged {
                table: "result_maps",
                ..
            })
        );
        assert!(named, "{fault:?}");
    }

    #[tokio::test]
    async fn the_last_piece_of_a_damaged_text_is_kept_back() {
        let (_folder, store) = stored(TEXT, &sha256(&[b"a", b"{}"])).await;
        let (read, fault) = pieces(&store, TEXT.len() - 1).await;
        assert_eq!(read, &TEXT.as_bytes()[..TEXT.len() - 1]);
        assert!(matches!(fault, Some(StoreError::Damaged { .. })));
    }

    #[tokio::test]
    async fn a_text_that_goes_while_it_is_read_ends_in_a_fault() {
        let (_folder, store) = stored(TEXT, &sha256(&[b"a", TEXT.as_bytes()])).await;
        let mut connection = store.read().await.expect("reads");
        let text = find(&mut connection, "a").await.expect("reads");
        let mut reading = text.expect("is there").reading();
        let first = reading.next(&mut connection, 2).await;
        assert_eq!(first.expect("reads"), Some(TEXT.as_bytes()[..2].to_vec()));
        let mut write = store.begin().await.expect("begins");
        let removed = sqlx::query("delete from results")
            .execute(&mut *write)
            .await;
        assert_eq!(removed.expect("deletes").rows_affected(), 1);
        store.commit(write, 0).await.expect("commits");
        let next = reading.next(&mut connection, 2).await;
        assert!(matches!(next, Err(StoreError::Damaged { .. })), "{next:?}");
    }
}
