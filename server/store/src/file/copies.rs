//! Copies of a database, and a copy back in its place.

use std::fs;
use std::path::{Path, PathBuf};

use sqlx::sqlite::SqliteJournalMode;
use sqlx::{Connection, SqliteConnection};

use crate::clock;
use crate::file::condition::{self, Content};
use crate::file::identity::FileId;
use crate::file::lock::{FileLock, NameLock};
use crate::file::place::{Place, beside};
use crate::file::unfinished::{COMPANIONS, Unfinished};
use crate::file::{opening, pools, schema, upkeep};
use crate::store_error::StoreError;

/// Fate of the database that a copy takes the place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Replaced {
    /// A database that is kept beside, under a name with the time.
    Kept,
    /// A database that is lost.
    Discarded,
}

/// A copy of `source` that isn't there yet, beside the place where it is to be: a plain file, whatever SQLite makes of its name, which nobody may read who may not
/// read the source.
///
/// # Errors
/// [`StoreError::Copy`] when there is something of that name, or nothing can be written there.
pub fn begin(source: &Path, target: &Path) -> Result<Unfinished, StoreError> {
    let place = Place::of(target)?;
    if fs::symlink_metadata(&place.real).is_ok() {
        return Err(StoreError::Copy {
            path: target.to_owned(),
            cause: "a copy is only written to a file that isn't there yet".to_owned(),
        });
    }
    Unfinished::begin(&place, &Place::of(source)?)
}

/// Writes the database as it is now, without free pages.
///
/// # Errors
/// [`StoreError::Copy`] when it can't be written.
pub async fn write(connection: &mut SqliteConnection, copy: &Unfinished) -> Result<(), StoreError> {
    let failed = |cause: String| StoreError::Copy {
        path: copy.target().to_owned(),
        cause,
    };
    let name = copy.path().to_str();
    let name = name.ok_or_else(|| failed("its name isn't UTF-8".to_owned()))?;
    let written = sqlx::query("vacuum into ?")
        .bind(name)
        .execute(connection)
        .await;
    match written.map_err(StoreError::from) {
        Ok(_) => Ok(()),
        Err(StoreError::Full) => Err(failed("the disk that it is written to is full".to_owned())),
        Err(StoreError::Database(error)) => Err(failed(error.to_string())),
        Err(error) => Err(error),
    }
}

/// Writes the database as it is now to a file, in the place of what may be there; until it is whole that stays.
///
/// # Errors
/// [`StoreError::Copy`] when it can't be written.
pub async fn hand_in(source: &Path, target: &Path) -> Result<(), StoreError> {
    let mut connection = opening::to_read(source).await?;
    let copy = Unfinished::begin(&Place::of(target)?, &Place::of(source)?)?;
    let written = write(&mut connection, &copy).await;
    connection.close().await?;
    written.and_then(|()| copy.replace(None))
}

/// Puts a copy in the place of the database, and returns under what name the one before is kept. The copy is read whole first, and brought up
/// to date beside the place; it then takes the place at once. Killed at any moment, the old database is there or the new one, and this can be
/// done again. Tells `seen` how many rows it has read, and of how many.
///
/// # Errors
/// [`StoreError::InUse`] when a process has the database; when the copy isn't whole; when the database is another program's.
pub async fn restore(
    backup: &Path,
    database: &Path,
    replaced: Replaced,
    seen: &dyn Fn(usize, usize),
) -> Result<Option<PathBuf>, StoreError> {
    let (source, place) = (Place::of(backup)?, Place::of(database)?);
    let mut old = FileLock::take(&place)?;
    if old.is_some() && FileId::at(&source.real) == FileId::at(&place.real) {
        return Err(source.failed("it is the database itself that it was to be put in place of"));
    }
    if old.is_some() && is_foreign(&place).await {
        return Err(condition::foreign(&place));
    }
    let _name = NameLock::take(&place)?;
    // What the database let nobody else read, no copy lets them.
    let like = if old.is_some() { &place } else { &source };
    let copy = Unfinished::begin(&place, like)?;
    let copy = whole(&source, copy, Tables::Any, seen).await?;
    let Some(old) = &mut old else {
        remove_companions(&place, None);
        return copy.place().map(|()| None);
    };
    let kept = (replaced == Replaced::Kept).then(|| {
        let time = clock::now().replace(['-', ':'], "");
        place.beside(&format!(".replaced-{time}"))
    });
    fold(&place, old).await?;
    remove_companions(&place, kept.as_deref());
    copy.replace(kept.as_deref())?;
    Ok(kept)
}

/// Tables that a copy may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Tables {
    /// Ours, and whatever somebody put beside them.
    Any,
    /// Ours alone.
    Ours,
}

/// The copy filled from the source, whose rows were all read and match their hashes; its tables are up to date.
///
/// # Errors
/// [`StoreError::Open`] when the source isn't whole, or can't be read.
pub(crate) async fn whole(
    source: &Place,
    copy: Unfinished,
    tables: Tables,
    seen: &dyn Fn(usize, usize),
) -> Result<Unfinished, StoreError> {
    let mut from = readable(source).await?;
    write(&mut from, &copy).await?;
    from.close().await?;
    prepare(source, copy.path(), tables, seen).await?;
    Ok(copy)
}

/// A database that this program can read.
async fn readable(source: &Place) -> Result<SqliteConnection, StoreError> {
    condition::fit_to_read(source)?;
    let mut connection = opening::connected(source).await?;
    let content = condition::content(&mut connection).await;
    let refused = match content.map_err(|error| condition::unreadable(source, &error))? {
        Content::Ours(version) if version > schema::newest() => condition::newer(source, version),
        Content::Ours(_) => return Ok(connection),
        Content::Fresh => source.failed("it is empty"),
        Content::Foreign => condition::foreign(source),
        Content::Past => condition::past(source),
    };
    connection.close().await?;
    Err(refused)
}

