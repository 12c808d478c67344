//! The queue of studies: one at a time, oldest first, each on all threads.
//!
//! One process holds the database, so nobody else can take a study: a guarded change of its state is all the claim
//! that is needed. No transaction is open while a study runs.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use placement::study::Study;
use serde_json::json;
use tokio::runtime::Handle;
use tokio::sync::{Notify, oneshot};

use crate::engine::{End, Engine};
use crate::shutdown::Shutdown;
use crate::store::studies::{self, StudyRow};
use crate::store::{Store, StoreError, crashes, events, idempotency};

/// How long to wait before the database is tried again.
const RETRY: Duration = Duration::from_secs(1);
/// How long to wait for space on the disk.
const SPACE: Duration = Duration::from_secs(5);

/// Takes studies in, runs them, cancels them.
pub struct Queue {
    engine: Engine,
    news: Notify,
    current: Mutex<Option<Current>>,
    shutdown: Shutdown,
}

struct Current {
    study: String,
    stop: Arc<AtomicBool>,
}

/// Why a study was not taken in.
#[derive(Debug, thiserror::Error)]
pub enum SubmitError {
    /// The key stands for another document.
    #[error("the idempotency key was used with another document")]
    KeyTaken,
    /// The database failed.
    #[error(transparent)]
    Store(#[from] StoreError),
}

impl Queue {
    /// A queue that works until `shutdown`.
    pub fn new(engine: Engine, shutdown: Shutdown) -> Self {
        Self {
            engine,
            news: Notify::new(),
            current: Mutex::new(None),
            shutdown,
        }
    }

    /// Takes a study in and returns its identifier. The same study under the same key is taken in once.
    ///
    /// # Errors
    /// [`SubmitError::KeyTaken`] when the key stands for another document; when the database can't be written.
    pub async fn submit(&self, study: &Study, key: Option<&str>) -> Result<String, SubmitError> {
        let store = &self.engine.store;
        let sha256 = study.spec_sha256();
        let mut transaction = store.begin().await?;
        if let Some(key) = key
            && let Some((id, before)) = idempotency::find(&mut transaction, key).await?
        {
            return if before == sha256 {
                Ok(id)
            } else {
                Err(SubmitError::KeyTaken)
            };
        }
        let id =
            studies::insert(&mut transaction, &study.name, &study.canonical(), &sha256).await?;
        if let Some(key) = key {
            idempotency::insert(&mut transaction, key, &id, &sha256).await?;
        }
        let event =
            events::insert(&mut transaction, &id, "queued", &json!({"resumed": false})).await?;
        store.commit(transaction, event).await?;
        self.news.notify_one();
        Ok(id)
    }

    /// Cancels a study; one that has ended stays as it is. A running solve ends within a Newton iteration.
    ///
    /// # Errors
    /// When the database can't be written.
    pub async fn cancel(&self, id: &str) -> Result<(), StoreError> {
        let store = &self.engine.store;
        let mut transaction = store.begin().await?;
        if studies::cancel(&mut transaction, id).await? {
            let event = events::insert(&mut transaction, id, "cancelled", &json!({})).await?;
            store.commit(transaction, event).await?;
        }
        let current = self.current.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(current) = current.as_ref().filter(|current| current.study == id) {
            current.stop.store(true, Ordering::Relaxed);
        }
        Ok(())
    }

    /// Runs studies until the service stops. A study that is running then goes back into the queue.
    pub async fn work(&self) {
        let mut shutdown = self.shutdown.clone();
        while !shutdown.requested() {
            match self.run_next().await {
                Ok(true) => {}
                Ok(false) => {
                    tokio::select! {
                        () = self.news.notified() => {}
                        () = shutdown.wait() => {}
                    }
                }
                Err(error) => {
                    tracing::error!(%error, "the queue can't go on; it tries again");
                    self.pause(RETRY).await;
                }
            }
        }
    }

