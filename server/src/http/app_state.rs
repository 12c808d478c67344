//! What every handler may use.

use std::sync::Arc;

use service::engine::Engine;
use service::metrics::Metrics;
use service::queue::Queue;
use service::shutdown::Shutdown;
use store::Store;

use crate::http::edge::access::Access;
use crate::http::edge::streams::Streams;

/// What every handler may use.
#[derive(Clone)]
pub struct AppState {
    /// The database.
    pub store: Arc<Store>,
    /// Solves, and knows on how many threads.
    pub engine: Engine,
    /// The queue of studies.
    pub queue: Arc<Queue>,
    /// Memory that a study may take, bytes.
    pub memory_bytes: u64,
    /// Hears when the service is to stop.
    pub shutdown: Shutdown,
    /// Who is let in.
    pub access: Access,
    /// Counts requests and whatever else.
    pub metrics: Arc<Metrics>,
    /// Places for event streams.
    pub streams: Streams,
}
