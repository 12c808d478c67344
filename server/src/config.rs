//! Settings: from flags first, then from the environment, then defaults.

use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::num::{NonZeroU32, NonZeroUsize};
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use placement::run::usage::machine_memory_bytes;

/// Where studies are kept, and how many solves run at once.
#[derive(Debug, Clone, Args)]
pub struct Config {
    /// Database file; created when it isn't there
    #[arg(
        long,
        env = "STRAINSITE_DB",
        value_name = "FILE",
        default_value = "strainsite.db"
    )]
    pub db: PathBuf,
    /// Solves that run at once; all cores when absent
    #[arg(long, env = "STRAINSITE_THREADS", value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// Memory that a study may take, MB; the machine's when absent
    #[arg(long, env = "STRAINSITE_MAX_MEMORY_MB", value_name = "MB")]
    pub max_memory_mb: Option<NonZeroU32>,
}

impl Config {
    /// Solves that run at once.
    pub fn threads(&self) -> usize {
        let cores = || std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
        self.threads
            .map_or_else(cores, NonZeroUsize::get)
            .min(MAX_THREADS)
    }

    /// Memory that a study may take, bytes.
    pub fn memory_bytes(&self) -> u64 {
        self.max_memory_mb
            .map_or_else(machine_memory_bytes, |mb| u64::from(mb.get()) * 1_000_000)
    }
}

const MAX_THREADS: usize = 256;

/// Reads a time, s.
///
/// # Errors
/// A sentence that says what would be right.
pub fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: Option<f64> = text.parse().ok();
    let seconds = seconds.filter(|seconds| (1.0..=1e6).contains(seconds));
    seconds
        .map(Duration::from_secs_f64)
        .ok_or_else(|| "a time is a number of seconds from 1 to 1e6".to_owned())
}

/// Reads `IP:PORT` or `localhost:PORT`.
///
/// # Errors
/// A sentence that says what would be right.
pub fn address(text: &str) -> Result<SocketAddr, String> {
    let address = match text.strip_prefix("localhost:") {
        Some(port) => port
            .parse()
            .ok()
            .map(|port| SocketAddr::new(IpAddr::V4(Ipv4Addr::LOCALHOST), port)),
        None => text.parse().ok(),
    };
    address.ok_or_else(|| "an address is IP:PORT, as in 127.0.0.1:8080".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_an_ip_and_a_port() {
        for text in ["127.0.0.1:8080", "[::1]:0", "localhost:80", "0.0.0.0:1"] {
            assert!(address(text).is_ok(), "{text}");
        }
        for text in ["8080", "localhost", "localhost:x", "tires.example:80", ""] {
            assert!(address(text).is_err(), "{text}");
        }
    }
}
