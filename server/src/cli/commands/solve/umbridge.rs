//! `strainsite umbridge`: a study as a model for other programs.

use std::io::Write;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use axum::middleware::from_fn_with_state;
use clap::Args;
use tokio::runtime::Runtime;

use crate::cli::solver_option::SolverOption;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::progress::clock;
use crate::cli::terminal::signals::Signals;
use crate::config::{Work, address};
use crate::http::edge::guard::{HostList, admit};
use crate::http::edge::listener;
use crate::umbridge::forward_model::{ForwardModel, NoAnswer};
use crate::umbridge::model_routes::routes;
use service::study_document::{named_files, read_changed};
use service::work::shutdown;

/// Serve a study as a model that other programs evaluate, by UM-Bridge's protocol
#[derive(Debug, Args)]
pub(crate) struct Umbridge {
    /// Study file, TOML or JSON, or the name of a shipped study
    study: PathBuf,
    /// Set a field of the study or its scene otherwise; may be given more than once
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Address to listen on; port 0 takes a free one. Whoever reaches it may ask
    #[arg(long, value_name = "IP:PORT", value_parser = address, default_value_t = SocketAddr::from((Ipv4Addr::LOCALHOST, 4242)))]
    addr: SocketAddr,
    #[command(flatten)]
    work: Work,
    #[command(flatten)]
    solver: SolverOption,
}

impl Umbridge {
    /// Returns the files that it reads.
    pub fn files(&self) -> Files {
        Files::default().reading(named_files(&self.study))
    }

    /// Serves until it is told to end.
    pub fn execute(&self) -> Result<(), Failure> {
        let study = read_changed(&self.study, &self.set)
            .map_err(Failure::Input)?
            .study;
        let solver = self.solver.solver().map_err(Failure::other)?;
        let runtime = Runtime::new().map_err(Failure::other)?;
        let (sender, stopping) = shutdown::channel();
        let stop = Arc::new(AtomicBool::new(false));
        let mut signals = runtime.block_on(async { Signals::listen() })?;
        let flag = stop.clone();
        runtime.spawn(async move {
            signals.next().await;
            flag.store(true, Ordering::Relaxed);
            sender.send_replace(true);
        });
        let waiting = clock("solving the cut point");
        let model = ForwardModel::begin(study, solver, stop);
        waiting.finish_and_clear();
        let model = Arc::new(model.map_err(|none| match none {
            NoAnswer::Refused(faults) => Failure::input(faults),
            NoAnswer::NoEquilibrium(reason) | NoAnswer::Broken(reason) => {
                Failure::Other(format!("the cut point has no answer: {reason}"))
            }
        })?);
        runtime.block_on(async {
            let bound =
                listener::bind(self.addr).and_then(|bound| Ok((bound.local_addr()?, bound)));
            let (address, bound) = bound.map_err(|error| {
                Failure::Other(format!("{} can't be listened on: {error}", self.addr))
            })?;
            let app = routes(model.clone(), self.work.threads());
            let app = app.layer(from_fn_with_state(HostList::of(address, &[]), admit));
            let mut said = std::io::stdout();
            // Whoever started it may not read what it says.
            let _ = writeln!(said, "listening on http://{address}");
            let _ = writeln!(
                said,
                "model forward: {} to strains x and y at {} locations and the reaction",
                model.names(),
                model.sizes()[0]
            );
            listener::serve(bound, app, stopping).await;
            Ok(())
        })
    }
}
