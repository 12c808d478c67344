//! The running service: database, queue and HTTP together.

use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use fem_client::solver::Solver;
use tokio::net::TcpListener;
use tokio::sync::watch;
use tokio::task::JoinHandle;

use crate::engine::Engine;
use crate::http::guard::HostList;
use crate::http::{AppState, app, listener};
use crate::queue::{self, Queue};
use crate::shutdown;
use crate::store::{Store, StoreError};

/// A solver that does not heed its stop flag is not waited for longer.
const PATIENCE: Duration = Duration::from_secs(60);

/// What a service is made of.
pub struct ServiceParts {
    /// Where it listens; port 0 takes a free one.
    pub address: SocketAddr,
    /// The database file.
    pub database: PathBuf,
    /// Who solves.
    pub solver: Arc<dyn Solver>,
    /// Solves that run at once.
    pub threads: usize,
    /// How long a study runs before another one that waits has its turn.
    pub turn: Duration,
}

/// A service that runs until it is stopped.
pub struct Service {
    address: SocketAddr,
    store: Arc<Store>,
    shutdown: watch::Sender<bool>,
    http: JoinHandle<()>,
    worker: JoinHandle<()>,
}

/// Why a service did not start.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// The address is taken or not ours.
    #[error("can't listen on {address}: {cause}")]
    Listen {
        /// The address.
        address: SocketAddr,
        /// What the system said.
        cause: std::io::Error,
    },
    /// The database can't be used.
    #[error(transparent)]
    Store(#[from] StoreError),
}

impl Service {
    /// Starts a service and returns when it answers. What a crash left running goes on.
    ///
    /// # Errors
    /// When the address is taken, or the database can't be used.
    pub async fn start(parts: ServiceParts) -> Result<Self, StartError> {
        let listen_error = |cause| StartError::Listen {
            address: parts.address,
            cause,
        };
        let store = Arc::new(Store::open(&parts.database).await?);
        let listener = TcpListener::bind(parts.address)
            .await
            .map_err(listen_error)?;
        let address = listener.local_addr().map_err(listen_error)?;
        queue::recover(&store).await?;
        let (shutdown, stopping) = shutdown::channel();
        let engine = Engine {
            store: store.clone(),
            solver: parts.solver,
            threads: parts.threads,
        };
        let queue = Arc::new(Queue::new(engine.clone(), parts.turn, stopping.clone()));
        let state = AppState {
            store: store.clone(),
            engine,
            queue: queue.clone(),
            shutdown: stopping.clone(),
        };
        let http = tokio::spawn(listener::serve(
            listener,
            app(state, HostList::of(address)),
            stopping,
        ));
        let worker = tokio::spawn(async move { queue.work().await });
        Ok(Self {
            address,
            store,
            shutdown,
            http,
            worker,
        })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// The database file.
    pub fn database(&self) -> &Path {
        self.store.path()
    }

    /// Stops within a Newton iteration: a study that runs goes back into the queue, requests in flight are answered.
    pub async fn stop(self) {
        self.shutdown.send_replace(true);
        for (what, task) in [("queue", self.worker), ("listener", self.http)] {
            match tokio::time::timeout(PATIENCE, task).await {
                Ok(Ok(())) => {}
                Ok(Err(error)) => tracing::error!(%error, what, "a part of the service broke"),
                Err(_) => tracing::warn!(what, "a part of the service did not end in time"),
            }
        }
        self.store.close().await;
    }
}
