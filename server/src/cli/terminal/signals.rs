//! Ctrl-C, and SIGTERM where there is one.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use tokio::runtime::Runtime;

use crate::cli::terminal::exit::Failure;

/// Signals that ask the program to end, taken over from the system as soon as this exists.
pub struct Signals {
    #[cfg(unix)]
    interrupt: tokio::signal::unix::Signal,
    #[cfg(unix)]
    terminate: tokio::signal::unix::Signal,
}

impl Signals {
    /// Takes the signals over. Call it within a runtime.
    ///
    /// # Errors
    /// When the system refuses.
    #[cfg(unix)]
    pub fn listen() -> Result<Self, Failure> {
        use tokio::signal::unix::{SignalKind, signal};
        Ok(Self {
            interrupt: signal(SignalKind::interrupt()).map_err(Failure::other)?,
            terminate: signal(SignalKind::terminate()).map_err(Failure::other)?,
        })
    }

    /// Takes the signals over. Call it within a runtime.
    ///
    /// # Errors
    /// Never on this system.
    #[cfg(not(unix))]
    pub fn listen() -> Result<Self, Failure> {
        Ok(Self {})
    }

    /// Waits for the next signal.
    pub async fn next(&mut self) {
        #[cfg(unix)]
        tokio::select! {
            _ = self.interrupt.recv() => {}
            _ = self.terminate.recv() => {}
        }
        #[cfg(not(unix))]
        let _ = tokio::signal::ctrl_c().await;
    }
}

/// A flag that Ctrl-C sets; a second one ends the program at once, which loses nothing that is solved.
///
/// # Errors
/// When the system refuses.
pub fn stop_flag(runtime: &Runtime) -> Result<Arc<AtomicBool>, Failure> {
    let stop = Arc::new(AtomicBool::new(false));
    let mut signals = runtime.block_on(async { Signals::listen() })?;
    let flag = stop.clone();
    runtime.spawn(async move {
        signals.next().await;
        flag.store(true, Ordering::Relaxed);
        signals.next().await;
        std::process::exit(1);
    });
    Ok(stop)
}
