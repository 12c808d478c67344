//! The line of estimators that the service learns: one at a time, beside the studies' queue.
//!
//! A fit works on a plain thread and touches no database: what it finds is stored here, guarded by the state, so that what was cancelled or removed meanwhile stays so.
//! How far it is stays in memory.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use document::fault::Fault;
use store::content::encode;
use store::file::upkeep;
use store::queue::estimator_rows::{self, EstimatorRow, Part};
use store::{Store, StoreError};
use tokio::sync::{Notify, oneshot, watch};

use crate::forces::fitting::{Fit, FitFailure, Work, fit};
use crate::forces::model_file::model_text;
use crate::forces::recorded_texts::NamedText;
use crate::forces::submission_reader::Submission;
use crate::shutdown::Shutdown;
use crate::wire::estimator_wire::LeftOutRows;
use crate::wire::estimator_wire::{FitProgress, LeftOutForces, StoredEstimator};
use estimation::recipe::Recipe;

/// Time to wait before the database is tried again.
const RETRY: Duration = Duration::from_secs(1);
/// Estimators that may wait: with the largest recordings 6 GB of the database.
pub(crate) const MOST_WAITING: u32 = 100;
/// Rows of a force that weren't learnt from, as they are kept to be plotted.
pub(crate) const MOST_LEFT_OUT: usize = 20_000;

/// Takes estimators in, learns them, cancels them.
pub struct EstimatorQueue {
    store: Arc<Store>,
    threads: usize,
    news: Notify,
    current: watch::Sender<Option<Current>>,
    shutdown: Shutdown,
}

/// The estimator that is being learnt.
#[derive(Clone)]
struct Current {
    estimator: String,
    work: Arc<FitWork>,
}

/// State that a fit and those who look at it share.
#[derive(Default)]
struct FitWork {
    stop: AtomicBool,
    done: AtomicUsize,
    of: AtomicUsize,
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

/// Ending of the work on an estimator.
enum Ending {
    /// Parts that were learnt.
    Learnt(Vec<(Part, String)>),
    /// Failure, a sentence.
    Failed(String),
    /// Stop on request.
    Stopped,
}

impl EstimatorQueue {
    /// A line whose fits have so many threads, until `shutdown`.
    pub fn new(store: Arc<Store>, threads: usize, shutdown: Shutdown) -> Self {
        Self {
            store,
            threads,
            news: Notify::new(),
            current: watch::Sender::new(None),
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
        let id = estimator_rows::insert(&mut transaction, name, document, texts).await?;
        if let Some(key) = key {
            estimator_rows::insert_key(&mut transaction, key, &id, &sha256).await?;
        }
        self.store.commit(transaction, 0).await?;
        self.news.notify_one();
        Ok(id)
    }

    /// Returns how far the fit of an estimator is; `None` of one that isn't being learnt.
    pub fn progress(&self, id: &str) -> Option<FitProgress> {
        let current = self.current.borrow();
        let current = current.as_ref().filter(|current| current.estimator == id)?;
        Some(FitProgress {
            done: current.work.done.load(Ordering::Relaxed),
            of: current.work.of.load(Ordering::Relaxed),
        })
    }

    /// Cancels an estimator; one that has ended stays as it is. A fit ends with the models that it is judging.
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
        let current = self.current.borrow();
        if let Some(current) = current.as_ref().filter(|current| current.estimator == id) {
            current.work.stop.store(true, Ordering::Relaxed);
        }
    }

