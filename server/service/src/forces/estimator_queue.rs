//! The line of estimators that the service learns, in turns, beside the studies' queue.
//!
//! Each is learnt in a process of its own, which touches no database: what it finds is stored here, guarded by the state, so that what was cancelled or removed meanwhile
//! stays so. A process keeps its turn while nobody waits; otherwise it rests where it is, and the next one works. How far they are stays in memory.

use std::collections::{HashMap, VecDeque};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use document::fault::Fault;
use estimation::recipe::Recipe;
use store::file::upkeep;
use store::queue::estimator_parts;
use store::queue::estimator_rows::{self, EstimatorRow};
use store::{Store, StoreError};
use tokio::sync::Notify;

use crate::forces::fit_forecast::stored_forecast;
use crate::forces::fit_process::FitOrder;
use crate::forces::learning::{Ending, FitWork, Learning, sentence};
use crate::forces::recorded_texts::NamedText;
use crate::forces::submission_reader::Submission;
use crate::wire::estimator_wire::{EstimatorDetail, FitProgress, StoredEstimator};
use crate::work::memory_share::{MemoryShare, TakenMemory};
use crate::work::own_process::Start;
use crate::work::shutdown::Shutdown;

/// Time to wait before the database is tried again.
const RETRY: Duration = Duration::from_secs(1);
/// Interval at which it is looked whether another one waits, once a turn is over.
const LOOK: Duration = Duration::from_secs(1);
/// Estimators that may wait: with the largest recordings 6 GB of the database.
pub(crate) const MOST_WAITING: u32 = 100;
/// Estimators that may rest: each keeps its memory.
const MOST_RESTING: usize = 3;
/// Crashes of its own process after which an estimator is given up, as a point of a study is.
const QUARANTINE: i64 = 3;

/// Takes estimators in, learns them, cancels them.
pub struct EstimatorQueue {
    store: Arc<Store>,
    means: FitMeans,
    news: Notify,
    learning: Mutex<HashMap<String, Arc<FitWork>>>,
    shutdown: Shutdown,
}

/// Means that fits have.
pub struct FitMeans {
    /// Starts a process that learns: this program with [`ARGUMENT`](crate::forces::fit_process::ARGUMENT).
    pub start: Start,
    /// Threads of a process.
    pub threads: usize,
    /// Time that a process works before another one that waits has its turn.
    pub turn: Duration,
    /// Memory that a process may take, bytes.
    pub memory_bytes: u64,
    /// Memory that is shared with studies.
    pub memory: Arc<MemoryShare>,
}

/// Reason why an estimator was not taken in.
#[derive(Debug, thiserror::Error)]
pub enum UntakenError {
    /// The key stands for another document.
    #[error("this Idempotency-Key was used with another document")]
    KeyTaken,
    /// A queue in which so many wait that another one is not taken in.
    #[error("at most {MOST_WAITING} estimators may wait: send it again when some are done")]
    TooMany,
    /// The database failed.
    #[error(transparent)]
    Store(#[from] StoreError),
}

impl EstimatorQueue {
    /// A line whose fits have these means, until `shutdown`.
    pub fn new(store: Arc<Store>, means: FitMeans, shutdown: Shutdown) -> Self {
        Self {
            store,
            means,
            news: Notify::new(),
            learning: Mutex::default(),
            shutdown,
        }
    }

    /// Takes an estimator in and returns its identifier. The same submission under the same key is taken in once.
    ///
    /// # Errors
    /// See [`UntakenError`].
    pub async fn submit(
        &self,
        submission: &Submission,
        key: Option<&str>,
    ) -> Result<String, UntakenError> {
        let sha256 = submission.sha256();
        let mut transaction = self.store.begin().await?;
        if let Some(key) = key
            && let Some((id, before)) = estimator_rows::under_key(&mut transaction, key).await?
        {
            return if before == sha256 {
                Ok(id)
            } else {
                Err(UntakenError::KeyTaken)
            };
        }
        if estimator_rows::waiting(&mut transaction).await? >= MOST_WAITING {
            return Err(UntakenError::TooMany);
        }
        upkeep::check_room(&mut transaction).await?;
        let files = &submission.files;
        let texts = files.iter().map(|file| (&*file.name, &*file.text));
        let (name, document) = (&submission.name, &submission.document);
        let id = estimator_rows::insert(
            &mut transaction,
            (name, document),
            submission.memory_bytes,
            texts,
        )
        .await?;
        if let Some(key) = key {
            estimator_rows::insert_key(&mut transaction, key, &id, &sha256).await?;
        }
        self.store.commit(transaction, 0).await?;
        self.news.notify_one();
        Ok(id)
    }

