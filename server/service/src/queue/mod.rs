//! The queue of studies: one at a time, each on all threads, in turns.
//!
//! A study keeps its turn while nobody waits. Otherwise it ends at a point's end, and the study goes to the end of the line:
//! what it has solved is in the database, so that taking it up again costs little and changes no bit of its result.
//!
//! One process holds the database, so nobody else can take a study: a guarded change of its state is all the claim
//! that is needed. No transaction is open while a study runs.
//!
//! - [`sweeps`]: many designs of a study as one
//! - [`removal`]: taking studies and sweeps out
//! - `submit_error`: why something was not taken in

pub mod removal;
mod submit_error;
pub mod sweeps;

use std::convert::Infallible;
use std::future::pending;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use documents::study::Study;
use serde_json::json;
use sqlx::{Sqlite, SqliteConnection, Transaction};
use tokio::runtime::Handle;
use tokio::sync::{Mutex, Notify, oneshot, watch};

use crate::engine::{End, Engine};
use crate::work::shutdown::Shutdown;

use store::file::upkeep;
use store::points::crashes;
use store::queue::event_rows;
use store::queue::idempotency;
use store::queue::study_rows::{self, StudyRow};
use store::queue::turns;
use store::{Store, StoreError};
pub use submit_error::{SubmitError, TooManyDesigns};

/// Time to wait before the database is tried again.
const RETRY: Duration = Duration::from_secs(1);
/// Time to wait for space on the disk.
const SPACE: Duration = Duration::from_secs(5);
/// Interval at which a study that runs looks whether another one waits, at least.
const LOOK: Duration = Duration::from_secs(1);

/// Takes studies in, runs them, cancels them.
pub struct Queue {
    engine: Engine,
    turn: Duration,
    most_waiting: u32,
    news: Notify,
    current: watch::Sender<Option<Current>>,
    /// Guard by which one sweep at a time goes on.
    continuing: Mutex<()>,
    /// Whether a study waits for room in the database.
    lacks_room: AtomicBool,
    shutdown: Shutdown,
}

/// The study that has its turn.
#[derive(Clone)]
struct Current {
    study: String,
    stop: Arc<AtomicBool>,
}

impl Queue {
    /// A queue of so many studies that works until `shutdown`; a study's turn is this long when others wait.
    pub fn new(engine: Engine, turn: Duration, most_waiting: u32, shutdown: Shutdown) -> Self {
        Self {
            engine,
            turn,
            most_waiting,
            news: Notify::new(),
            current: watch::Sender::new(None),
            continuing: Mutex::new(()),
            lacks_room: AtomicBool::new(false),
            shutdown,
        }
    }

    /// Takes a study in and returns its identifier. The same study under the same key is taken in once, with its first priority.
    ///
    /// # Errors
    /// See [`SubmitError`].
    pub async fn submit(
        &self,
        study: &Study,
        priority: i64,
        key: Option<&str>,
    ) -> Result<String, SubmitError> {
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
        self.room_for(&mut transaction, 1).await?;
        let id = enqueue(&mut transaction, study, priority).await?;
        if let Some(key) = key {
            idempotency::insert(&mut transaction, key, &id, &sha256).await?;
        }
        self.admit(transaction).await?;
        Ok(id)
    }

    /// Refuses so many more studies when too many wait already, or when there is no room for what they would find.
    ///
    /// # Errors
    /// [`SubmitError::TooMany`], [`StoreError::Full`]; when the database can't be read.
    pub(crate) async fn room_for(
        &self,
        connection: &mut SqliteConnection,
        studies: usize,
    ) -> Result<(), SubmitError> {
        let most = self.most_waiting;
        let waiting = turns::waiting(connection).await?;
        let more = u32::try_from(studies).unwrap_or(u32::MAX);
        if waiting.saturating_add(more) > most {
            return Err(SubmitError::TooMany { most });
        }
        // Room on the disk may come from elsewhere; within the bound of the file it comes from what is removed here.
        if self.store().is_bounded() && self.lacks_room.load(Ordering::Relaxed) {
            return Err(StoreError::Full.into());
        }
        Ok(upkeep::check_room(connection).await?)
    }

