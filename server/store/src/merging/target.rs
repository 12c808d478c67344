//! A database that takes others in, file by file.

use std::path::Path;
use std::sync::Arc;

use sqlx::pool::PoolConnection;
use sqlx::{Connection, Sqlite, SqliteConnection};

use super::differing::{self, Difference};
use super::parts::{Merged, Taken};
use super::taking;
use super::whole_file::{FileReader, WholeFile};
use crate::Store;
use crate::file::lock::DatabaseLock;
use crate::file::place::Place;
use crate::file::{opening, upkeep};
use crate::points::evaluations;
use crate::queue::event_rows;
use crate::store_error::StoreError;

/// Settings for taking in much at once: with a rollback journal new pages are written once, where the log and its checkpoint write them twice; 64 MB of them in memory are
/// written in one go.
const FOR_MUCH: [&str; 3] = [
    "pragma journal_mode = delete",
    "pragma cache_size = -65536",
    "pragma temp_store = memory",
];

/// A database that takes others in.
#[derive(Debug)]
pub struct Merging {
    place: Place,
    held: Held,
}

/// Way in which a database is held.
#[derive(Debug)]
enum Held {
    /// Database that this alone has.
    Alone {
        connection: SqliteConnection,
        // Last: SQLite closes its descriptors first.
        _lock: DatabaseLock,
    },
    /// Database with other work of this process, which waits only while rows are copied.
    Open {
        reader: SqliteConnection,
        store: Arc<Store>,
    },
}

/// Connection that writes, for a while.
pub(super) enum Writer<'m> {
    Alone(&'m mut SqliteConnection),
    Open(PoolConnection<Sqlite>),
}

impl Merging {
    /// Opens or creates the database for this alone, and brings its tables up to date.
    ///
    /// # Errors
    /// [`StoreError::InUse`] when another process has it; when it can't be written.
    pub async fn open(database: &Path) -> Result<Self, StoreError> {
        Store::open(database).await?.close().await?;
        let (lock, mut connection) = upkeep::alone(database).await?;
        for pragma in FOR_MUCH {
            sqlx::query(pragma).execute(&mut connection).await?;
        }
        Ok(Self {
            place: Place::of(database)?,
            held: Held::Alone {
                connection,
                _lock: lock,
            },
        })
    }

    /// Takes others in beside what else is done with an open database.
    ///
    /// # Errors
    /// When it can't be read.
    pub async fn beside(store: Arc<Store>) -> Result<Self, StoreError> {
        let place = store.place().clone();
        let reader = opening::to_read(&place.named).await?;
        Ok(Self {
            place,
            held: Held::Open { reader, store },
        })
    }

    /// Reader of files that it may take.
    pub fn reader(&self) -> FileReader {
        FileReader::new(self.place.clone())
    }

    /// Studies of a file, and how many of its points aren't known here.
    ///
    /// # Errors
    /// When one of both can't be read.
    pub async fn foreseen(&mut self, file: &WholeFile) -> Result<(Vec<String>, usize), StoreError> {
        let mut theirs = file.open().await?;
        let studies = sqlx::query_scalar("select id from studies");
        let studies = studies.fetch_all(&mut theirs).await?;
        let keys = sqlx::query_scalar("select key from evaluations");
        let keys: Vec<String> = keys.fetch_all(&mut theirs).await?;
        theirs.close().await?;
        let asked: Vec<&str> = keys.iter().map(String::as_str).collect();
        let known = evaluations::known(self.connection(), &asked).await?;
        Ok((studies, keys.len() - known.len()))
    }

    /// Takes in what a file has.
    ///
    /// # Errors
    /// [`StoreError::Merge`] when it says something else of a point, study or sweep that is known here; nothing of it is taken then.
    pub async fn take(&mut self, file: &WholeFile, taken: Taken) -> Result<Merged, StoreError> {
        let refused = |cause: String| StoreError::Merge {
            path: file.named().to_owned(),
            cause,
        };
        let name = file.path().to_str();
        let name = name.ok_or_else(|| refused("its path isn't UTF-8".to_owned()))?;
        let mut writer = self.writer().await?;
        writer.attach(name).await?;
        let merged = take_attached(writer.connection(), taken).await;
        writer.detach().await?;
        match merged? {
            Ok((merged, event)) => {
                if let Held::Open { store, .. } = &self.held {
                    store.committed(event)?;
                }
                Ok(merged)
            }
            Err(difference) => {
                let mut theirs = file.open().await?;
                let said = difference.told(self.connection(), &mut theirs).await;
                theirs.close().await?;
                Err(refused(said?))
            }
        }
    }

    /// The connection that writes, from which whoever else writes is kept meanwhile.
    pub(super) async fn writer(&mut self) -> Result<Writer<'_>, StoreError> {
        Ok(match &mut self.held {
            Held::Alone { connection, .. } => Writer::Alone(connection),
            Held::Open { store, .. } => Writer::Open(store.writer().await?),
        })
    }

    /// A connection that reads the database.
    pub fn connection(&mut self) -> &mut SqliteConnection {
        match &mut self.held {
            Held::Alone { connection, .. } => connection,
            Held::Open { reader, .. } => reader,
        }
    }

    /// Closes what was opened for this: of a database that it had alone, the log is folded into the file.
    ///
    /// # Errors
    /// When it can't be written.
    pub async fn close(self) -> Result<(), StoreError> {
        match self.held {
            Held::Alone { connection, .. } => Ok(connection.close().await?),
            Held::Open { reader, .. } => Ok(reader.close().await?),
        }
    }
}

impl Writer<'_> {
    pub(super) fn connection(&mut self) -> &mut SqliteConnection {
        match self {
            Self::Alone(connection) => connection,
            Self::Open(connection) => connection,
        }
    }

    /// Attaches another database as `other`.
    pub(super) async fn attach(&mut self, path: &str) -> Result<(), StoreError> {
        let attached = sqlx::query("attach database ? as other").bind(path);
        attached.execute(self.connection()).await?;
        Ok(())
    }

    /// Takes that one off again.
    pub(super) async fn detach(mut self) -> Result<(), StoreError> {
        let detached = sqlx::query("detach database other").execute(self.connection());
        let detached = detached.await;
        if let (Err(_), Self::Open(connection)) = (&detached, self) {
            // Nobody else gets it with what is attached.
            connection.close().await?;
        }
        detached?;
        Ok(())
    }
}

/// Takes what the attached database has, and says which event is the latest then; or what it has otherwise.
async fn take_attached(
    connection: &mut SqliteConnection,
    taken: Taken,
) -> Result<Result<(Merged, i64), Difference>, StoreError> {
    let mut transaction = connection.begin_with("begin immediate").await?;
    if let Some(difference) = differing::first(&mut transaction, taken).await? {
        transaction.rollback().await?;
        return Ok(Err(difference));
    }
    let merged = taking::take(&mut transaction, taken).await?;
    let event = event_rows::latest(&mut transaction).await?;
    transaction.commit().await?;
    Ok(Ok((merged, event)))
}