/// Whether another program's database is there; one that can't be read may be replaced.
async fn is_foreign(place: &Place) -> bool {
    let Ok(mut connection) = condition::connect(condition::options(place).read_only(true)).await
    else {
        return false;
    };
    let content = condition::content(&mut connection).await;
    // Whatever the end of a reading connection says, nothing was written.
    let _ = connection.close().await;
    matches!(content, Ok(Content::Foreign))
}

/// Brings a copy up to date and reads all of it. Its head knows of no log then, so that one of the database before, which a kill may have
/// left, is known not to be its own.
async fn prepare(
    source: &Place,
    copy: &Path,
    tables: Tables,
    seen: &dyn Fn(usize, usize),
) -> Result<(), StoreError> {
    let place = Place::of(copy)?;
    pools::bootstrap(&place).await?;
    let mut connection = opening::to_read(copy).await?;
    if tables == Tables::Ours
        && let Some(strange) = schema::strange(&mut connection).await?
    {
        connection.close().await?;
        return Err(source.failed(format!(
            "it has a table, view or trigger {strange:?} that isn't one of strainsite's"
        )));
    }
    connection.close().await?;
    let faults = upkeep::inspect(copy, seen).await?.faults;
    if let Some(fault) = faults.first() {
        let cause = format!(
            "it isn't whole ({fault}; {} faults in all), and the database was left as it is",
            faults.len()
        );
        return Err(source.failed(cause));
    }
    let closed = condition::options(&place).journal_mode(SqliteJournalMode::Delete);
    Ok(condition::connect(closed).await?.close().await?)
}

/// Folds the log of the database that is to be replaced into its file, where it can be used at all.
async fn fold(place: &Place, old: &mut FileLock) -> Result<(), StoreError> {
    if !condition::is_sound(place, old).await {
        return Ok(());
    }
    let mut connection = condition::connect(condition::options(place)).await?;
    sqlx::query("pragma wal_checkpoint(truncate)")
        .execute(&mut connection)
        .await?;
    connection.close().await?;
    match condition::log_bytes(place) {
        0 => Ok(()),
        // Somebody reads what is in it.
        _ => Err(StoreError::Busy),
    }
}

/// Takes away what SQLite keeps beside a database: to the name under which the database itself is kept, or for good.
fn remove_companions(place: &Place, kept: Option<&Path>) {
    for ending in COMPANIONS {
        let companion = place.beside(ending);
        // What can't be moved or removed isn't there; were it there, the next start would name it.
        let _ = match kept {
            Some(kept) if ending != "-shm" => fs::rename(&companion, beside(kept, ending)),
            _ => fs::remove_file(&companion),
        };
    }
}

#[cfg(test)]
mod tests {
    use sqlx::sqlite::SqliteConnectOptions;

    use super::*;
    use crate::Store;
    use crate::database::tests::fresh;

    #[tokio::test]
    async fn a_log_of_the_database_before_is_known_by_its_copy() {
        let (folder, store) = fresh().await;
        let (path, copy) = (folder.path().join("test.db"), folder.path().join("copy.db"));
        let mut reading = opening::to_read(&path).await.expect("opens");
        let unfinished = begin(&path, &copy).expect("begins");
        let written = write(&mut reading, &unfinished).await;
        written.and_then(|()| unfinished.place()).expect("copies");
        let mut change = store.begin().await.expect("begins");
        let changed = sqlx::query("pragma user_version = 1");
        changed.execute(&mut *change).await.expect("changes");
        store.commit(change, 0).await.expect("commits");
        let (log, other) = (
            folder.path().join("test.db-wal"),
            folder.path().join("copy.db-wal"),
        );
        fs::copy(&log, &other).expect("copies");
        let before = fs::read(&other).expect("reads");
        assert!(!before.is_empty(), "there is something in the log");
        let refused = [
            Store::open(&copy).await.err(),
            opening::to_read(&copy).await.err(),
        ];
        for error in refused {
            let said = error.expect("isn't its own").to_string();
            assert!(
                said.contains("copy.db-wal") && said.contains("copy.db-shm"),
                "{said}"
            );
        }
        assert_eq!(fs::read(&other).expect("reads"), before);
    }

    #[tokio::test]
    async fn a_database_of_version_0_1_is_refused_with_what_to_do_and_left_as_it_is() {
        let folder = tempfile::tempdir().expect("temp dir");
        let path = folder.path().join("past.db");
        let options = SqliteConnectOptions::new().filename(&path);
        let made = SqliteConnection::connect_with(&options.create_if_missing(true)).await;
        let mut past = made.expect("opens");
        // Its numbered changes, of which the last tells nothing, and its mark.
        for change in [
            "create table _sqlx_migrations (version bigint, checksum blob)",
            "insert into _sqlx_migrations values (1, x'00'), (23, x'17')",
            "pragma application_id = 1937011297",
        ] {
            let changed = sqlx::query(change).execute(&mut past).await;
            changed.expect("changes");
        }
        past.close().await.expect("closes");
        let before = fs::read(&path).expect("reads");
        let other = folder.path().join("other.db");
        for refused in [
            Store::open(&path).await.err(),
            opening::to_read(&path).await.err(),
            restore(&path, &other, Replaced::Kept, &|_, _| {})
                .await
                .err(),
        ] {
            let said = refused.expect("isn't read").to_string();
            assert!(said.contains("0.1") && said.contains("--db"), "{said}");
        }
        assert_eq!(fs::read(&path).expect("reads"), before);
        assert!(!other.exists());
    }
}
