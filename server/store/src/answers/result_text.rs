//! Results as texts, read in pieces: one may have hundreds of megabytes.

use sqlx::SqliteConnection;

use crate::answers::result_rows::damaged;
use crate::column::{counted, whole};
use crate::content::Digested;
use crate::store_error::StoreError;

/// What the row of a result says of its text, which isn't read for that.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct ResultText {
    study: String,
    document_sha256: String,
    /// The hash of its content.
    pub content_sha256: String,
    /// Its length.
    pub bytes: usize,
}

/// The text of a study's result, when there is one.
///
/// # Errors
/// [`StoreError::Damaged`] when it is empty; when the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<ResultText>, StoreError> {
    let query = "select octet_length(document), document_sha256, content_sha256 from results where study = ?";
    let row: Option<(i64, String, String)> = sqlx::query_as(query)
        .bind(study)
        .fetch_optional(connection)
        .await?;
    let Some((bytes, document_sha256, content_sha256)) = row else {
        return Ok(None);
    };
    // No result is written as nothing.
    let bytes = counted(bytes).filter(|bytes| *bytes > 0);
    Ok(Some(ResultText {
        bytes: bytes.ok_or_else(|| damaged(study))?,
        study: study.to_owned(),
        document_sha256,
        content_sha256,
    }))
}

impl ResultText {
    /// A reading from its beginning.
    pub fn reading(&self) -> Reading {
        let mut digested = Digested::default();
        digested.begin(self.study.len());
        digested.update(self.study.as_bytes());
        digested.begin(self.bytes);
        Reading {
            text: self.clone(),
            at: 0,
            digested,
        }
    }
}

/// A text that is being read, and the hash of what was.
#[derive(Debug)]
pub struct Reading {
    text: ResultText,
    at: usize,
    digested: Digested,
}

impl Reading {
    /// The next piece, up to so many bytes; `None` at the end. SQLite reads the whole text for each.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] instead of the last piece when the whole doesn't match its hash, and when the row is gone; when the database can't be read.
    pub async fn next(
        &mut self,
        connection: &mut SqliteConnection,
        bytes: usize,
    ) -> Result<Option<Vec<u8>>, StoreError> {
        if self.ended() {
            return Ok(None);
        }
        let query = "select substr(cast(document as blob), ?, ?) from results where study = ?";
        let piece: Option<Vec<u8>> = sqlx::query_scalar(query)
            .bind(whole(self.at + 1))
            .bind(whole(bytes))
            .bind(&self.text.study)
            .fetch_optional(connection)
            .await?;
        let lost = || damaged(&self.text.study);
        let piece = piece.filter(|piece| !piece.is_empty()).ok_or_else(lost)?;
        self.at += piece.len();
        self.digested.update(&piece);
        let wrong = self.ended() && self.digested.clone().end() != self.text.document_sha256;
        if wrong { Err(lost()) } else { Ok(Some(piece)) }
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
