//! Sweeps: the studies of many designs taken in, extended, cancelled and taken up again as one.
//!
//! A design is a study in the queue like any other. What it shares with others isn't solved again, so that neither an extension nor a second
//! start repeats anything; where a sweep stands is read off its designs and stored nowhere.

use std::collections::HashSet;

use placement::study::Study;
use placement::sweep::{Design, Sweep, nameless};
use sqlx::SqliteConnection;

use crate::queue::{Queue, SubmitError, enqueue};
use crate::study_document::stored_study;
use store::content::sha256;
use store::queue::study_rows::State;
use store::queue::sweep_rows::{self, DesignRow, SweepRow};
use store::{Store, StoreError};

impl Queue {
    /// Takes a sweep in and returns its identifier. The same one under the same key is taken in once.
    ///
    /// # Errors
    /// See [`SubmitError`].
    pub async fn submit_sweep(
        &self,
        sweep: &Sweep,
        priority: i64,
        key: Option<&str>,
    ) -> Result<String, SubmitError> {
        let content = content_sha256(sweep);
        let mut transaction = self.store().begin().await?;
        if let Some(key) = key
            && let Some((id, before)) = sweep_rows::under_key(&mut transaction, key).await?
        {
            return if before == content {
                Ok(id)
            } else {
                Err(SubmitError::KeyTaken)
            };
        }
        self.room_for(&mut transaction, sweep.designs.len()).await?;
        let id = store(&mut transaction, sweep, priority).await?;
        if let Some(key) = key {
            sweep_rows::insert_key(&mut transaction, key, &id, &content).await?;
        }
        self.admit(transaction).await?;
        Ok(id)
    }

    /// Adds the designs that a sweep hasn't yet.
    ///
    /// # Errors
    /// See [`SubmitError`].
    pub async fn extend_sweep(
        &self,
        sweep: &SweepRow,
        designs: &[Design],
    ) -> Result<(), SubmitError> {
        let mut transaction = self.store().begin().await?;
        let new = not_there(&mut transaction, sweep, designs).await?;
        self.room_for(&mut transaction, new.len()).await?;
        add_all(&mut transaction, &sweep.id, sweep.priority, new).await?;
        Ok(self.admit(transaction).await?)
    }

    /// Lets designs that ended without a result be tried again.
    ///
    /// # Errors
    /// See [`SubmitError`].
    pub async fn resume_sweep(&self, sweep: &SweepRow) -> Result<(), SubmitError> {
        let mut transaction = self.store().begin().await?;
        let over = without_result(&mut transaction, sweep).await?;
        self.room_for(&mut transaction, over.len()).await?;
        put_back(&mut transaction, sweep, &over).await?;
        Ok(self.admit(transaction).await?)
    }

    /// Cancels what hasn't ended of a sweep.
    ///
    /// # Errors
    /// When the database can't be written.
    pub async fn cancel_sweep(&self, id: &str) -> Result<(), StoreError> {
        for design in designs_of(self.store(), id).await? {
            if !design.study.ended() {
                self.cancel(&design.study.id).await?;
            }
        }
        Ok(())
    }
}

async fn designs_of(store: &Store, id: &str) -> Result<Vec<DesignRow>, StoreError> {
    let mut connection = store.read().await?;
    sweep_rows::designs(&mut connection, id).await
}

/// Stores a sweep with a queued study for each design.
///
/// # Errors
/// When the database can't be written.
pub async fn store(
    connection: &mut SqliteConnection,
    sweep: &Sweep,
    priority: i64,
) -> Result<String, StoreError> {
    let document = sweep.base.canonical();
    let id = sweep_rows::insert(connection, &sweep.name, &document, priority).await?;
    add_all(connection, &id, priority, &sweep.designs).await?;
    Ok(id)
}

async fn add_all<'d>(
    connection: &mut SqliteConnection,
    sweep: &str,
    priority: i64,
    designs: impl IntoIterator<Item = &'d Design>,
) -> Result<(), StoreError> {
    for design in designs {
        let study = enqueue(connection, &design.study, priority).await?;
        sweep_rows::add_design(connection, sweep, &design.name, &design.set, &study).await?;
    }
    Ok(())
}

/// Adds the designs that a sweep hasn't yet.
///
/// # Errors
/// When the database can't be read or written.
pub async fn extend(
    connection: &mut SqliteConnection,
    sweep: &SweepRow,
    designs: &[Design],
) -> Result<(), StoreError> {
    let new = not_there(connection, sweep, designs).await?;
    add_all(connection, &sweep.id, sweep.priority, new).await
}

/// Those of the designs that a sweep hasn't yet.
async fn not_there<'d>(
    connection: &mut SqliteConnection,
    sweep: &SweepRow,
    designs: &'d [Design],
) -> Result<Vec<&'d Design>, StoreError> {
    let there = sweep_rows::designs(connection, &sweep.id).await?;
    // What this version can't read any more is no design that it could make.
    let there: HashSet<String> = there
        .iter()
        .filter_map(|row| stored_study(&row.study).ok())
        .map(|study| nameless(&study))
        .collect();
    let is_new = |design: &&Design| !there.contains(&nameless(&design.study));
    Ok(designs.iter().filter(is_new).collect())
}

/// Puts the designs that ended without a result back into the line, as new studies; the old ones stay as they ended.
///
/// # Errors
/// When the database can't be read or written.
pub async fn resume(connection: &mut SqliteConnection, sweep: &SweepRow) -> Result<(), StoreError> {
    let over = without_result(connection, sweep).await?;
    put_back(connection, sweep, &over).await
}

/// The designs that ended without a result and that this version can read, by their places.
async fn without_result(
    connection: &mut SqliteConnection,
    sweep: &SweepRow,
) -> Result<Vec<(i64, Study)>, StoreError> {
    let designs = sweep_rows::designs(connection, &sweep.id).await?;
    let over = designs
        .iter()
        .filter(|design| matches!(design.study.state(), State::Failed | State::Cancelled));
    let study = |design: &DesignRow| Some((design.ordinal, stored_study(&design.study).ok()?));
    Ok(over.filter_map(study).collect())
}

async fn put_back(
    connection: &mut SqliteConnection,
    sweep: &SweepRow,
    designs: &[(i64, Study)],
) -> Result<(), StoreError> {
    for (ordinal, study) in designs {
        let again = enqueue(connection, study, sweep.priority).await?;
        sweep_rows::replace_study(connection, &sweep.id, *ordinal, &again).await?;
    }
    Ok(())
}

/// Hash of all that a sweep asks for.
fn content_sha256(sweep: &Sweep) -> String {
    let mut parts = vec![sweep.name.clone(), sweep.base.canonical()];
    for design in &sweep.designs {
        parts.extend([design.name.clone(), design.study.canonical()]);
    }
    let parts: Vec<&[u8]> = parts.iter().map(|part| part.as_bytes()).collect();
    sha256(&parts)
}
