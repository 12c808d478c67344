//! State that every handler may use.

use std::sync::Arc;

use axum::extract::FromRef;
use service::at_once::previewer::Previewer;
use service::at_once::scene_solver::SceneSolver;
use service::engine::Engine;
use service::forces::estimator_queue::EstimatorQueue;
use service::metrics::Metrics;
use service::queue::Queue;
use service::work::own_process::Start;
use service::work::shutdown::Shutdown;
use store::Store;
use tasks::away::Away;

use crate::http::edge::access::Access;
use crate::http::edge::answer_limits::AnswerLimits;
use crate::http::edge::streams::Streams;
use crate::http::routes::answers::sent_result::Intact;

/// State that every handler may use.
#[derive(Clone)]
pub struct AppState {
    /// The database.
    pub store: Arc<Store>,
    /// Solves, and knows on how many threads.
    pub engine: Engine,
    /// The queue of studies.
    pub queue: Arc<Queue>,
    /// Sweeps of it that other machines solve.
    pub away: Arc<Away>,
    /// The line of estimators beside it.
    pub estimators: Arc<EstimatorQueue>,
    /// Solves previews beside it.
    pub previewer: Arc<Previewer>,
    /// Solves single scenes beside it.
    pub scenes: Arc<SceneSolver>,
    /// Starts processes that analyse models of others.
    pub analyst: Arc<Start>,
    /// Memory that a study may take, bytes.
    pub memory_bytes: u64,
    /// Hears when the service is to stop.
    pub shutdown: Shutdown,
    /// Access: who is let in.
    pub access: Access,
    /// Counts requests and whatever else.
    pub metrics: Arc<Metrics>,
    /// Places for event streams.
    pub streams: Streams,
    /// Limits of large answers.
    pub answers: AnswerLimits,
    /// Results that were intact lately.
    pub intact: Intact,
}

impl FromRef<AppState> for AnswerLimits {
    fn from_ref(state: &AppState) -> Self {
        state.answers.clone()
    }
}
