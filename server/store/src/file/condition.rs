//! Condition of a file before anything is written to it: a database of this program, one of another version or program, or damaged.

use std::fs::File;
use std::io::Read;

use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{ConnectOptions, Connection, SqliteConnection};

use crate::file::identity::{self, FileId};
use crate::file::lock::{self, FileLock};
use crate::file::place::Place;
use crate::file::schema;
use crate::store_error::{self, StoreError};

/// `application_id` of the tables: `stra`.
const OURS: i64 = 0x7374_7261;

/// Content of a file, by whose it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Content {
    /// Empty file.
    Fresh,
    /// A database of this program, with its newest migration.
    Ours(i64),
    /// A database of version 0.1, whose tables were others.
    Past,
    /// A database of another program.
    Foreign,
}

/// Refuses what must not be opened to be written: a file of several names, a log that isn't the file's, another program's
/// database, one of a newer version, a damaged one. Changes nothing.
///
/// # Errors
/// [`StoreError::Open`] that says which of these it is.
pub(crate) async fn fit_to_write(place: &Place, held: &mut FileLock) -> Result<(), StoreError> {
    let mut connection = look(place, held).await?;
    let checked = fit(place, &mut connection).await;
    connection.close().await?;
    checked
}

/// Whether a file and its log belong together and can be read, whoever wrote them. Changes nothing.
pub(crate) async fn is_sound(place: &Place, held: &mut FileLock) -> bool {
    let Ok(mut connection) = look(place, held).await else {
        return false;
    };
    let sound = sound(place, &mut connection).await;
    connection.close().await.is_ok() && sound.is_ok()
}

/// A connection that changes nothing, and leaves nothing beside a file that had nothing beside it.
async fn look(place: &Place, held: &mut FileLock) -> Result<SqliteConnection, StoreError> {
    let mut head = Vec::new();
    held.head(&mut head).map_err(|error| place.failed(error))?;
    fits(place, &head)?;
    let alone = !place.log().exists() && !place.beside("-journal").exists();
    let looking = options(place).read_only(true).immutable(alone);
    let connected = match connect(looking).await {
        // What a kill left half written has to be undone first.
        Err(error) if store_error::wants_to_write(&error) => connect(options(place)).await,
        connected => connected,
    };
    connected.map_err(|error| unreadable(place, &error))
}

/// Refuses what must not be opened to be read, as [`fit_to_write`] does but for the damage.
///
/// # Errors
/// As [`fit_to_write`].
pub(crate) fn fit_to_read(place: &Place) -> Result<(), StoreError> {
    place.check()?;
    let id = FileId::at(&place.real).ok_or_else(|| place.failed("there is no such file"))?;
    // A file that this process holds must not be opened and closed beside SQLite.
    if lock::is_held(id) {
        return Ok(());
    }
    let mut head = Vec::new();
    let file = File::open(&place.real).map_err(|error| place.failed(error))?;
    let read = file.take(100).read_to_end(&mut head);
    read.map_err(|error| place.failed(error))?;
    fits(place, &head)
}

/// Opens the file; nothing is asked of it before it has been read once.
pub async fn connect(options: SqliteConnectOptions) -> Result<SqliteConnection, sqlx::Error> {
    let mut connection = options.connect().await?;
    let read = sqlx::query("select count(*) from sqlite_schema");
    read.execute(&mut connection).await?;
    Ok(connection)
}

/// Returns the options for looking after a whole file, which takes its time: the log needn't warn of that.
pub fn options(place: &Place) -> SqliteConnectOptions {
    SqliteConnectOptions::new()
        .filename(&place.real)
        .disable_statement_logging()
}

async fn fit(place: &Place, connection: &mut SqliteConnection) -> Result<(), StoreError> {
    match content(connection)
        .await
        .map_err(|error| unreadable(place, &error))?
    {
        Content::Foreign => return Err(foreign(place)),
        Content::Past => return Err(past(place)),
        Content::Ours(newest) if newest > schema::newest() => {
            return Err(newer(place, newest));
        }
        Content::Ours(_) | Content::Fresh => {}
    }
    sound(place, connection).await
}

async fn sound(place: &Place, connection: &mut SqliteConnection) -> Result<(), StoreError> {
    let verdict: String = sqlx::query_scalar("pragma quick_check(1)")
        .fetch_one(connection)
        .await
        .map_err(|error| unreadable(place, &error))?;
    match verdict.as_str() {
        "ok" => Ok(()),
        fault => Err(damaged(place, &format!("it is corrupt ({fault})"))),
    }
}

