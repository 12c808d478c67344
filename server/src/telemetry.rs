//! The log: on standard error, filtered by the environment variable STRAINSITE_LOG.

use std::io::IsTerminal;

use tracing_subscriber::EnvFilter;

/// Starts the log, at this level unless the environment says otherwise.
pub fn start(level: &str) {
    let filter =
        EnvFilter::try_from_env("STRAINSITE_LOG").unwrap_or_else(|_| EnvFilter::new(level));
    let log = tracing_subscriber::fmt()
        .with_env_filter(filter)
        .with_writer(std::io::stderr)
        .with_ansi(std::io::stderr().is_terminal());
    // A second start in one process, as in tests, keeps the first.
    let _ = log.try_init();
}