    /// The database that the line is in.
    pub fn store(&self) -> &Arc<Store> {
        &self.engine.store
    }

    /// Commits what was put into the line, and starts working it off.
    ///
    /// # Errors
    /// When the database can't be written.
    pub async fn admit(
        &self,
        mut transaction: Transaction<'static, Sqlite>,
    ) -> Result<(), StoreError> {
        let event = event_rows::latest(&mut transaction).await?;
        self.engine.store.commit(transaction, event).await?;
        self.news.notify_one();
        Ok(())
    }

    /// Cancels a study; one that has ended stays as it is. A running solve ends within a Newton iteration.
    ///
    /// # Errors
    /// When the database can't be written.
    pub async fn cancel(&self, id: &str) -> Result<(), StoreError> {
        self.cancel_all(&[id]).await
    }

    /// Cancels studies at once, as [`Queue::cancel`] does one.
    pub(super) async fn cancel_all(&self, ids: &[&str]) -> Result<(), StoreError> {
        let store = &self.engine.store;
        let mut transaction = store.begin().await?;
        let mut event = None;
        for id in ids {
            if study_rows::cancel(&mut transaction, id).await? {
                let nothing = json!({});
                let told = event_rows::insert(&mut transaction, id, "cancelled", &nothing);
                event = Some(told.await?);
            }
        }
        if let Some(event) = event {
            store.commit(transaction, event).await?;
        }
        // Whether others lack it too is seen when they are stored.
        self.lacks_room.store(false, Ordering::Relaxed);
        let current = self.current.borrow();
        let is_cancelled = |current: &&Current| ids.contains(&current.study.as_str());
        if let Some(current) = current.as_ref().filter(is_cancelled) {
            current.stop.store(true, Ordering::Relaxed);
        }
        Ok(())
    }

