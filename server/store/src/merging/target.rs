//! A database that takes others in, file by file.

use std::path::Path;

use sqlx::{Connection, SqliteConnection};

use super::differing::{self, Difference};
use super::parts::{Merged, Taken};
use super::taking;
use crate::Store;
use crate::file::copies::{self, Tables};
use crate::file::identity::FileId;
use crate::file::lock::DatabaseLock;
use crate::file::place::Place;
use crate::file::unfinished::Unfinished;
use crate::file::{opening, upkeep};
use crate::store_error::StoreError;

/// A database that takes others in, for this process alone.
#[derive(Debug)]
pub struct Merging {
    place: Place,
    connection: SqliteConnection,
    // Last: SQLite closes its descriptors first.
    _lock: DatabaseLock,
}

impl Merging {
    /// Opens or creates the database, and brings its tables up to date.
    ///
    /// # Errors
    /// [`StoreError::InUse`] when another process has it; when it can't be written.
    pub async fn open(database: &Path) -> Result<Self, StoreError> {
        Store::open(database).await?.close().await?;
        let (lock, connection) = upkeep::alone(database).await?;
        Ok(Self {
            place: Place::of(database)?,
            connection,
            _lock: lock,
        })
    }

    /// Takes in what a file has. Tells `seen` how many of its rows were read, and of how many.
    ///
    /// # Errors
    /// [`StoreError::Merge`] when the file isn't whole, has other tables, or says something else of a point or study that is known here; nothing of it is taken then.
    pub async fn take(
        &mut self,
        file: &Path,
        taken: Taken,
        seen: &dyn Fn(usize, usize),
    ) -> Result<Merged, StoreError> {
        let refused = |cause: String| StoreError::Merge {
            path: file.to_owned(),
            cause,
        };
        let source = Place::of(file)?;
        let id = FileId::at(&source.real);
        if id.is_some() && id == FileId::at(&self.place.real) {
            return Err(refused("it is the database itself".to_owned()));
        }
        let copy = self.copy(&source, seen).await?;
        let attached = sqlx::query("attach database ? as other");
        let name = copy.path().to_str();
        let name = name.ok_or_else(|| refused("its path isn't UTF-8".to_owned()))?;
        attached.bind(name).execute(&mut self.connection).await?;
        let merged = self.take_attached(taken).await;
        let detached = sqlx::query("detach database other");
        detached.execute(&mut self.connection).await?;
        match merged? {
            Ok(merged) => Ok(merged),
            Err(difference) => {
                let mut theirs = opening::to_read(copy.path()).await?;
                let said = difference.told(&mut self.connection, &mut theirs).await;
                theirs.close().await?;
                Err(refused(said?))
            }
        }
    }

    /// A private copy of the file, whole and with our tables.
    async fn copy(
        &self,
        source: &Place,
        seen: &dyn Fn(usize, usize),
    ) -> Result<Unfinished, StoreError> {
        let beside = Place::of(&self.place.beside(".merging"))?;
        copies::whole(source, &beside, &self.place, Tables::Ours, seen).await
    }

    /// Takes what the attached database has, or says what it has otherwise.
    async fn take_attached(
        &mut self,
        taken: Taken,
    ) -> Result<Result<Merged, Difference>, StoreError> {
        let mut transaction = self.connection.begin_with("begin immediate").await?;
        if let Some(difference) = differing::first(&mut transaction, taken).await? {
            transaction.rollback().await?;
            return Ok(Err(difference));
        }
        let merged = taking::take(&mut transaction, taken).await?;
        transaction.commit().await?;
        Ok(Ok(merged))
    }

    /// Closes the database, which folds its log into the file.
    ///
    /// # Errors
    /// When it can't be written.
    pub async fn close(self) -> Result<(), StoreError> {
        Ok(self.connection.close().await?)
    }
}
