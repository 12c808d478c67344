//! An open database.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use sqlx::pool::PoolConnection;
use sqlx::{Connection, Sqlite, SqliteConnection, SqlitePool, Transaction};
use tokio::sync::{Mutex, watch};

use crate::file::place::Place;
use crate::file::presence::Presence;
use crate::file::{lock, opening, pools};
use crate::seals;
use crate::store_error::StoreError;

/// An open database, held by this process alone.
#[derive(Debug)]
pub struct Store {
    place: Place,
    writer: SqlitePool,
    readers: SqlitePool,
    whole_reader: SqlitePool,
    keeper: Mutex<Option<SqliteConnection>>,
    presence: Presence,
    closing: AtomicBool,
    latest_event: watch::Sender<i64>,
    is_bounded: bool,
    // Last: its descriptor is closed after all of SQLite's.
    _lock: lock::DatabaseLock,
}

impl Store {
    /// Opens or creates the database and brings its tables up to date.
    ///
    /// # Errors
    /// [`StoreError::InUse`] when another process has it, [`StoreError::Open`] when the file is unusable.
    pub async fn open(path: &Path) -> Result<Self, StoreError> {
        Self::open_within(path, None).await
    }

    /// Opens as [`Store::open`] does; the file won't grow beyond this many bytes. One that is larger already doesn't grow.
    ///
    /// # Errors
    /// As [`Store::open`].
    pub async fn open_within(path: &Path, most_bytes: Option<u64>) -> Result<Self, StoreError> {
        let (place, lock) = opening::to_write(path, opening::Missing::Made).await?;
        pools::bootstrap(&place).await?;
        let writer = pools::writer(&place, most_bytes).await?;
        let readers = pools::readers(&place).await?;
        let whole_reader = pools::whole_reader(&place).await?;
        let keeper = pools::keeper(&place).await?;
        Ok(Self {
            presence: Presence::note(&place),
            closing: AtomicBool::new(false),
            place,
            writer,
            readers,
            whole_reader,
            keeper: Mutex::new(Some(keeper)),
            latest_event: watch::Sender::new(0),
            is_bounded: most_bytes.is_some(),
            _lock: lock,
        })
    }

    /// The database file.
    pub fn path(&self) -> &Path {
        &self.place.named
    }

    /// Whether the file may only grow so far.
    pub fn is_bounded(&self) -> bool {
        self.is_bounded
    }

    /// Size of the file and its write-ahead log; 0 for what can't be looked at.
    pub fn bytes(&self) -> u64 {
        let size = |path: PathBuf| std::fs::metadata(path).map_or(0, |file| file.len());
        size(self.place.real.clone()) + size(self.place.log())
    }

    /// A connection that can only read. Return it soon: there are few.
    ///
    /// # Errors
    /// When the database can't be read, or isn't there any more.
    pub async fn read(&self) -> Result<PoolConnection<Sqlite>, StoreError> {
        self.check()?;
        Ok(self.readers.acquire().await?)
    }

    /// The connection that reads whole results. Return it sooner than that of [`Store::read`]: there is one.
    ///
    /// # Errors
    /// As [`Store::read`].
    pub async fn read_whole(&self) -> Result<PoolConnection<Sqlite>, StoreError> {
        self.check()?;
        Ok(self.whole_reader.acquire().await?)
    }

    /// The one connection that writes. Return it sooner than any other.
    ///
    /// # Errors
    /// As [`Store::begin`].
    pub(crate) async fn writer(&self) -> Result<PoolConnection<Sqlite>, StoreError> {
        self.check()?;
        Ok(self.writer.acquire().await?)
    }

    /// The place of the file.
    pub(crate) fn place(&self) -> &Place {
        &self.place
    }

