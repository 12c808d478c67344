//! The running service: database, queue and HTTP together.

use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use fem_client::solver::Solver;
use placement::points::machine_memory::machine_memory_bytes;
use tokio::sync::watch;
use tokio::task::JoinHandle;
use tokio::time::Instant;

use crate::http::app_state::AppState;
use crate::http::edge::access::Access;
use crate::http::edge::answer_limits::AnswerLimits;
use crate::http::edge::guard::{HostList, HostName};
use crate::http::edge::listener;
use crate::http::edge::streams::Streams;
use crate::http::mount::Mounting;
use crate::http::router::app;
use crate::http::routes::answers::sent_result::Intact;
use crate::token::{Token, TokenError};
use service::at_once::previewer::Previewer;
use service::at_once::scene_solver::SceneSolver;
use service::engine::Engine;
use service::forces::estimator_queue::{self, EstimatorQueue, FitMeans};
use service::metrics::Metrics;
use service::queue::{self, Queue};
use service::work::memory_share::MemoryShare;
use service::work::own_process::Start;
use service::work::shutdown;
use store::{Store, StoreError};
use tasks::away::{Away, Means};

/// Time that all parts have to end. What lasts longer ends with the program: what was stored is whole, and the rest is done again after the next start.
const PATIENCE: Duration = Duration::from_secs(3);

/// Parts of a service.
pub struct ServiceParts {
    /// Address where it listens; port 0 takes a free one.
    pub address: SocketAddr,
    /// The database file.
    pub database: PathBuf,
    /// Solver of studies.
    pub solver: Arc<dyn Solver>,
    /// Solver of previews: another one, so that a running study keeps what its solves share.
    pub previewer: Arc<dyn Solver>,
    /// Time that a preview may take.
    pub preview_limit: Duration,
    /// Time that a single scene may take.
    pub scene_limit: Duration,
    /// Starts a process that learns an estimator.
    pub learner: Start,
    /// Starts a process that analyses a model of others.
    pub analyst: Start,
    /// Solves that run at once.
    pub threads: usize,
    /// Time that a study runs before another one that waits has its turn.
    pub turn: Duration,
    /// Engines that clients may name.
    pub means: Means,
    /// Clients that it answers.
    pub outside: Outside,
}

/// Clients that a service answers.
#[derive(Debug, Default)]
pub struct Outside {
    /// Token that a client has to know; without it every program on this machine is let in, and none elsewhere.
    pub token: Option<Token>,
    /// Names under which others reach the service.
    pub hosts: Vec<HostName>,
    /// Path where they see it.
    pub mounting: Mounting,
    /// Limits on what it takes on.
    pub limits: Limits,
}

/// Limits on what clients may make grow.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Studies that wait in the queue.
    pub waiting_studies: u32,
    /// Event streams at once.
    pub event_streams: usize,
    /// Memory that a study may take, bytes.
    pub memory_bytes: u64,
    /// Size that the database may grow to, bytes; without one, the disk's.
    pub database_bytes: Option<u64>,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            waiting_studies: 20_000,
            event_streams: 256,
            memory_bytes: machine_memory_bytes(),
            database_bytes: None,
        }
    }
}

impl Outside {
    /// Refuses to be reached from other machines by everybody.
    ///
    /// # Errors
    /// [`Exposed`].
    pub fn check(&self, address: SocketAddr) -> Result<(), Exposed> {
        if self.token.is_some() || (address.ip().is_loopback() && self.hosts.is_empty()) {
            return Ok(());
        }
        Err(Exposed { address })
    }
}

/// A service that other machines could reach, and no token.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "a service at {address} or under names of its own can be reached from other machines: that takes a token (--token); \
     without one it serves 127.0.0.1 and [::1] under their own names, and a forwarded port is reached as in \
     ssh -L 8080:localhost:8080"
)]
pub struct Exposed {
    /// Address where it would listen.
    pub address: SocketAddr,
}

/// A service that runs until it is stopped.
pub struct Service {
    address: SocketAddr,
    login: Option<String>,
    store: Arc<Store>,
    shutdown: watch::Sender<bool>,
    http: JoinHandle<()>,
    worker: JoinHandle<()>,
    learner: JoinHandle<()>,
    away: JoinHandle<()>,
}