    /// Runs the study that waits longest; false when none waits.
    async fn run_next(&self) -> Result<bool, StoreError> {
        let Some(row) = self.claim_oldest().await? else {
            return Ok(false);
        };
        let stop = Arc::new(AtomicBool::new(false));
        self.set_current(Some(Current {
            study: row.id.clone(),
            stop: stop.clone(),
        }));
        // A cancel that came before the flag was there to be set has changed the state instead.
        if self.still_running(&row.id).await? {
            tracing::info!(study = row.id, name = ?row.name, "study started");
            let end = self.run(row.clone(), stop).await;
            let wait = matches!(end, End::DiskFull);
            self.settle(&row, end).await;
            if wait {
                // Back in the queue, it would solve the point again only to find the disk as full as before.
                self.pause(SPACE).await;
            }
        }
        self.set_current(None);
        Ok(true)
    }

    async fn claim_oldest(&self) -> Result<Option<StudyRow>, StoreError> {
        let mut transaction = self.engine.store.begin().await?;
        let Some(id) = studies::oldest_queued(&mut transaction).await? else {
            return Ok(None);
        };
        let row = studies::claim(&mut transaction, &id).await?;
        self.engine.store.commit(transaction, 0).await?;
        Ok(row)
    }

    async fn still_running(&self, id: &str) -> Result<bool, StoreError> {
        let mut connection = self.engine.store.read().await?;
        studies::is_running(&mut connection, id).await
    }

    /// Runs a study on a thread of its own, so that the runtime stays free.
    async fn run(&self, row: StudyRow, stop: Arc<AtomicBool>) -> End {
        let (tell, told) = oneshot::channel();
        let (engine, runtime, flag) = (self.engine.clone(), Handle::current(), stop.clone());
        let thread = std::thread::Builder::new()
            .name("study".to_owned())
            .spawn(move || {
                let end = engine.run(&row, &runtime, &flag, &|_| {});
                // The receiver is gone only when the whole service is.
                let _ = tell.send(end);
            });
        if let Err(error) = thread {
            return End::failed(format!("no thread could be started for the study: {error}"));
        }
        let mut shutdown = self.shutdown.clone();
        let mut told = std::pin::pin!(told);
        let told = tokio::select! {
            told = &mut told => told,
            () = shutdown.wait() => {
                stop.store(true, Ordering::Relaxed);
                told.await
            }
        };
        told.unwrap_or_else(|_| End::failed("the study's thread panicked; the log says where"))
    }

    /// Records the end, however long the database takes to be writable again; at a shutdown the study is left as
    /// running, and goes back into the queue at the next start.
    async fn settle(&self, row: &StudyRow, mut end: End) {
        loop {
            match self.engine.settle(row, &end).await {
                Ok(true) => {
                    return tracing::info!(study = row.id, name = ?row.name, end = end.as_str(), "study ended");
                }
                Ok(false) => {
                    return tracing::info!(study = row.id, name = ?row.name, end = "cancelled", "study ended");
                }
                Err(error @ StoreError::NotFinite { .. }) => end = End::failed(error.to_string()),
                Err(error) => {
                    tracing::error!(study = row.id, %error, "the end of a study could not be recorded yet");
                    if self.shutdown.requested() {
                        return;
                    }
                    self.pause(RETRY).await;
                }
            }
        }
    }

    async fn pause(&self, time: Duration) {
        let mut shutdown = self.shutdown.clone();
        tokio::select! {
            () = tokio::time::sleep(time) => {}
            () = shutdown.wait() => {}
        }
    }

    fn set_current(&self, current: Option<Current>) {
        *self.current.lock().unwrap_or_else(PoisonError::into_inner) = current;
    }
}

/// Puts studies that a crash left running back into the queue. Call it before anything runs.
///
/// # Errors
/// When the database can't be written.
pub async fn recover(store: &Store) -> Result<(), StoreError> {
    let mut transaction = store.begin().await?;
    let blamed = crashes::count(&mut transaction).await?;
    if blamed > 0 {
        tracing::warn!(
            solves = blamed,
            "the program died in the middle of solves; they are tried again by themselves"
        );
    }
    let mut latest = 0;
    for id in studies::running(&mut transaction).await? {
        studies::release(&mut transaction, &id).await?;
        latest = events::insert(&mut transaction, &id, "queued", &json!({"resumed": true})).await?;
        tracing::info!(study = id, "study resumes after a crash");
    }
    store.commit(transaction, latest).await
}
