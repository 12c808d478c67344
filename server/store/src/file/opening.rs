//! Opening a database file: whose turn it is, and whether it is one.

use std::path::Path;

use sqlx::{Connection, SqliteConnection};

use crate::file::condition::{self, Content};
use crate::file::lock::{DatabaseLock, FileLock, NameLock};
use crate::file::place::Place;
use crate::file::{rights, schema};
use crate::store_error::{self, StoreError};

/// Action where no file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Missing {
    /// Make an empty one.
    Made,
    /// Say so.
    Refused,
}

/// Takes a database for this process alone. What is refused is left as it is.
///
/// # Errors
/// [`StoreError::InUse`] when another process has it, [`StoreError::Open`] when it isn't fit to be written.
pub(crate) async fn to_write(
    path: &Path,
    missing: Missing,
) -> Result<(Place, DatabaseLock), StoreError> {
    let place = Place::of(path)?;
    if let Some(mut file) = FileLock::take(&place)? {
        condition::fit_to_write(&place, &mut file).await?;
        let name = NameLock::take(&place)?;
        return Ok((place, DatabaseLock::new(file, name)));
    }
    if missing == Missing::Refused {
        return Err(place.failed("there is no such file"));
    }
    let name = NameLock::take(&place)?;
    let made = rights::private()
        .append(true)
        .create(true)
        .open(&place.real);
    made.map_err(|error| place.failed(error))?;
    // Where the name was a link to nothing, the file is elsewhere.
    let place = Place::of(path)?;
    let file = FileLock::take(&place)?;
    let file = file.ok_or_else(|| place.failed("it was removed at once"))?;
    Ok((place, DatabaseLock::new(file, name)))
}

/// A connection that can only read, to a database that another process may hold.
///
/// # Errors
/// [`StoreError::Open`] when there is no such database, or one of another program or version.
pub async fn to_read(path: &Path) -> Result<SqliteConnection, StoreError> {
    let place = Place::of(path)?;
    condition::fit_to_read(&place)?;
    let mut connection = connected(&place).await?;
    let found = condition::content(&mut connection).await;
    let newest = schema::newest();
    let refused = match found.map_err(|error| condition::unreadable(&place, &error))? {
        Content::Ours(version) if version == newest => return Ok(connection),
        Content::Ours(version) if version > newest => condition::newer(&place, version),
        Content::Ours(_) => place.failed(
            "its tables are those of an older version; serve and run bring them up to date",
        ),
        Content::Fresh => place.failed("it is empty: serve and run make its tables"),
        Content::Foreign => condition::foreign(&place),
        Content::Past => condition::past(&place),
    };
    connection.close().await?;
    Err(refused)
}

/// SQLite keeps an index beside the log even to read. Where neither is there and none can be made, the file alone is the database, and
/// nobody can change it.
pub(crate) async fn connected(place: &Place) -> Result<SqliteConnection, StoreError> {
    let options = condition::options(place).read_only(true);
    let error = match condition::connect(options.clone()).await {
        Ok(connection) => return Ok(connection),
        Err(error) => error,
    };
    if !store_error::wants_to_write(&error) {
        return Err(condition::unreadable(place, &error));
    }
    if place.log().exists() {
        return Err(place.failed(format!(
            "its log {} can't be read where nothing can be written ({error}): copy both files to a disk that can be written",
            place.log().display()
        )));
    }
    let sealed = condition::connect(options.immutable(true)).await;
    sealed.map_err(|error| condition::unreadable(place, &error))
}
