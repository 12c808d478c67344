//! Estimators of forces: what was asked, how far it got, and what was learnt.
//!
//! States are those of studies, and guarded in the same way: a late writer never overwrites an end.

use sqlx::SqliteConnection;

use crate::clock::now;
use crate::content::{document_sha256, intact};
use crate::queue::estimator_parts::{Part, insert_parts, insert_recordings, part, recordings};
use crate::queue::estimator_zeros::{forget, zero};
use crate::queue::study_rows::{State, by_state};
use crate::row::from_row;
use crate::seals;
use crate::store_error::StoreError;

/// An estimator as stored, without its recordings and what was learnt of them.
#[derive(Debug, Clone, PartialEq)]
pub struct EstimatorRow {
    /// UUID, ordered by time.
    pub id: String,
    /// Free text.
    pub name: String,
    document: String,
    document_sha256: String,
    state: String,
    /// Reason why it failed.
    pub error: Option<String>,
    /// Time at which it was submitted.
    pub created: String,
    /// Time at which it was first started.
    pub started: Option<String>,
    /// Time at which it ended.
    pub finished: Option<String>,
}

from_row!(EstimatorRow {
    id,
    name,
    document,
    document_sha256,
    state,
    error,
    created,
    started,
    finished
});

impl EstimatorRow {
    /// Returns its state.
    ///
    /// # Panics
    /// Never: the table allows no other names.
    pub fn state(&self) -> State {
        State::named(&self.state).expect("the table's check allows known states only")
    }

    /// Returns what was asked, JSON.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] when it doesn't match its hash.
    pub fn document(&self) -> Result<&str, StoreError> {
        intact(
            ("estimators", &self.id),
            &self.document,
            &self.document_sha256,
        )
    }
}

/// Stores a new estimator behind the others that wait, and returns its identifier.
///
/// # Errors
/// When the database can't be written.
pub async fn insert<'r>(
    connection: &mut SqliteConnection,
    (name, document): (&str, &str),
    memory_bytes: u64,
    recordings: impl Iterator<Item = (&'r str, &'r str)>,
) -> Result<String, StoreError> {
    let id = uuid::Uuid::now_v7().to_string();
    let query =
        "insert into estimators (id, name, document, document_sha256, memory_bytes, state, created)
                 values (?, ?, ?, ?, ?, 'queued', ?)";
    sqlx::query(query)
        .bind(&id)
        .bind(name)
        .bind(document)
        .bind(document_sha256(document))
        .bind(i64::try_from(memory_bytes).unwrap_or(i64::MAX))
        .bind(now())
        .execute(&mut *connection)
        .await?;
    insert_recordings(connection, &id, recordings).await?;
    Ok(id)
}

/// The estimator of this identifier.
///
/// # Errors
/// When the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Option<EstimatorRow>, StoreError> {
    seals::intact(connection, "estimators", "id = ?", id).await?;
    Ok(sqlx::query_as("select * from estimators where id = ?")
        .bind(id)
        .fetch_optional(connection)
        .await?)
}

/// Lists up to `limit` estimators, newest first, older than the estimator `before`; those of this state, whose names have this text.
///
/// # Errors
/// When the database can't be read.
pub async fn page(
    connection: &mut SqliteConnection,
    (state, search): (Option<State>, Option<&str>),
    before: Option<&str>,
    limit: u32,
) -> Result<Vec<EstimatorRow>, StoreError> {
    let query = "select * from estimators
                 where (?1 is null or state = ?1) and (?2 is null or id < ?2)
                 and (?4 is null or instr(lower(name), lower(?4)) > 0 or substr(id, 1, length(?4)) = lower(?4))
                 order by id desc limit ?3";
    Ok(sqlx::query_as(query)
        .bind(state.map(State::as_str))
        .bind(before)
        .bind(limit)
        .bind(search)
        .fetch_all(connection)
        .await?)
}

/// Counts the estimators in each state.
///
/// # Errors
/// When the database can't be read.
pub async fn counts(connection: &mut SqliteConnection) -> Result<Vec<(State, i64)>, StoreError> {
    by_state(
        connection,
        "select state, count(*) from estimators group by state",
    )
    .await
}