    /// A transaction on the one connection that writes. It takes the write lock at once, so that what it reads can't
    /// change before it writes.
    ///
    /// # Errors
    /// When the database can't be written, or isn't there any more.
    pub async fn begin(&self) -> Result<Transaction<'static, Sqlite>, StoreError> {
        self.check()?;
        Ok(self.writer.begin_with("begin immediate").await?)
    }

    /// Commits, then wakes whoever waits for an event up to `event`.
    ///
    /// # Errors
    /// When the database can't be written; then nothing of the transaction is stored. [`StoreError::Gone`] when it was stored in files that
    /// aren't there any more.
    pub async fn commit(
        &self,
        mut transaction: Transaction<'static, Sqlite>,
        event: i64,
    ) -> Result<(), StoreError> {
        seals::close(&mut transaction).await?;
        transaction.commit().await?;
        self.committed(event)
    }

    /// Wakes whoever waits for an event up to `event`, once it was committed.
    ///
    /// # Errors
    /// [`StoreError::Gone`] when it was stored in files that aren't there any more.
    pub(crate) fn committed(&self, event: i64) -> Result<(), StoreError> {
        // Afterwards: what is confirmed was in the files that the next start will find. Where the last connection closes meanwhile, what was committed is in the file, and
        // the log and its index go with it.
        if !self.is_closing() {
            self.presence.check()?;
        }
        self.latest_event.send_if_modified(|latest| {
            let newer = event > *latest;
            *latest = event.max(*latest);
            newer
        });
        Ok(())
    }

    /// Changes whenever an event has been stored.
    pub fn events_seen(&self) -> watch::Receiver<i64> {
        self.latest_event.subscribe()
    }

    /// Whether the files are those that were opened, and are used still: a log that goes with the last connection wasn't replaced by anybody.
    fn check(&self) -> Result<(), StoreError> {
        if self.is_closing() {
            return Err(sqlx::Error::PoolClosed.into());
        }
        self.presence.check()
    }

    fn is_closing(&self) -> bool {
        self.closing.load(Ordering::Relaxed)
    }

    /// Closes all connections, which folds the write-ahead log into the database file.
    ///
    /// # Errors
    /// [`StoreError::Gone`] when its files weren't there any more.
    pub async fn close(&self) -> Result<(), StoreError> {
        let present = self.presence.check();
        self.closing.store(true, Ordering::Relaxed);
        if let Some(keeper) = self.keeper.lock().await.take() {
            keeper.close().await?;
        }
        self.readers.close().await;
        self.whole_reader.close().await;
        // Last: what can only read can't fold the log.
        self.writer.close().await;
        present
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A fresh database in a folder that lives as long as the returned guard.
    pub(crate) async fn fresh() -> (tempfile::TempDir, Store) {
        let folder = tempfile::tempdir().expect("temp dir");
        let store = Store::open(&folder.path().join("test.db"))
            .await
            .expect("a fresh database opens");
        (folder, store)
    }

    #[tokio::test]
    async fn a_second_store_on_the_same_database_is_refused_until_the_first_is_gone() {
        let (folder, store) = fresh().await;
        let path = folder.path().join("test.db");
        assert!(matches!(
            Store::open(&path).await,
            Err(StoreError::InUse { .. })
        ));
        store.close().await.expect("closes");
        drop(store);
        Store::open(&path).await.expect("free again");
    }

    #[tokio::test]
    async fn a_file_that_is_no_database_is_refused_by_name() {
        let folder = tempfile::tempdir().expect("temp dir");
        let path = folder.path().join("letter.db");
        std::fs::write(
            &path,
            "dear reader, this is not a database, as you can see from its first page",
        )
        .expect("write");
        let error = Store::open(&path).await.expect_err("not a database");
        assert!(error.to_string().contains("letter.db"), "{error}");
    }

    #[tokio::test]
    async fn what_is_stored_in_files_that_are_gone_is_never_confirmed() {
        for gone in ["test.db", "test.db-wal", "test.db-shm"] {
            let (folder, store) = fresh().await;
            let (file, away) = (folder.path().join(gone), folder.path().join("away"));
            let open = store.begin().await.expect("is there");
            std::fs::rename(&file, &away).expect("moves");
            let error = store.commit(open, 0).await.expect_err("is gone");
            assert!(error.to_string().contains(gone), "{error}");
            std::fs::copy(&away, &file).expect("copies");
            let (begun, read) = (store.begin().await.err(), store.read().await.err());
            for refused in [begun, read, store.read_whole().await.err()] {
                assert!(
                    matches!(refused, Some(StoreError::Gone { .. })),
                    "{refused:?}"
                );
            }
            std::fs::rename(&away, &file).expect("moves back");
            store.begin().await.expect("is there again");
            store.close().await.expect("closes");
        }
    }

    #[tokio::test]
    async fn what_comes_while_it_closes_finds_it_closed_and_no_file_replaced() {
        let (_folder, store) = fresh().await;
        let open = store.begin().await.expect("begins");
        let (closed, committed) = tokio::join!(store.close(), async {
            // Until the close waits for this transaction.
            tokio::task::yield_now().await;
            store.commit(open, 1).await
        });
        closed.and(committed).expect("is stored and closed");
        for late in [store.begin().await.err(), store.read().await.err()] {
            let said = late.expect("is closed").to_string();
            assert!(!said.contains("replaced"), "{said}");
        }
    }

    #[tokio::test]
    async fn a_closed_database_is_one_file() {
        let (folder, store) = fresh().await;
        store.close().await.expect("closes");
        let log = folder.path().join("test.db-wal");
        assert!(!log.exists(), "the log is folded into the database");
    }

    #[tokio::test]
    async fn another_programs_database_is_left_as_it_is() {
        for change in [
            "create table mine (x)",
            "pragma application_id = 7",
            "create table _sqlx_migrations (version bigint, checksum blob); insert into _sqlx_migrations values (1, x'00')",
        ] {
            let folder = tempfile::tempdir().expect("temp dir");
            let path = folder.path().join("foreign.db");
            let options = sqlx::sqlite::SqliteConnectOptions::new().filename(&path);
            let made = SqliteConnection::connect_with(&options.create_if_missing(true)).await;
            let mut foreign = made.expect("opens");
            for part in change.split("; ") {
                let changed = sqlx::query(part).execute(&mut foreign).await;
                changed.expect("changes");
            }
            foreign.close().await.expect("closes");
            let before = std::fs::read(&path).expect("reads");
            let error = Store::open(&path).await.expect_err("isn't ours");
            assert!(error.to_string().contains("another program"), "{error}");
            assert_eq!(std::fs::read(&path).expect("reads"), before);
            let names = std::fs::read_dir(folder.path()).expect("lists").count();
            assert_eq!(names, 1, "nothing is left beside it");
        }
    }

    #[tokio::test]
    async fn the_reading_connections_cannot_write() {
        let (_folder, store) = fresh().await;
        for connection in [store.read().await, store.read_whole().await] {
            let refused = sqlx::query("delete from studies")
                .execute(&mut *connection.expect("reads"))
                .await;
            assert!(refused.is_err());
        }
    }

    #[test]
    fn times_are_rfc_3339_in_utc() {
        let time = crate::clock::now();
        assert!(
            time.ends_with('Z') && time.len() == "2026-01-01T00:00:00.000Z".len(),
            "{time}"
        );
    }
}