/// Finds whose a database is: its `application_id` says it, and its first migration which tables it has.
///
/// # Errors
/// When it can't be read.
pub async fn content(connection: &mut SqliteConnection) -> Result<Content, sqlx::Error> {
    let application: i64 = sqlx::query_scalar("select application_id from pragma_application_id")
        .fetch_one(&mut *connection)
        .await?;
    let tables: Vec<String> = sqlx::query_scalar(
        "select name from sqlite_schema where name not like 'sqlite~_%' escape '~'",
    )
    .fetch_all(&mut *connection)
    .await?;
    if !tables.iter().any(|table| table == "_sqlx_migrations") {
        let fresh = tables.is_empty() && (application == 0 || application == OURS);
        return Ok(if fresh {
            Content::Fresh
        } else {
            Content::Foreign
        });
    }
    let applied: Vec<(i64, Vec<u8>)> =
        sqlx::query_as("select version, checksum from _sqlx_migrations order by version")
            .fetch_all(connection)
            .await?;
    let (Some((first, checksum)), Some((newest, _))) = (applied.first(), applied.last()) else {
        // A first start that was killed before its first migration.
        return Ok(if tables.len() == 1 {
            Content::Fresh
        } else {
            Content::Foreign
        });
    };
    Ok(match application {
        OURS if schema::is_first(*first, checksum) => Content::Ours(*newest),
        OURS => Content::Past,
        _ => Content::Foreign,
    })
}

/// A file of one name, whose log, if there is one, can be its own. What is in a log was written after the file's own head said so: a file
/// whose head knows of none, as every copy of `db backup` is, was put before another one's log.
fn fits(place: &Place, head: &[u8]) -> Result<(), StoreError> {
    let metadata = std::fs::metadata(&place.real).map_err(|error| place.failed(error))?;
    let names = identity::names(&metadata);
    if names > 1 {
        return Err(place.failed(format!(
            "the file has {names} names (hard links), and what was written last lies beside only one of them: remove the other names, or \
             copy the file instead of linking it"
        )));
    }
    const KNOWS_NO_LOG: [u8; 2] = [1, 1];
    let without_log =
        head.starts_with(b"SQLite format 3\0") && head.get(18..20) == Some(&KNOWS_NO_LOG);
    if without_log && log_bytes(place) > 0 {
        return Err(place.failed(format!(
            "{} belongs to another database that was here before, not to the copy that was put in its place; {}",
            place.log().display(),
            remedy(place)
        )));
    }
    Ok(())
}

/// Bytes of the write-ahead log; 0 where there is none.
pub(crate) fn log_bytes(place: &Place) -> u64 {
    std::fs::metadata(place.log()).map_or(0, |log| log.len())
}

fn remedy(place: &Place) -> String {
    format!(
        "remove {} and {}, or restore a copy with strainsite db restore, which does that",
        place.log().display(),
        place.index().display()
    )
}

/// Another program's database.
pub fn foreign(place: &Place) -> StoreError {
    place.failed(
        "it is an SQLite database of another program, and was left as it is: name another file with --db",
    )
}

/// A database of version 0.1.
pub(crate) fn past(place: &Place) -> StoreError {
    place.failed(
        "strainsite 0.1 wrote it, whose databases later versions don't read, and it was left as it is: use version 0.1 to export what is in it, \
         or start a new file with --db",
    )
}

/// A database of a newer version.
pub(crate) fn newer(place: &Place, newest: i64) -> StoreError {
    place.failed(format!(
        "a newer version of strainsite wrote it (its tables are of change {newest}, this version knows {}): use that version, or restore a \
         copy from before",
        schema::newest()
    ))
}

/// Returns what SQLite said when it couldn't read the file, and what to do about it.
pub fn unreadable(place: &Place, error: &sqlx::Error) -> StoreError {
    if store_error::is_corrupt(error) {
        return damaged(place, &error.to_string());
    }
    place.failed(error)
}

fn damaged(place: &Place, what: &str) -> StoreError {
    if log_bytes(place) == 0 {
        return place.failed(format!("{what}; restore a copy or name another file"));
    }
    place.failed(format!(
        "{what}. Where another file was put here, {} belongs to the one before: {}",
        place.log().display(),
        remedy(place)
    ))
}
