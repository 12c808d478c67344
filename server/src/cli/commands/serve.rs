//! `strainsite serve`: the service and the dashboard.

use std::env;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use document::fault::Fault;

use crate::cli::engine_options::EngineOptions;
use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::tell;
use crate::cli::terminal::signals::Signals;
use crate::config::{Config, address, seconds};
use crate::http::edge::guard::HostName;
use crate::http::mount::{Mount, Mounting};
use crate::running::{Limits, Outside, Service, ServiceParts};
use crate::telemetry::{self, LogFilter, LogFormat};
use crate::token::{Token, TokenError};
use service::at_once::scene_solver::SCENE_LIMIT;
use service::forces::fit_process;
use service::solving::solver_choice::{PREVIEW_LIMIT, preview_solver};
use service::work::analysis_process;
use service::work::own_process::own_program;
use tasks::away::Means;
use tasks::engines::engine_name::EngineName;

/// The environment variable that may hold the token: unlike an argument, it is in no list of processes.
const TOKEN_VARIABLE: &str = "STRAINSITE_TOKEN";

/// Start the service and the dashboard
#[derive(Debug, Args)]
pub(crate) struct Serve {
    /// Address to listen on; port 0 takes a free one. One that other machines can reach needs a token
    #[arg(long, env = "STRAINSITE_ADDR", value_name = "IP:PORT", default_value = "127.0.0.1:8080",
          value_parser = address)]
    addr: SocketAddr,
    /// Time that a study runs before another one that waits has its turn, seconds
    #[arg(long, env = "STRAINSITE_TURN_S", value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    turn_s: Duration,
    /// Ask every client for a token: the one in the environment variable STRAINSITE_TOKEN or in --token-file, or else one that is drawn
    /// and printed
    #[arg(long)]
    token: bool,
    /// File that holds the token, and nothing else; asks for it
    #[arg(long, env = "STRAINSITE_TOKEN_FILE", value_name = "FILE")]
    token_file: Option<PathBuf>,
    /// Another name under which the service is reached; may be given several times, needs a token
    #[arg(long = "host", env = "STRAINSITE_HOST", value_name = "NAME[:PORT]", value_delimiter = ',',
          value_parser = HostName::read)]
    hosts: Vec<HostName>,
    /// Path below which a proxy serves it, as in /strainsite; requests come with that path in front or without it
    #[arg(long, env = "STRAINSITE_BASE_PATH", value_name = "PATH", default_value = "/", value_parser = Mount::read)]
    base_path: Mount,
    /// Believe the header X-Forwarded-Prefix of requests instead: for a proxy that always sets it
    #[arg(long, env = "STRAINSITE_TRUST_FORWARDED_PREFIX")]
    trust_forwarded_prefix: bool,
    /// Studies that may wait in the queue; further ones are refused with 429
    #[arg(long, env = "STRAINSITE_MAX_WAITING", value_name = "N", default_value_t = Limits::default().waiting_studies)]
    max_waiting: u32,
    /// Event streams that may be open at once; further ones are refused with 429
    #[arg(long, env = "STRAINSITE_MAX_STREAMS", value_name = "N", default_value_t = Limits::default().event_streams)]
    max_streams: usize,
    /// Level of the log, or levels of parts of the program, as in info,server::http=debug
    #[arg(
        long,
        env = "STRAINSITE_LOG",
        value_name = "FILTER",
        default_value = "info"
    )]
    log: LogFilter,
    /// Format of the log: for people, or as one JSON object a line
    #[arg(
        long,
        env = "STRAINSITE_LOG_FORMAT",
        value_enum,
        value_name = "FORMAT",
        default_value = "text"
    )]
    log_format: LogFormat,
    /// File of settings, TOML: its keys are the names of these flags, with _ for -. Flags and environment go before it
    #[arg(
        long = "config",
        id = "config",
        env = "STRAINSITE_CONFIG",
        value_name = "FILE"
    )]
    file: Option<PathBuf>,
    /// Engine that clients may name, as in POST /v1/sweeps?engine=slurm; may be given several times. Its machines solve designs then
    #[arg(
        long = "engine",
        env = "STRAINSITE_ENGINE",
        value_enum,
        value_name = "NAME",
        value_delimiter = ','
    )]
    engines: Vec<EngineName>,
    #[command(flatten)]
    engine_options: EngineOptions,
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverOption,
}

/// Secret that clients have to know, and whether they know it yet.
struct Secret {
    token: Token,
    drawn: bool,
}

impl Serve {
    /// Starts the log as the settings say.
    pub(crate) fn start_log(&self) {
        telemetry::start_service(&self.log, self.log_format);
        if let Some(file) = &self.file {
            tracing::info!(?file, "settings were read");
        }
    }

    /// Serves until Ctrl-C or SIGTERM.
    pub fn execute(&self) -> Result<(), Failure> {
        let (parts, drawn) = self.parts().map_err(Failure::Input)?;
        let runtime = tokio::runtime::Runtime::new().map_err(Failure::other)?;
        let served = runtime.block_on(serve(parts, drawn));
        // What was stored is stored: nobody waits for the plan of a study that was stopped.
        runtime.shutdown_background();
        served
    }

