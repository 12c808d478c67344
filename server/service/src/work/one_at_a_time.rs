//! Work that somebody waits for: a piece at a time, each on a thread of its own and no longer than its limit.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use tokio::sync::{OwnedMutexGuard, oneshot};

use crate::work::shutdown::{Shutdown, Waiting};

/// Line of those who wait for work of one sort.
pub(crate) struct OneAtATime {
    /// Name of the work in the log.
    name: &'static str,
    limit: Duration,
    shutdown: Shutdown,
    turn: Arc<tokio::sync::Mutex<()>>,
}

/// Reason why work that somebody waited for has no outcome.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unfinished {
    /// Time that it may take, its wait for others included: it took longer.
    OverTime(Duration),
    /// The service ends.
    Stopping,
    /// A panic, or no thread.
    Broken,
}

impl OneAtATime {
    /// A line of work that takes no longer than `limit`, until `shutdown`.
    pub fn new(name: &'static str, limit: Duration, shutdown: Shutdown) -> Self {
        Self {
            name,
            limit,
            shutdown,
            turn: Arc::default(),
        }
    }

    /// Works once those before have ended. The work's flag is raised when the caller goes away.
    ///
    /// # Errors
    /// [`Unfinished`]; the next one's turn comes when the work has heeded its flag.
    pub async fn done<T: Send + 'static>(
        &self,
        work: impl FnOnce(&AtomicBool) -> T + Send + 'static,
    ) -> Result<T, Unfinished> {
        let waiting = Waiting::default();
        let stop = waiting.flag();
        let mut shutdown = self.shutdown.clone();
        tokio::select! {
            outcome = self.outcome(stop, work) => outcome,
            () = tokio::time::sleep(self.limit) => Err(Unfinished::OverTime(self.limit)),
            () = shutdown.wait() => Err(Unfinished::Stopping),
        }
    }

    async fn outcome<T: Send + 'static>(
        &self,
        stop: Arc<AtomicBool>,
        work: impl FnOnce(&AtomicBool) -> T + Send + 'static,
    ) -> Result<T, Unfinished> {
        let turn = self.turn.clone().lock_owned().await;
        let (tell, told) = oneshot::channel();
        let work = move || {
            let turn: OwnedMutexGuard<()> = turn;
            let outcome = work(&stop);
            drop(turn);
            // Nobody listens to work that was stopped.
            let _ = tell.send(outcome);
        };
        let thread = std::thread::Builder::new().name(self.name.to_owned());
        if let Err(error) = thread.spawn(work) {
            tracing::error!(%error, "no thread could be started for a {}", self.name);
        }
        told.await.map_err(|_| Unfinished::Broken)
    }
}