    /// Returns an estimator with how far its fit is, and what it takes.
    ///
    /// # Errors
    /// When its document doesn't match its hash.
    pub fn detail(&self, row: &EstimatorRow) -> Result<EstimatorDetail, StoreError> {
        let forecast = |stored: &StoredEstimator| stored_forecast(stored, self.means.threads);
        EstimatorDetail::of(row, self.progress(&row.id), &forecast)
    }

    /// Returns how far the fit of an estimator is; `None` of one that isn't being learnt.
    fn progress(&self, id: &str) -> Option<FitProgress> {
        Some(self.learning().get(id)?.progress())
    }

    /// Cancels an estimator; one that has ended stays as it is. Its process ends at once.
    ///
    /// # Errors
    /// When the database can't be written.
    pub async fn cancel(&self, id: &str) -> Result<(), StoreError> {
        let mut transaction = self.store.begin().await?;
        estimator_rows::cancel(&mut transaction, id).await?;
        self.store.commit(transaction, 0).await?;
        self.stop(id);
        Ok(())
    }

    /// Removes an estimator, running or not, with its recordings and what was learnt.
    ///
    /// # Errors
    /// When the database can't be written.
    pub async fn remove(&self, id: &str) -> Result<(), StoreError> {
        let mut transaction = self.store.begin().await?;
        estimator_rows::remove(&mut transaction, id).await?;
        self.store.commit(transaction, 0).await?;
        self.stop(id);
        Ok(())
    }

    fn stop(&self, id: &str) {
        if let Some(work) = self.learning().get(id) {
            work.stop();
        }
    }

    fn learning(&self) -> MutexGuard<'_, HashMap<String, Arc<FitWork>>> {
        self.learning.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Learns estimators until the service stops. Those that are being learnt then go back into the line.
    pub async fn work(&self) {
        let mut shutdown = self.shutdown.clone();
        let mut resting = VecDeque::new();
        while !shutdown.requested() {
            match self.next(&mut resting).await {
                Ok(Some(learning)) => resting.extend(self.turn(learning, resting.len()).await),
                Ok(None) => {
                    tokio::select! {
                        () = self.news.notified() => {}
                        () = shutdown.wait() => {}
                    }
                }
                Err(error) => {
                    tracing::error!(%error, "the line of estimators can't go on; it tries again");
                    self.pause().await;
                }
            }
        }
        for learning in resting {
            learning.work.stop();
            self.settle(&learning.row, &Ending::Stopped).await;
        }
    }

    /// The estimator whose turn it is: one that waits, where there is room for it, or the one that has rested longest.
    async fn next(&self, resting: &mut VecDeque<Learning>) -> Result<Option<Learning>, StoreError> {
        let begun = match resting.len() < MOST_RESTING {
            true => self.begin(resting.is_empty()).await?,
            false => None,
        };
        Ok(begun.or_else(|| {
            let learning = resting.pop_front()?;
            learning.work.go_on();
            Some(learning)
        }))
    }

    /// Begins the estimator that has waited longest, as soon as its memory is free, or where it is; none where none waits.
    async fn begin(&self, waits: bool) -> Result<Option<Learning>, StoreError> {
        let mut connection = self.store.read().await?;
        let foremost = estimator_rows::foremost(&mut connection).await?;
        drop(connection);
        let Some((id, memory_bytes)) = foremost else {
            return Ok(None);
        };
        let Some(memory) = self.memory(memory_bytes, waits).await else {
            return Ok(None);
        };
        let mut transaction = self.store.begin().await?;
        let Some(row) = estimator_rows::claim(&mut transaction, &id).await? else {
            return Ok(None);
        };
        self.store.commit(transaction, 0).await?;
        tracing::info!(estimator = row.id, name = ?row.name, "estimator started");
        match self.asked(&row).await {
            Ok(Ok(order)) => {
                let learning = Learning::start(row, (self.means.start)(), order, memory);
                self.started(learning).await.map(Some)
            }
            Ok(Err(faults)) => {
                self.settle(&row, &Ending::Failed(sentence(&faults))).await;
                Ok(None)
            }
            // What is damaged stays so: others may go on.
            Err(error @ StoreError::Damaged { .. }) => {
                self.settle(&row, &Ending::Failed(error.to_string())).await;
                Ok(None)
            }
            Err(error) => {
                self.settle(&row, &Ending::Stopped).await;
                Err(error)
            }
        }
    }

    async fn memory(&self, bytes: u64, waits: bool) -> Option<TakenMemory> {
        if !waits {
            return self.means.memory.try_take(bytes);
        }
        let mut shutdown = self.shutdown.clone();
        tokio::select! {
            taken = self.means.memory.take(bytes) => taken,
            () = shutdown.wait() => None,
        }
    }

