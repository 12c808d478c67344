//! Ctrl-C, and where there are such SIGTERM, and SIGHUP of a terminal that is closed.

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
    /// Hang-up signal; None where whoever started the program had it ignored, as `nohup` does.
    #[cfg(unix)]
    hangup: Option<tokio::signal::unix::Signal>,
}

impl Signals {
    /// Takes the signals over. Call it within a runtime.
    ///
    /// # Errors
    /// When the system refuses.
    #[cfg(unix)]
    pub(crate) fn listen() -> Result<Self, Failure> {
        use tokio::signal::unix::{SignalKind, signal};
        let hangup = || signal(SignalKind::hangup()).map_err(Failure::other);
        Ok(Self {
            interrupt: signal(SignalKind::interrupt()).map_err(Failure::other)?,
            terminate: signal(SignalKind::terminate()).map_err(Failure::other)?,
            hangup: (!ignores_hangup()).then(hangup).transpose()?,
        })
    }

    /// Takes the signals over. Call it within a runtime.
    ///
    /// # Errors
    /// Never on this system.
    #[cfg(not(unix))]
    pub(crate) fn listen() -> Result<Self, Failure> {
        Ok(Self {})
    }

    /// Waits for the next signal.
    pub async fn next(&mut self) {
        #[cfg(unix)]
        tokio::select! {
            _ = self.interrupt.recv() => {}
            _ = self.terminate.recv() => {}
            () = heard(&mut self.hangup) => {}
        }
        #[cfg(not(unix))]
        let _ = tokio::signal::ctrl_c().await;
    }
}

/// Waits for a signal, for ever where it isn't listened to.
#[cfg(unix)]
async fn heard(signal: &mut Option<tokio::signal::unix::Signal>) {
    match signal {
        Some(signal) => {
            signal.recv().await;
        }
        None => std::future::pending().await,
    }
}

/// Whether SIGHUP, the first signal, was set to be ignored before the program began; where the system doesn't tell, it wasn't.
#[cfg(unix)]
fn ignores_hangup() -> bool {
    const HANGUP: u64 = 1;
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    ignored.is_some_and(|mask| mask & HANGUP != 0)
}

/// A flag that Ctrl-C and its like set; a second one ends the program at once, which loses nothing that is solved.
///
/// # Errors
/// When the system refuses.
pub(crate) fn stop_flag(runtime: &Runtime) -> Result<Arc<AtomicBool>, Failure> {
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
