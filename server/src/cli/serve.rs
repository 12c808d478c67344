//! `strainsite serve`: the service and the dashboard.

use std::net::SocketAddr;
use std::time::Duration;

use clap::Args;

use super::Failure;
use super::output::print;
use super::signals::Signals;
use crate::config::{Config, loopback_address, seconds};
use crate::service::{Service, ServiceParts};
use crate::solver::SolverChoice;

/// Start the service and the dashboard
#[derive(Debug, Args)]
pub struct Serve {
    /// Address to listen on; port 0 takes a free one
    #[arg(long, env = "STRAINSITE_ADDR", value_name = "IP:PORT", default_value = "127.0.0.1:8080",
          value_parser = loopback_address)]
    addr: SocketAddr,
    /// How long a study runs before another one that waits has its turn, seconds
    #[arg(long, env = "STRAINSITE_TURN_S", value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    turn_s: Duration,
    #[command(flatten)]
    config: Config,
    #[command(flatten)]
    solver: SolverChoice,
}

impl Serve {
    /// Serves until Ctrl-C or SIGTERM.
    pub fn execute(&self) -> Result<(), Failure> {
        let runtime = tokio::runtime::Runtime::new().map_err(Failure::other)?;
        runtime.block_on(self.serve())
    }

    async fn serve(&self) -> Result<(), Failure> {
        let parts = ServiceParts {
            address: self.addr,
            database: self.config.db.clone(),
            solver: self.solver.solver().map_err(Failure::other)?,
            threads: self.config.threads(),
            turn: self.turn_s,
        };
        let mut signals = Signals::listen()?;
        let service = Service::start(parts).await.map_err(Failure::other)?;
        print(&format!("listening on http://{}\n", service.address()))?;
        signals.next().await;
        tracing::info!("stopping; once more stops at once");
        tokio::select! {
            () = service.stop() => Ok(()),
            () = signals.next() => Err(Failure::Other("stopped at once; the next start resumes".to_owned())),
        }
    }
}