    /// Waits until nothing works on a study any more.
    pub(crate) async fn let_go(&self, id: &str) {
        let mut current = self.current.subscribe();
        let is_other =
            |current: &Option<Current>| current.as_ref().is_none_or(|current| current.study != id);
        // The sender lives as long as the queue.
        let _ = current.wait_for(is_other).await;
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

    /// Runs the study whose turn it is; false when none waits.
    async fn run_next(&self) -> Result<bool, StoreError> {
        let Some(row) = self.claim_next().await? else {
            return Ok(false);
        };
        let stop = Arc::new(AtomicBool::new(false));
        self.current.send_replace(Some(Current {
            study: row.id.clone(),
            stop: stop.clone(),
        }));
        // A cancel that came before the flag was there to be set has changed the state instead.
        if self.still_running(&row.id).await? {
            tracing::info!(study = row.id, name = ?row.name, "study started");
            let end = self.run(row.clone(), stop).await;
            let wait = matches!(end, End::Unstorable(_));
            let lacks_room = matches!(end, End::Unstorable(StoreError::Full));
            self.settle(&row, end).await;
            self.lacks_room.store(lacks_room, Ordering::Relaxed);
            self.current.send_replace(None);
            if wait {
                // Back in the queue, it would solve the point again only to find the disk as full as before, or the database still gone.
                self.pause(SPACE).await;
            }
        }
        self.current.send_replace(None);
        Ok(true)
    }

    async fn claim_next(&self) -> Result<Option<StudyRow>, StoreError> {
        let mut transaction = self.engine.store.begin().await?;
        let Some(id) = turns::next(&mut transaction).await? else {
            return Ok(None);
        };
        let row = turns::claim(&mut transaction, &id).await?;
        self.engine.store.commit(transaction, 0).await?;
        Ok(row)
    }

    async fn still_running(&self, id: &str) -> Result<bool, StoreError> {
        let mut connection = self.engine.store.read().await?;
        study_rows::is_running(&mut connection, id).await
    }

    /// Runs a study on a thread of its own, so that the runtime stays free, until its end, a shutdown or the end of its turn.
    async fn run(&self, row: StudyRow, stop: Arc<AtomicBool>) -> End {
        let (tell, told) = oneshot::channel();
        let pause = Arc::new(AtomicBool::new(false));
        let priority = row.priority;
        let (engine, runtime) = (self.engine.clone(), Handle::current());
        let flags = (stop.clone(), pause.clone());
        let thread = std::thread::Builder::new()
            .name("study".to_owned())
            .spawn(move || {
                let end = engine.run(&row, &runtime, &flags.0, Some(&flags.1), &|_| {});
                // The receiver is gone only when the whole service is.
                let _ = tell.send(end);
            });
        if let Err(error) = thread {
            return End::failed(format!("no thread could be started for the study: {error}"));
        }
        let mut shutdown = self.shutdown.clone();
        let stopping = async {
            shutdown.wait().await;
            stop.store(true, Ordering::Relaxed);
            pending::<Infallible>().await
        };
        let pausing = async {
            self.turn_over(priority).await;
            pause.store(true, Ordering::Relaxed);
            pending::<Infallible>().await
        };
        let told = tokio::select! {
            told = told => told,
            never = stopping => match never {},
            never = pausing => match never {},
        };
        told.unwrap_or_else(|_| End::failed("the study's thread panicked; the log says where"))
    }

    /// Waits until a study of higher priority waits or, once the turn has lasted long enough, one of the same, or a fit for memory.
    async fn turn_over(&self, priority: i64) {
        let begun = Instant::now();
        loop {
            tokio::time::sleep(LOOK.min(self.turn)).await;
            let rival = priority + i64::from(begun.elapsed() < self.turn);
            let is_over = begun.elapsed() >= self.turn;
            match self.is_awaited(rival).await {
                Ok(awaited) if awaited || (is_over && self.engine.memory.is_awaited()) => return,
                Ok(_) => {}
                Err(error) => tracing::warn!(%error, "whether a study waits isn't known"),
            }
        }
    }

    async fn is_awaited(&self, priority: i64) -> Result<bool, StoreError> {
        let mut connection = self.engine.store.read().await?;
        turns::is_awaited(&mut connection, priority).await
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
                    let lacks_room = matches!(error, StoreError::Full);
                    self.lacks_room.store(lacks_room, Ordering::Relaxed);
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
}

/// Puts a study at the end of the line and returns its identifier.
///
/// # Errors
/// When the database can't be written.
pub async fn enqueue(
    connection: &mut SqliteConnection,
    study: &Study,
    priority: i64,
) -> Result<String, StoreError> {
    let id = study_rows::insert(connection, &study.name, &study.canonical()).await?;
    turns::set_priority(connection, &id, priority).await?;
    event_rows::insert(connection, &id, "queued", &json!({"resumed": false})).await?;
    Ok(id)
}

/// Puts studies that a crash left running back into the queue. Call it before anything runs.
///
/// # Errors
/// When the database can't be written.
pub async fn recover(store: &Store) -> Result<(), StoreError> {
    let mut transaction = store.begin().await?;
    let suspect = crashes::suspect(&mut transaction).await?;
    if suspect > 0 {
        tracing::warn!(
            solves = suspect,
            "the program died in the middle of solves; each is tried again in a process of its own"
        );
    }
    let mut latest = 0;
    for id in turns::running(&mut transaction).await? {
        turns::release(&mut transaction, &id).await?;
        latest =
            event_rows::insert(&mut transaction, &id, "queued", &json!({"resumed": true})).await?;
        tracing::info!(study = id, "study resumes after a crash");
    }
    store.commit(transaction, latest).await
}