    /// Makes a process known to those who cancel. A cancel that came before has changed the state instead.
    async fn started(&self, learning: Learning) -> Result<Learning, StoreError> {
        let id = &learning.row.id;
        self.learning().insert(id.clone(), learning.work.clone());
        let mut connection = self.store.read().await?;
        if !estimator_rows::is_running(&mut connection, id).await? {
            learning.work.stop();
        }
        Ok(learning)
    }

    async fn asked(&self, row: &EstimatorRow) -> Result<Result<FitOrder, Vec<Fault>>, StoreError> {
        let mut connection = self.store.read().await?;
        // A row that was exchanged with another one isn't what it was claimed as.
        estimator_rows::find(&mut connection, &row.id).await?;
        let recipe = match Recipe::from_value(&StoredEstimator::of(row)?.recipe) {
            Ok(recipe) => recipe,
            Err(faults) => return Ok(Err(faults)),
        };
        let rows = estimator_parts::recordings(&mut connection, &row.id).await?;
        let named = rows.into_iter().map(|row| NamedText {
            name: row.file,
            text: row.text,
        });
        Ok(Ok(FitOrder {
            recipe,
            files: named.collect(),
            threads: self.means.threads,
            memory_bytes: self.means.memory_bytes,
        }))
    }

    /// Lets a process work until its end, a shutdown, or the end of its turn; returns what then rests.
    async fn turn(&self, mut learning: Learning, resting: usize) -> Option<Learning> {
        let mut shutdown = self.shutdown.clone();
        let ending = tokio::select! {
            ending = learning.ended() => ending,
            () = self.turn_over(resting) => {
                learning.work.rest();
                return Some(learning);
            }
            () = shutdown.wait() => {
                learning.work.stop();
                Ending::Stopped
            }
        };
        self.settle(&learning.row, &ending).await;
        None
    }

    /// Waits until another one is to have its turn, once this turn has lasted long enough.
    async fn turn_over(&self, resting: usize) {
        tokio::time::sleep(self.means.turn).await;
        while resting == 0 && !self.is_awaited().await {
            tokio::time::sleep(LOOK.min(self.means.turn)).await;
        }
    }

    async fn is_awaited(&self) -> bool {
        let waiting = async {
            let mut connection = self.store.read().await?;
            estimator_rows::waiting(&mut connection).await
        };
        match waiting.await {
            Ok(waiting) => waiting > 0,
            Err(error) => {
                tracing::warn!(%error, "whether an estimator waits isn't known");
                false
            }
        }
    }

    /// Records the end, however long the database takes to be writable again; at a shutdown the estimator may be left as running, and goes back into the line at
    /// the next start.
    async fn settle(&self, row: &EstimatorRow, ending: &Ending) {
        self.learning().remove(&row.id);
        loop {
            match self.record(row, ending).await {
                Ok("queued") => {
                    return tracing::info!(estimator = row.id, name = ?row.name, "estimator goes back into its line");
                }
                Ok(end) => {
                    return tracing::info!(estimator = row.id, name = ?row.name, end, "estimator ended");
                }
                Err(error) => {
                    tracing::error!(estimator = row.id, %error, "the end of an estimator could not be recorded yet");
                    if self.shutdown.requested() {
                        return;
                    }
                    self.pause().await;
                }
            }
        }
    }

    async fn record(
        &self,
        row: &EstimatorRow,
        ending: &Ending,
    ) -> Result<&'static str, StoreError> {
        let mut transaction = self.store.begin().await?;
        let (kept, end) = match ending {
            Ending::Learnt(parts) => {
                let kept = estimator_rows::finish(&mut transaction, &row.id, parts).await?;
                (kept, "done")
            }
            Ending::Failed(error) => {
                let kept = estimator_rows::fail(&mut transaction, &row.id, error).await?;
                (kept, "failed")
            }
            Ending::Crashed(detail) => {
                let crashes = estimator_rows::count_crash(&mut transaction, &row.id).await?;
                if crashes < QUARANTINE {
                    let released = estimator_rows::release(&mut transaction, &row.id).await?;
                    (released, "queued")
                } else {
                    let error =
                        format!("its process crashed {crashes} times, the last time by {detail}");
                    let kept = estimator_rows::fail(&mut transaction, &row.id, &error).await?;
                    (kept, "failed")
                }
            }
            Ending::Stopped => {
                let released = estimator_rows::release(&mut transaction, &row.id).await?;
                (released, "queued")
            }
        };
        self.store.commit(transaction, 0).await?;
        Ok(if kept { end } else { "cancelled" })
    }

    async fn pause(&self) {
        let mut shutdown = self.shutdown.clone();
        tokio::select! {
            () = tokio::time::sleep(RETRY) => {}
            () = shutdown.wait() => {}
        }
    }
}

