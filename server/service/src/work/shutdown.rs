//! The wish to stop, told to every part of the service at once.

use std::pin::pin;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use tokio::sync::watch;
use tokio::time::timeout;

/// Interval at which work that is waited for looks whether it is to stop.
const LOOK: Duration = Duration::from_millis(50);

/// Hears when the service is to stop.
#[derive(Debug, Clone)]
pub struct Shutdown(watch::Receiver<bool>);

/// A trigger, and an ear that can be cloned for every part.
pub fn channel() -> (watch::Sender<bool>, Shutdown) {
    let (trigger, ear) = watch::channel(false);
    (trigger, Shutdown(ear))
}

impl Shutdown {
    /// Whether the service is to stop.
    pub(crate) fn requested(&self) -> bool {
        *self.0.borrow()
    }

    /// Waits until the service is to stop.
    pub async fn wait(&mut self) {
        // A trigger that is gone means that the service is.
        let _ = self.0.wait_for(|stop| *stop).await;
    }
}

/// Awaits what may take seconds, unless the wish to stop comes before: then nobody waits for it any more.
pub(crate) async fn unless_stopped<T>(
    stop: &AtomicBool,
    work: impl Future<Output = T>,
) -> Option<T> {
    let mut work = pin!(work);
    while !stop.load(Ordering::Relaxed) {
        if let Ok(done) = timeout(LOOK, work.as_mut()).await {
            return Some(done);
        }
    }
    None
}

/// Wait for work, whose flag is raised when nobody waits any more.
#[derive(Debug, Default)]
pub(crate) struct Waiting(Arc<AtomicBool>);

impl Waiting {
    /// The flag of the work.
    pub fn flag(&self) -> Arc<AtomicBool> {
        self.0.clone()
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}
