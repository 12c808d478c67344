//! The wish to stop, told to every part of the service at once.

use tokio::sync::watch;

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