/// Puts estimators that were left running back into the line. Call it before anything runs.
///
/// # Errors
/// When the database can't be written.
pub async fn recover(store: &Store) -> Result<(), StoreError> {
    let mut transaction = store.begin().await?;
    let resumed = estimator_rows::release_all(&mut transaction).await?;
    store.commit(transaction, 0).await?;
    if resumed > 0 {
        tracing::info!(
            estimators = resumed,
            "estimators are learnt again after a crash"
        );
    }
    Ok(())
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use std::process::Command;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::Instant;

    use serde_json::json;
    use tempfile::TempDir;

    use super::*;
    use crate::forces::submission_reader::{FitLimits, read_submission};
    use crate::work::shutdown;

    /// Time far beyond what anything here takes.
    const PATIENCE: Duration = Duration::from_secs(30);

    fn submission(name: &str) -> Submission {
        let row = |row: i32| {
            format!(
                "{},{},{}\n",
                0.01 * f64::from(row),
                2 * (row % 10),
                row % 10
            )
        };
        let text = "time_s,s1,fz_n\n".to_owned() + &(0..60).map(row).collect::<String>();
        let document = json!({"name": name, "recordings": [{"file": "a.csv", "text": text}]});
        let limits = FitLimits {
            threads: 1,
            memory_bytes: u64::MAX,
        };
        read_submission(document, limits).expect("reads")
    }

    /// A line in which the scripts learn, one after the other, the last of them again and again.
    async fn line(scripts: Vec<&'static str>) -> (TempDir, Arc<EstimatorQueue>) {
        let folder = tempfile::tempdir().expect("a folder");
        let store = Store::open(&folder.path().join("a.db")).await;
        let started = AtomicUsize::new(0);
        let start = move || {
            let number = started.fetch_add(1, Ordering::Relaxed);
            let mut command = Command::new("sh");
            command.args(["-c", scripts[number.min(scripts.len() - 1)]]);
            command
        };
        let means = FitMeans {
            start: Box::new(start),
            threads: 1,
            turn: Duration::from_millis(100),
            memory_bytes: 1 << 30,
            memory: Arc::new(MemoryShare::new(1 << 30)),
        };
        let (trigger, shutdown) = shutdown::channel();
        // Nobody stops this line: the runtime ends with its test.
        std::mem::forget(trigger);
        let store = Arc::new(store.expect("opens"));
        let queue = Arc::new(EstimatorQueue::new(store, means, shutdown));
        let worker = queue.clone();
        tokio::spawn(async move { worker.work().await });
        (folder, queue)
    }

    async fn row(queue: &EstimatorQueue, id: &str) -> EstimatorRow {
        let mut connection = queue.store.read().await.expect("reads");
        let row = estimator_rows::find(&mut connection, id).await;
        row.expect("reads").expect("is there")
    }

    async fn ended(queue: &EstimatorQueue, id: &str) -> EstimatorRow {
        let begun = Instant::now();
        loop {
            let row = row(queue, id).await;
            if row.finished.is_some() {
                return row;
            }
            assert!(begun.elapsed() < PATIENCE, "{row:?}");
            tokio::time::sleep(Duration::from_millis(5)).await;
        }
    }

    async fn submit(queue: &EstimatorQueue, name: &str) -> String {
        let id = queue.submit(&submission(name), None).await;
        id.expect("is taken in")
    }

    #[tokio::test(flavor = "multi_thread")]
    async fn a_fit_that_crashes_its_process_is_given_up_after_three_times() {
        let crashes = "read order; echo memory allocation failed >&2; kill -ABRT $$";
        let (_folder, queue) = line(vec![crashes]).await;
        let id = submit(&queue, "large").await;
        let failed = ended(&queue, &id).await;
        let error =
            "its process crashed 3 times, the last time by SIGABRT: memory allocation failed";
        assert_eq!(failed.error.as_deref(), Some(error));
    }

    #[tokio::test(flavor = "multi_thread")]
    async fn a_short_fit_has_its_turn_beside_a_long_one_and_both_end_when_they_are_cancelled() {
        let long =
            r#"read order; echo 'told {"stage":"learning","done":1,"of":2}'; exec sleep 3600"#;
        let short = r#"read order; echo 'answer {"Err":{"other":"no model"}}'"#;
        let (_folder, queue) = line(vec![long, short]).await;
        let first = submit(&queue, "long").await;
        let second = submit(&queue, "short").await;
        let failed = ended(&queue, &second).await;
        assert_eq!(failed.error.as_deref(), Some("no model"));
        let progress = queue.progress(&first).expect("is being learnt");
        assert_eq!((progress.done, progress.of), (1, 2));
        let begun = Instant::now();
        queue.cancel(&first).await.expect("cancels");
        let third = submit(&queue, "next").await;
        ended(&queue, &third).await;
        assert!(begun.elapsed() < Duration::from_secs(2));
        assert_eq!(row(&queue, &first).await.error, None);
        assert_eq!(queue.progress(&first), None);
    }
}
