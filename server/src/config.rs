//! Settings: from flags first, then from the environment, then defaults.

use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;

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
}

impl Config {
    /// Solves that run at once.
    pub fn threads(&self) -> usize {
        let cores = || std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
        self.threads
            .map_or_else(cores, NonZeroUsize::get)
            .min(MAX_THREADS)
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

/// Reads `IP:PORT` or `localhost:PORT`, and refuses what other machines could reach.
///
/// # Errors
/// A sentence that says what would be right.
pub fn loopback_address(text: &str) -> Result<SocketAddr, String> {
    let address = match text.strip_prefix("localhost:") {
        Some(port) => port
            .parse()
            .ok()
            .map(|port| SocketAddr::new(IpAddr::V4(Ipv4Addr::LOCALHOST), port)),
        None => text.parse().ok(),
    };
    let address = address.ok_or("an address is IP:PORT, as in 127.0.0.1:8080")?;
    if !address.ip().is_loopback() {
        return Err(format!(
            "{} can be reached from other machines, and this version has no access control: it serves 127.0.0.1 or \
             [::1] only; from elsewhere, forward the port, as in ssh -L 8080:localhost:8080",
            address.ip()
        ));
    }
    Ok(address)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_loopback_addresses_are_served() {
        for text in ["127.0.0.1:8080", "[::1]:0", "localhost:80", "127.1.2.3:1"] {
            assert!(loopback_address(text).is_ok(), "{text}");
        }
        for text in [
            "0.0.0.0:8080",
            "[::]:8080",
            "192.168.1.2:80",
            "8080",
            "localhost",
            "localhost:x",
            "",
        ] {
            assert!(loopback_address(text).is_err(), "{text}");
        }
    }
}
