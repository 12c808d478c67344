//! Settings: from flags first, then from the environment, then defaults.

use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::num::{NonZeroU32, NonZeroUsize};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use clap::Args;
use fem_client::solver::Solver;
use placement::points::machine_memory::machine_memory_bytes;
use service::engine::Engine;
use service::metrics::Metrics;
use service::work::memory_share::MemoryShare;
use store::{Store, StoreError};

/// Shares of the machine that solves may take.
#[derive(Debug, Clone, Args)]
pub struct Work {
    /// Solves that run at once; all cores when absent
    #[arg(long, env = "STRAINSITE_THREADS", value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Memory that a study may take, MB; the machine's when absent
    #[arg(long, env = "STRAINSITE_MAX_MEMORY_MB", value_name = "MB")]
    max_memory_mb: Option<NonZeroU32>,
}

impl Work {
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

    /// An engine on a database that takes these shares.
    pub(crate) fn engine(&self, solver: Arc<dyn Solver>, store: Store) -> Engine {
        Engine {
            store: Arc::new(store),
            solver,
            threads: self.threads(),
            metrics: Metrics::new(),
            live: Arc::default(),
            memory: Arc::new(MemoryShare::new(self.memory_bytes())),
        }
    }
}

/// Configuration: where studies are kept, and how many solves run at once.
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
    #[command(flatten)]
    pub work: Work,
    /// Size that the database may grow to, MB; the disk's when absent
    #[arg(long, env = "STRAINSITE_MAX_DATABASE_MB", value_name = "MB")]
    pub max_database_mb: Option<NonZeroU32>,
}

impl Config {
    /// The database, which may grow as far as is said.
    ///
    /// # Errors
    /// When another process has it, or it is unusable.
    pub async fn open(&self) -> Result<Store, StoreError> {
        Store::open_within(&self.db, self.database_bytes()).await
    }

    /// Solves that run at once.
    pub fn threads(&self) -> usize {
        self.work.threads()
    }

    /// Memory that a study may take, bytes.
    pub fn memory_bytes(&self) -> u64 {
        self.work.memory_bytes()
    }

    /// Size that the database may grow to, bytes.
    pub fn database_bytes(&self) -> Option<u64> {
        self.max_database_mb
            .map(|mb| u64::from(mb.get()) * 1_000_000)
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

/// Reads a time to wait, s.
///
/// # Errors
/// A sentence that says what would be right.
pub(crate) fn patience(text: &str) -> Result<Duration, String> {
    let seconds: Option<f64> = text.parse().ok();
    let seconds = seconds.filter(|seconds| (0.0..=1e6).contains(seconds));
    seconds
        .map(Duration::from_secs_f64)
        .ok_or_else(|| "a time to wait is a number of seconds from 0 to 1e6".to_owned())
}

/// Reads a time, minutes.
///
/// # Errors
/// A sentence that says what would be right.
pub(crate) fn minutes(text: &str) -> Result<f64, String> {
    let minutes: Option<f64> = text.parse().ok();
    let minutes = minutes.filter(|minutes| (0.001..=1e5).contains(minutes));
    minutes.ok_or_else(|| "a time is a number of minutes from 0.001 to 1e5".to_owned())
}

/// Reads an age: a number of minutes, hours, days or weeks.
///
/// # Errors
/// A sentence that says what would be right.
pub fn age(text: &str) -> Result<Duration, String> {
    const UNITS: [(char, u64); 4] = [('m', 60), ('h', 3600), ('d', 86_400), ('w', 604_800)];
    let age = UNITS.iter().find_map(|(unit, seconds)| {
        let count: u32 = text.strip_suffix(*unit)?.parse().ok()?;
        let seconds = u64::from(count) * seconds;
        (seconds <= LONGEST_AGE_S).then(|| Duration::from_secs(seconds))
    });
    age.ok_or_else(|| {
        "an age is a whole number with its unit, as in 30m, 12h, 90d or 4w, and at most a century"
            .to_owned()
    })
}

/// A century, s.
const LONGEST_AGE_S: u64 = 100 * 365 * 86_400;

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
    fn ages_have_a_unit() {
        for (text, seconds) in [
            ("0m", 0),
            ("12h", 43_200),
            ("90d", 7_776_000),
            ("4w", 2_419_200),
        ] {
            assert_eq!(age(text), Ok(Duration::from_secs(seconds)), "{text}");
        }
        for text in ["90", "d", "-1d", "1.5d", "90 d", "1y", "4294967295w", ""] {
            assert!(age(text).is_err(), "{text}");
        }
    }

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