    /// Learns estimators until the service stops. One that is being learnt then goes back into the line, and its thread isn't waited for.
    pub async fn work(&self) {
        let mut shutdown = self.shutdown.clone();
        while !shutdown.requested() {
            match self.learn_next().await {
                Ok(true) => {}
                Ok(false) => {
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
    }

    /// Learns the estimator that has waited longest; false when none waits.
    async fn learn_next(&self) -> Result<bool, StoreError> {
        let mut transaction = self.store.begin().await?;
        let claimed = estimator_rows::claim(&mut transaction).await?;
        let Some(row) = claimed else {
            return Ok(false);
        };
        let work = Arc::new(FitWork::default());
        // Before others can see it running, so that no cancel finds nothing to stop.
        self.current.send_replace(Some(Current {
            estimator: row.id.clone(),
            work: work.clone(),
        }));
        let ended = match self.store.commit(transaction, 0).await {
            Ok(()) => self.learn(&row, work).await,
            Err(error) => Err(error),
        };
        self.current.send_replace(None);
        ended.map(|()| true)
    }

    async fn learn(&self, row: &EstimatorRow, work: Arc<FitWork>) -> Result<(), StoreError> {
        tracing::info!(estimator = row.id, name = ?row.name, "estimator started");
        let ending = match self.asked(row).await {
            Ok((stored, files)) => self.learnt(stored, files, work).await,
            // What is damaged stays so: others may go on.
            Err(error @ StoreError::Damaged { .. }) => Ending::Failed(error.to_string()),
            Err(error) => {
                self.settle(row, &Ending::Stopped).await;
                return Err(error);
            }
        };
        self.settle(row, &ending).await;
        Ok(())
    }

    async fn asked(
        &self,
        row: &EstimatorRow,
    ) -> Result<(StoredEstimator, Vec<NamedText>), StoreError> {
        let stored = StoredEstimator::of(row)?;
        let mut connection = self.store.read().await?;
        let rows = estimator_rows::recordings(&mut connection, &row.id).await?;
        let named = rows.into_iter().map(|row| NamedText {
            name: row.file,
            text: row.text,
        });
        Ok((stored, named.collect()))
    }

    /// Learns on a thread of its own, so that the runtime stays free, until its end or a shutdown.
    async fn learnt(
        &self,
        stored: StoredEstimator,
        files: Vec<NamedText>,
        work: Arc<FitWork>,
    ) -> Ending {
        let (tell, told) = oneshot::channel();
        let (threads, shared) = (self.threads, work.clone());
        let thread = std::thread::Builder::new()
            .name("fit".to_owned())
            .spawn(move || {
                // The receiver is gone when the service ends first.
                let _ = tell.send(caught(|| ending(&stored, &files, threads, &shared)));
            });
        if let Err(error) = thread {
            return Ending::Failed(format!("no thread could be started for the fit: {error}"));
        }
        let mut shutdown = self.shutdown.clone();
        tokio::select! {
            told = told => told.unwrap_or_else(|_| broken()),
            () = shutdown.wait() => {
                work.stop.store(true, Ordering::Relaxed);
                Ending::Stopped
            }
        }
    }

    /// Records the end, however long the database takes to be writable again; at a shutdown the estimator may be left as running, and goes back into the line at
    /// the next start.
    async fn settle(&self, row: &EstimatorRow, ending: &Ending) {
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
            // Only one runs, so that no other is meant.
            Ending::Stopped => {
                let released = estimator_rows::release_all(&mut transaction).await?;
                (released > 0, "queued")
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

/// Returns the ending that a panic leaves: its place is in the log.
fn broken() -> Ending {
    Ending::Failed("the fit broke; the service's log says where".to_owned())
}

fn caught(work: impl FnOnce() -> Ending) -> Ending {
    // What it works on is dropped with it: nobody sees it half done.
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_: Box<dyn Any + Send>| broken())
}

fn ending(
    stored: &StoredEstimator,
    files: &[NamedText],
    threads: usize,
    shared: &FitWork,
) -> Ending {
    let told = |done: usize, of: usize| {
        shared.of.store(of, Ordering::Relaxed);
        // Threads tell in any order.
        shared.done.fetch_max(done, Ordering::Relaxed);
    };
    let work = Work {
        threads,
        stop: &shared.stop,
        told: &told,
    };
    let found = Recipe::from_value(&stored.recipe)
        .map_err(FitFailure::Input)
        .and_then(|recipe| fit(&recipe, files, work));
    match found {
        Ok(found) => written(found).map_or_else(Ending::Failed, Ending::Learnt),
        Err(FitFailure::Input(faults)) => Ending::Failed(sentence(&faults)),
        Err(FitFailure::Stopped) => Ending::Stopped,
        Err(FitFailure::Other(detail)) => Ending::Failed(detail),
    }
}

fn sentence(faults: &[Fault]) -> String {
    let faults: Vec<String> = faults.iter().map(Fault::to_string).collect();
    faults.join("; ")
}

/// The parts as they are stored.
fn written(found: Fit) -> Result<Vec<(Part, String)>, String> {
    let told = |error: StoreError| error.to_string();
    let left_out = LeftOutForces {
        forces: found.left_out.iter().map(thinned).collect(),
    };
    Ok(vec![
        (
            Part::Report,
            encode("a report", &found.report).map_err(told)?,
        ),
        (Part::Model, model_text(&found.estimator)?),
        (
            Part::LeftOut,
            encode("rows that were left out", &left_out).map_err(told)?,
        ),
    ])
}

/// An even subset of the rows, where there are more than a plot can show.
fn thinned(rows: &LeftOutRows) -> LeftOutRows {
    let count = rows.time_s.len();
    let kept = count.min(MOST_LEFT_OUT);
    let places: Vec<usize> = (0..kept).map(|place| place * count / kept).collect();
    let of = |all: &[f64]| -> Vec<f64> { places.iter().map(|place| all[*place]).collect() };
    LeftOutRows {
        force: rows.force.clone(),
        run: places.iter().map(|place| rows.run[*place]).collect(),
        time_s: of(&rows.time_s),
        truth_n: of(&rows.truth_n),
        estimate_n: of(&rows.estimate_n),
        low_n: of(&rows.low_n),
        high_n: of(&rows.high_n),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fit_that_panics_fails() {
        let Ending::Failed(error) = caught(|| panic!("not to be told")) else {
            panic!("must fail");
        };
        assert_eq!(error, "the fit broke; the service's log says where");
    }

    #[test]
    fn rows_to_plot_are_an_even_subset() {
        let rows = |count: usize| LeftOutRows {
            force: "fz_n".to_owned(),
            run: vec![0; count],
            time_s: (0..count).map(|row| row as f64).collect(),
            truth_n: vec![1.0; count],
            estimate_n: vec![2.0; count],
            low_n: vec![0.0; count],
            high_n: vec![3.0; count],
        };
        for count in [0, 7, MOST_LEFT_OUT] {
            assert_eq!(thinned(&rows(count)), rows(count));
        }
        let few = thinned(&rows(4 * MOST_LEFT_OUT));
        assert_eq!(few.run.len(), MOST_LEFT_OUT);
        assert!(few.time_s.windows(2).all(|pair| pair[1] - pair[0] == 4.0));
    }

    #[test]
    fn faults_become_one_sentence() {
        let fault = |pointer: &str| Fault {
            pointer: pointer.to_owned(),
            detail: "is wrong".to_owned(),
        };
        assert_eq!(
            sentence(&[fault("/a"), fault("")]),
            "/a: is wrong; is wrong"
        );
    }
}