/// Counts the estimators that wait.
///
/// # Errors
/// When the database can't be read.
pub async fn waiting(connection: &mut SqliteConnection) -> Result<u32, StoreError> {
    let query = "select count(*) from estimators where state = 'queued'";
    Ok(sqlx::query_scalar(query).fetch_one(connection).await?)
}

/// The estimator that has waited longest, and the memory that learning it may take, bytes.
///
/// # Errors
/// When the database can't be read.
pub async fn foremost(
    connection: &mut SqliteConnection,
) -> Result<Option<(String, u64)>, StoreError> {
    let query =
        "select id, memory_bytes from estimators where state = 'queued' order by id limit 1";
    let found: Option<(String, i64)> = sqlx::query_as(query).fetch_optional(connection).await?;
    Ok(found.map(|(id, bytes)| (id, u64::try_from(bytes).unwrap_or(0))))
}

/// Takes an estimator that waits; `None` when it doesn't any more.
///
/// # Errors
/// When the database can't be written.
pub async fn claim(
    connection: &mut SqliteConnection,
    id: &str,
) -> Result<Option<EstimatorRow>, StoreError> {
    let query =
        "update estimators set state_seal = null, state = 'running', started = coalesce(started, ?)
                 where id = ? and state = 'queued' returning *";
    Ok(sqlx::query_as(query)
        .bind(now())
        .bind(id)
        .fetch_optional(connection)
        .await?)
}

/// Whether an estimator is being learnt.
///
/// # Errors
/// When the database can't be read.
pub async fn is_running(connection: &mut SqliteConnection, id: &str) -> Result<bool, StoreError> {
    let query = "select exists (select 1 from estimators where id = ? and state = 'running')";
    Ok(sqlx::query_scalar(query)
        .bind(id)
        .fetch_one(connection)
        .await?)
}

/// Puts a running estimator back into the line; false when it isn't running any more.
///
/// # Errors
/// When the database can't be written.
pub async fn release(connection: &mut SqliteConnection, id: &str) -> Result<bool, StoreError> {
    let query = "update estimators set state_seal = null, state = 'queued' where id = ? and state = 'running'";
    let done = sqlx::query(query).bind(id).execute(connection).await?;
    Ok(done.rows_affected() == 1)
}

/// Counts a crash of the process that learns an estimator, and returns how many there were.
///
/// # Errors
/// When the database can't be written.
pub async fn count_crash(connection: &mut SqliteConnection, id: &str) -> Result<i64, StoreError> {
    let query = "update estimators set state_seal = null, crashes = crashes + 1 where id = ? returning crashes";
    let found = sqlx::query_scalar(query)
        .bind(id)
        .fetch_optional(connection)
        .await?;
    Ok(found.unwrap_or(0))
}

/// Puts every running estimator back into the line, and returns how many there were.
///
/// # Errors
/// When the database can't be written.
pub async fn release_all(connection: &mut SqliteConnection) -> Result<u64, StoreError> {
    let query = "update estimators set state_seal = null, state = 'queued' where state = 'running'";
    Ok(sqlx::query(query)
        .execute(connection)
        .await?
        .rows_affected())
}

/// Ends a running estimator with what was learnt; false when it isn't running any more, and then nothing is stored.
///
/// # Errors
/// When the database can't be written.
pub async fn finish(
    connection: &mut SqliteConnection,
    id: &str,
    parts: &[(Part, String)],
) -> Result<bool, StoreError> {
    if !end(connection, id, State::Done, None).await? {
        return Ok(false);
    }
    insert_parts(connection, id, parts).await?;
    forget(connection, id).await?;
    Ok(true)
}

/// Ends a running estimator without a model; false when it isn't running any more.
///
/// # Errors
/// When the database can't be written.
pub async fn fail(
    connection: &mut SqliteConnection,
    id: &str,
    error: &str,
) -> Result<bool, StoreError> {
    end(connection, id, State::Failed, Some(error)).await
}

async fn end(
    connection: &mut SqliteConnection,
    id: &str,
    state: State,
    error: Option<&str>,
) -> Result<bool, StoreError> {
    let query = "update estimators set state_seal = null, state = ?, error = ?, finished = ? where id = ? and state = 'running'";
    let done = sqlx::query(query)
        .bind(state.as_str())
        .bind(error)
        .bind(now())
        .bind(id)
        .execute(connection)
        .await?;
    Ok(done.rows_affected() == 1)
}