    /// Returns what the service is made of, and a token that nobody knows yet; or every setting that can't be used with the others or on this machine.
    fn parts(&self) -> Result<(ServiceParts, Option<Token>), Vec<Fault>> {
        let mut faults = Vec::new();
        let mut note = |detail: String| {
            faults.push(Fault {
                pointer: String::new(),
                detail,
            });
        };
        let secret = self.secret().map_err(&mut note).ok().flatten();
        let outside = Outside {
            token: secret.as_ref().map(|secret| secret.token.clone()),
            hosts: self.hosts.clone(),
            mounting: Mounting {
                base: self.base_path.clone(),
                trusts_prefix: self.trust_forwarded_prefix,
            },
            limits: Limits {
                waiting_studies: self.max_waiting,
                event_streams: self.max_streams,
                memory_bytes: self.config.memory_bytes(),
                database_bytes: self.config.database_bytes(),
            },
        };
        if let Err(error) = outside.check(self.addr) {
            note(error.to_string());
        }
        let settings = self.engine_options.settings();
        for &name in &self.engines {
            if let Err(error) = settings.engine(name) {
                note(error.to_string());
            }
        }
        let means = Means {
            names: self.engines.clone(),
            settings,
            folder: self.engine_options.folder(&self.config.db),
            is_own: self.engine_options.is_own(),
            minutes: self.engine_options.minutes,
            kept: self.engine_options.keep,
        };
        let solver = self
            .solver
            .solver()
            .map_err(|error| note(error.to_string()));
        let Ok(solver) = solver else {
            return Err(faults);
        };
        if !faults.is_empty() {
            return Err(faults);
        }
        let parts = ServiceParts {
            learner: Box::new(|| own_program(fit_process::ARGUMENT)),
            analyst: Box::new(|| own_program(analysis_process::ARGUMENT)),
            address: self.addr,
            database: self.config.db.clone(),
            solver,
            previewer: preview_solver(),
            preview_limit: PREVIEW_LIMIT,
            scene_limit: SCENE_LIMIT,
            threads: self.config.threads(),
            turn: self.turn_s,
            means,
            outside,
        };
        let drawn = secret.filter(|secret| secret.drawn);
        Ok((parts, drawn.map(|secret| secret.token)))
    }

    /// The token that clients are asked for. One that is given is asked for, with `--token` or without.
    fn secret(&self) -> Result<Option<Secret>, String> {
        let (given, whence) = match (env::var_os(TOKEN_VARIABLE), &self.token_file) {
            (Some(_), Some(_)) => {
                return Err(format!(
                    "the token is either in {TOKEN_VARIABLE} or in --token-file, not in both"
                ));
            }
            (Some(text), None) => {
                let token = text.to_str().ok_or(TokenError::Unfit);
                (token.and_then(Token::chosen), TOKEN_VARIABLE)
            }
            (None, Some(path)) => (Token::in_file(path), "--token-file"),
            (None, None) if self.token => (Token::random(), "--token"),
            (None, None) => return Ok(None),
        };
        let token = given.map_err(|error| format!("{whence}: {error}"))?;
        let drawn = whence == "--token";
        Ok(Some(Secret { token, drawn }))
    }
}

async fn serve(parts: ServiceParts, drawn: Option<Token>) -> Result<(), Failure> {
    let mut signals = Signals::listen()?;
    let base = parts.outside.mounting.base.clone();
    let service = Service::start(parts).await.map_err(Failure::other)?;
    let say = |text: String| tell(&text, None);
    say(format!("listening on http://{}\n", service.address()))?;
    if let Some(token) = drawn {
        say(format!("token {}\n", token.reveal()))?;
    }
    if let Some(path) = service.login() {
        let here = reachable(service.address());
        let path = base.address(path);
        say(format!("in a browser, once: http://{here}{path}\n"))?;
    }
    signals.next().await;
    tracing::info!("stopping; once more stops at once");
    tokio::select! {
        stopped = service.stop() => stopped.map_err(Failure::other),
        () = signals.next() => Err(Failure::Other("stopped at once; the next start resumes".to_owned())),
    }
}

/// An address that a browser on this machine can open.
fn reachable(address: SocketAddr) -> SocketAddr {
    let ip = match address.ip() {
        ip if !ip.is_unspecified() => ip,
        IpAddr::V4(_) => Ipv4Addr::LOCALHOST.into(),
        IpAddr::V6(_) => Ipv6Addr::LOCALHOST.into(),
    };
    SocketAddr::new(ip, address.port())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_browser_on_this_machine_can_open_the_printed_address() {
        for (bound, printed) in [
            ("0.0.0.0:80", "127.0.0.1:80"),
            ("[::]:80", "[::1]:80"),
            ("10.0.0.7:80", "10.0.0.7:80"),
        ] {
            let bound = bound.parse().expect("an address");
            assert_eq!(reachable(bound).to_string(), printed);
        }
    }
}