/// Reason why a service did not start.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// The address is taken or not ours.
    #[error("can't listen on {address}: {cause}")]
    Listen {
        /// The address.
        address: SocketAddr,
        /// Cause in the words of the system.
        cause: std::io::Error,
    },
    /// The database can't be used.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Other machines could reach it, and there is no token.
    #[error(transparent)]
    Exposed(#[from] Exposed),
    /// A missing secret for a browser.
    #[error(transparent)]
    Token(#[from] TokenError),
}

impl Service {
    /// Starts a service and returns when it answers. What a crash left running goes on.
    ///
    /// # Errors
    /// See [`StartError`].
    pub async fn start(parts: ServiceParts) -> Result<Self, StartError> {
        let Outside {
            token,
            hosts,
            mounting,
            limits,
        } = &parts.outside;
        parts.outside.check(parts.address)?;
        let listen_error = |cause| StartError::Listen {
            address: parts.address,
            cause,
        };
        let store = Arc::new(Store::open_within(&parts.database, limits.database_bytes).await?);
        let listener = listener::bind(parts.address).map_err(listen_error)?;
        let address = listener.local_addr().map_err(listen_error)?;
        queue::recover(&store).await?;
        estimator_queue::recover(&store).await?;
        let (shutdown, stopping) = shutdown::channel();
        let metrics = Metrics::new();
        let memory = Arc::new(MemoryShare::new(limits.memory_bytes));
        let engine = Engine {
            store: store.clone(),
            solver: parts.solver,
            threads: parts.threads,
            metrics: metrics.clone(),
            live: Arc::default(),
            memory: memory.clone(),
        };
        let queue = Arc::new(Queue::new(
            engine.clone(),
            parts.turn,
            limits.waiting_studies,
            stopping.clone(),
        ));
        let away = Away::new(engine.clone(), queue.clone(), parts.means, stopping.clone());
        let away = Arc::new(away);
        let means = FitMeans {
            start: parts.learner,
            threads: parts.threads,
            turn: parts.turn,
            memory_bytes: limits.memory_bytes,
            memory,
        };
        let estimators = EstimatorQueue::new(store.clone(), means, stopping.clone());
        let estimators = Arc::new(estimators);
        let previewer = Previewer::new(
            parts.previewer,
            parts.threads,
            parts.preview_limit,
            stopping.clone(),
        );
        let scenes = SceneSolver::new(
            engine.solver.clone(),
            (limits.memory_bytes, engine.memory.clone()),
            parts.scene_limit,
            stopping.clone(),
        );
        let access = Access::of(token.clone(), address.port());
        let login = access.link()?;
        let hosts = HostList::of(address, hosts);
        let state = AppState {
            store: store.clone(),
            engine,
            queue: queue.clone(),
            away: away.clone(),
            estimators: estimators.clone(),
            previewer: Arc::new(previewer),
            scenes: Arc::new(scenes),
            analyst: Arc::new(parts.analyst),
            shutdown: stopping.clone(),
            access,
            metrics,
            streams: Streams::new(limits.event_streams),
            answers: AnswerLimits::default(),
            intact: Intact::default(),
            memory_bytes: limits.memory_bytes,
        };
        let app = app(state, hosts, mounting.clone());
        let http = tokio::spawn(listener::serve(listener, app, stopping));
        let worker = tokio::spawn(async move { queue.work().await });
        let learner = tokio::spawn(async move { estimators.work().await });
        let away = tokio::spawn(away.work());
        Ok(Self {
            address,
            login,
            store,
            shutdown,
            http,
            worker,
            learner,
            away,
        })
    }

    /// Returns the address where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// The path that lets one browser in, once; `None` where no token is asked for.
    pub fn login(&self) -> Option<&str> {
        self.login.as_deref()
    }

    /// The database file.
    pub fn database(&self) -> &Path {
        self.store.path()
    }

    /// Stops within a Newton iteration: a study that runs goes back into the queue and an estimator into its line, requests in flight are answered.
    ///
    /// # Errors
    /// [`StoreError::Gone`] when the database was removed or replaced meanwhile.
    pub async fn stop(self) -> Result<(), StoreError> {
        self.shutdown.send_replace(true);
        let deadline = Instant::now() + PATIENCE;
        for (what, task) in [
            ("queue", self.worker),
            ("estimators", self.learner),
            ("engines", self.away),
            ("listener", self.http),
        ] {
            match tokio::time::timeout_at(deadline, task).await {
                Ok(Ok(())) => {}
                Ok(Err(error)) => tracing::error!(%error, what, "a part of the service broke"),
                Err(_) => tracing::warn!(what, "a part of the service did not end in time"),
            }
        }
        self.store.close().await
    }
}