/// Cancels an estimator that hasn't ended; false when it has.
///
/// # Errors
/// When the database can't be written.
pub async fn cancel(connection: &mut SqliteConnection, id: &str) -> Result<bool, StoreError> {
    let query = "update estimators set state_seal = null, state = 'cancelled', finished = ? where id = ? and state in ('queued', 'running')";
    let done = sqlx::query(query)
        .bind(now())
        .bind(id)
        .execute(connection)
        .await?;
    Ok(done.rows_affected() == 1)
}

/// Compares all that is stored of an estimator with its hashes.
///
/// # Errors
/// [`StoreError::Damaged`] when something doesn't match; when the database can't be read.
pub async fn check(connection: &mut SqliteConnection, id: &str) -> Result<(), StoreError> {
    let row = find(connection, id).await?;
    if let Some(row) = &row {
        row.document()?;
    }
    recordings(connection, id).await?;
    zero(connection, id).await?;
    let is_done = row.is_some_and(|row| row.state() == State::Done);
    for kind in Part::ALL {
        if part(connection, id, kind).await?.is_some() != is_done {
            return Err(StoreError::Damaged {
                table: "estimator_parts",
                row: id.to_owned(),
            });
        }
    }
    Ok(())
}

/// Removes an estimator with its recordings, what was learnt, and its keys.
///
/// # Errors
/// When the database can't be written.
pub async fn remove(connection: &mut SqliteConnection, id: &str) -> Result<(), StoreError> {
    for change in [
        "delete from estimator_keys where estimator = ?",
        "delete from estimator_zeros where estimator = ?",
        "delete from estimator_parts where estimator = ?",
        "delete from estimator_recordings where estimator = ?",
        "delete from estimators where id = ?",
    ] {
        sqlx::query(change)
            .bind(id)
            .execute(&mut *connection)
            .await?;
    }
    Ok(())
}

/// The estimator submitted under this key, and the hash of what was submitted.
///
/// # Errors
/// When the database can't be read.
pub async fn under_key(
    connection: &mut SqliteConnection,
    key: &str,
) -> Result<Option<(String, String)>, StoreError> {
    seals::intact(connection, "estimator_keys", "key = ?", key).await?;
    Ok(
        sqlx::query_as("select estimator, sha256 from estimator_keys where key = ?")
            .bind(key)
            .fetch_optional(connection)
            .await?,
    )
}

