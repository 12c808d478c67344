//! Sweeps: the studies of many designs taken in, extended, cancelled and taken up again as one.
//!
//! A design is a study in the queue like any other. What it shares with others isn't solved again, so that neither an extension nor a second
//! start repeats anything; where a sweep stands is read off its designs and stored nowhere.

use std::collections::HashSet;
use std::ops::Range;

use documents::study::Study;
use documents::sweep::{Design, MOST_DESIGNS, Sweep, nameless};
use sqlx::SqliteConnection;

use crate::queue::submit_error::{SubmitError, TooManyDesigns};
use crate::queue::{Queue, enqueue};
use crate::study_document::stored_study;
use store::content::sha256;
use store::queue::design_rows::{self, DesignRow, Standing};
use store::queue::engine_rows;
use store::queue::study_rows::State;
use store::queue::sweep_rows::{self, SweepRow};
use store::{Store, StoreError};

/// Continuation of a sweep. Worked out before it is written: reading a thousand designs takes seconds, for which nobody else should wait.
#[derive(Debug, Default)]
pub struct Continuation {
    /// Designs that ended without a result and are tried again as new studies, by their places; the old ones stay as they ended.
    again: Vec<(i64, Study)>,
    /// Designs that it hasn't yet.
    new: Vec<Design>,
}

impl Continuation {
    /// Tries again what ended without a result, as far as this version can read it.
    pub fn resuming(there: &[DesignRow]) -> Self {
        let over = there
            .iter()
            .filter(|design| matches!(design.study.state(), State::Failed | State::Cancelled));
        let study = |design: &DesignRow| Some((design.ordinal, stored_study(&design.study).ok()?));
        Self {
            again: over.filter_map(study).collect(),
            new: Vec::new(),
        }
    }

    /// Adds those of the designs that it hasn't yet.
    ///
    /// # Errors
    /// [`TooManyDesigns`].
    pub fn and_adding(
        self,
        there: &[DesignRow],
        designs: Vec<Design>,
    ) -> Result<Self, TooManyDesigns> {
        // What this version can't read any more is no design that it could make.
        let known: HashSet<String> = there
            .iter()
            .filter_map(|row| stored_study(&row.study).ok())
            .map(|study| nameless(&study))
            .collect();
        let is_new = |design: &Design| !known.contains(&nameless(&design.study));
        let new: Vec<Design> = designs.into_iter().filter(is_new).collect();
        fits(there.len(), new.len())?;
        Ok(Self { new, ..self })
    }

    /// Puts its studies into the line.
    ///
    /// # Errors
    /// When the database can't be written.
    pub async fn store(
        &self,
        connection: &mut SqliteConnection,
        sweep: &SweepRow,
    ) -> Result<(), StoreError> {
        for (ordinal, study) in &self.again {
            let again = enqueue(connection, study, sweep.priority).await?;
            design_rows::replace_study(connection, &sweep.id, *ordinal, &again).await?;
        }
        add_all(connection, &sweep.id, sweep.priority, &self.new).await
    }
}

impl Queue {
    /// Takes a sweep in and returns its identifier. The same one under the same key is taken in once. Where an engine is named, its studies wait until that is done.
    ///
    /// # Errors
    /// See [`SubmitError`].
    pub async fn submit_sweep(
        &self,
        sweep: &Sweep,
        priority: i64,
        key: Option<&str>,
        engine: Option<&str>,
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
        if let Some(engine) = engine {
            engine_rows::begin(&mut transaction, &id, engine).await?;
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
        designs: Vec<Design>,
    ) -> Result<(), SubmitError> {
        let work = move |there: &[DesignRow]| Continuation::default().and_adding(there, designs);
        self.continue_sweep(sweep, None, work).await
    }

    /// Lets designs that ended without a result be tried again, by an engine where one is named.
    ///
    /// # Errors
    /// See [`SubmitError`].
    pub async fn resume_sweep(
        &self,
        sweep: &SweepRow,
        engine: Option<&str>,
    ) -> Result<(), SubmitError> {
        let work = |there: &[DesignRow]| Ok(Continuation::resuming(there));
        self.continue_sweep(sweep, engine, work).await
    }

    async fn continue_sweep(
        &self,
        sweep: &SweepRow,
        engine: Option<&str>,
        work: impl FnOnce(&[DesignRow]) -> Result<Continuation, TooManyDesigns> + Send + 'static,
    ) -> Result<(), SubmitError> {
        // Two at once would both add what it hasn't yet.
        let _alone = self.continuing.lock().await;
        let there = designs_of(self.store(), &sweep.id).await?;
        let worked_out = tokio::task::spawn_blocking(move || work(&there)).await;
        let continuation = worked_out.map_err(|_| SubmitError::Broken)??;
        let studies = continuation.again.len() + continuation.new.len();
        let mut transaction = self.store().begin().await?;
        self.room_for(&mut transaction, studies).await?;
        continuation.store(&mut transaction, sweep).await?;
        if let Some(engine) = engine {
            engine_rows::begin(&mut transaction, &sweep.id, engine).await?;
        }
        Ok(self.admit(transaction).await?)
    }

    /// Cancels what hasn't ended of a sweep.
    ///
    /// # Errors
    /// When the database can't be written.
    pub async fn cancel_sweep(&self, id: &str) -> Result<(), StoreError> {
        let mut connection = self.store().read().await?;
        let open = design_rows::open_studies(&mut connection, id).await?;
        drop(connection);
        let open: Vec<&str> = open.iter().map(String::as_str).collect();
        self.cancel_all(&open).await
    }
}

/// Refuses more designs than a sweep may have.
fn fits(there: usize, more: usize) -> Result<(), TooManyDesigns> {
    if more > 0 && there + more > MOST_DESIGNS {
        return Err(TooManyDesigns { there, more });
    }
    Ok(())
}

/// The designs of a sweep with their studies, in order.
///
/// # Errors
/// When the database can't be read.
pub async fn designs_of(store: &Store, id: &str) -> Result<Vec<DesignRow>, StoreError> {
    designs_within(store, id, design_rows::ALL).await
}

/// The designs of a sweep at these places, as [`designs_of`] has all.
///
/// # Errors
/// When the database can't be read.
pub async fn designs_within(
    store: &Store,
    id: &str,
    places: Range<usize>,
) -> Result<Vec<DesignRow>, StoreError> {
    let mut connection = store.read().await?;
    design_rows::designs(&mut connection, id, places).await
}

/// Standing of a sweep.
///
/// # Errors
/// When the database can't be read.
pub async fn standing_of(store: &Store, id: &str) -> Result<Standing, StoreError> {
    let mut connection = store.read().await?;
    design_rows::standing(&mut connection, id).await
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

async fn add_all(
    connection: &mut SqliteConnection,
    sweep: &str,
    priority: i64,
    designs: &[Design],
) -> Result<(), StoreError> {
    for design in designs {
        let study = enqueue(connection, &design.study, priority).await?;
        design_rows::add_design(connection, sweep, &design.name, &design.set, &study).await?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_is_never_extended_beyond_what_one_may_have() {
        for (there, more, is_fit) in [
            (MOST_DESIGNS - 1, 1, true),
            (MOST_DESIGNS, 1, false),
            // What it has already is no more.
            (MOST_DESIGNS, 0, true),
        ] {
            assert_eq!(fits(there, more).is_ok(), is_fit, "{there} and {more}");
        }
        let refused = fits(MOST_DESIGNS, 2).map_err(|error| error.to_string());
        let told =
            "the sweep has 100000 designs and would have 2 more; 100000 are the most of one sweep";
        assert_eq!(refused, Err(told.to_owned()));
    }
}