/// Notes that this key stands for this estimator.
///
/// # Errors
/// When the key is taken, or the database can't be written.
pub async fn insert_key(
    connection: &mut SqliteConnection,
    key: &str,
    estimator: &str,
    sha256: &str,
) -> Result<(), StoreError> {
    sqlx::query("insert into estimator_keys (key, estimator, sha256, created) values (?, ?, ?, ?)")
        .bind(key)
        .bind(estimator)
        .bind(sha256)
        .bind(now())
        .execute(connection)
        .await?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::database::tests::fresh;
    use crate::queue::estimator_zeros::set;

    async fn queued(connection: &mut SqliteConnection, name: &str) -> String {
        let recordings = [("monday.csv", "time_s,s1,fz_n\n"), ("tuesday.csv", "")];
        let id = insert(connection, (name, "{}"), 1000, recordings.into_iter()).await;
        id.expect("stores")
    }

    #[tokio::test]
    async fn an_estimator_goes_from_the_line_to_its_end_once() {
        let (_folder, store) = fresh().await;
        let mut write = store.begin().await.expect("begins");
        let first = queued(&mut write, "first").await;
        let second = queued(&mut write, "second").await;
        let foremost = foremost(&mut write).await.expect("reads");
        assert_eq!(foremost, Some((first.clone(), 1000)));
        let claimed = claim(&mut write, &first).await.expect("claims");
        let claimed = claimed.expect("it waits");
        assert_eq!((&claimed.id, claimed.state()), (&first, State::Running));
        assert_eq!(waiting(&mut write).await.expect("counts"), 1);
        let texts = recordings(&mut write, &first).await.expect("reads");
        let files: Vec<&str> = texts.iter().map(|row| row.file.as_str()).collect();
        assert_eq!(files, ["monday.csv", "tuesday.csv"]);
        let parts = Part::ALL.map(|part| (part, format!("{{\"{}\": 1}}", part.as_str())));
        assert!(finish(&mut write, &first, &parts).await.expect("ends"));
        assert!(!fail(&mut write, &first, "late").await.expect("is guarded"));
        assert!(!cancel(&mut write, &first).await.expect("is guarded"));
        let model = part(&mut write, &first, Part::Model).await.expect("reads");
        assert_eq!(model.as_deref(), Some("{\"model\": 1}"));

        let claimed = claim(&mut write, &second).await.expect("claims");
        assert!(claimed.is_some() && is_running(&mut write, &second).await.expect("reads"));
        assert!(release(&mut write, &second).await.expect("releases"));
        assert!(!release(&mut write, &second).await.expect("is guarded"));
        assert_eq!(count_crash(&mut write, &second).await.expect("counts"), 1);
        assert_eq!(count_crash(&mut write, &second).await.expect("counts"), 2);
        claim(&mut write, &second)
            .await
            .expect("claims")
            .expect("it waits");
        assert_eq!(release_all(&mut write).await.expect("releases"), 1);
        assert!(cancel(&mut write, &second).await.expect("cancels"));
        assert!(!finish(&mut write, &second, &parts).await.expect("guards"));
        assert_eq!(
            part(&mut write, &second, Part::Report).await.expect("read"),
            None
        );
        assert!(claim(&mut write, &second).await.expect("claims").is_none());

        let newest = page(&mut write, (None, None), None, 1).await.expect("read");
        assert_eq!(newest[0].id, second);
        let older = page(
            &mut write,
            (Some(State::Done), Some("FIR")),
            Some(&second),
            5,
        )
        .await;
        assert_eq!(older.expect("reads")[0].id, first);
    }

    #[tokio::test]
    async fn what_was_changed_is_refused_by_its_table() {
        for (change, refused) in [
            (
                "update estimators set document = '{\"a\": 1}'",
                "estimators",
            ),
            (
                "update estimator_recordings set file = 'other.csv' where ordinal = 1",
                "estimator_recordings",
            ),
            (
                "update estimator_parts set document = '{}' where part = 'left-out'",
                "estimator_parts",
            ),
            (
                "update estimator_zeros set document = '{}'",
                "estimator_zeros",
            ),
            ("delete from estimator_zeros", "estimator_zeros"),
        ] {
            let (_folder, store) = fresh().await;
            let mut write = store.begin().await.expect("begins");
            let id = queued(&mut write, "spoiled").await;
            claim(&mut write, &id).await.expect("claims");
            let parts = Part::ALL.map(|part| (part, "{\"n\": 1}".to_owned()));
            finish(&mut write, &id, &parts).await.expect("ends");
            set(&mut write, &id, "{\"n\": 2}").await.expect("stores");
            check(&mut write, &id).await.expect("is whole");
            let spoiled = sqlx::query(change).execute(&mut *write).await;
            assert_eq!(spoiled.expect("updates").rows_affected(), 1);
            let found = check(&mut write, &id).await;
            assert!(
                matches!(found, Err(StoreError::Damaged { table, .. }) if table == refused),
                "{found:?}"
            );
        }
    }

    #[tokio::test]
    async fn nothing_is_left_of_what_is_removed() {
        let (_folder, store) = fresh().await;
        let mut write = store.begin().await.expect("begins");
        let id = queued(&mut write, "gone").await;
        insert_key(&mut write, "key", &id, "hash")
            .await
            .expect("stores");
        let under = under_key(&mut write, "key").await.expect("reads");
        assert_eq!(under, Some((id.clone(), "hash".to_owned())));
        claim(&mut write, &id).await.expect("claims");
        let parts = [(Part::Report, "{}".to_owned())];
        finish(&mut write, &id, &parts).await.expect("ends");
        set(&mut write, &id, "{}").await.expect("stores");
        remove(&mut write, &id).await.expect("removes");
        for table in [
            "select count(*) from estimators",
            "select count(*) from estimator_recordings",
            "select count(*) from estimator_parts",
            "select count(*) from estimator_keys",
            "select count(*) from estimator_zeros",
        ] {
            let left: i64 = sqlx::query_scalar(table)
                .fetch_one(&mut *write)
                .await
                .expect("counts");
            assert_eq!(left, 0, "{table}");
        }
    }
}
