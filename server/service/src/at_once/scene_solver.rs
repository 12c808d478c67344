//! Equilibria of single scenes, solved at once and forgotten.
//!
//! Each is solved in a process of its own, where the solver knows one: a scene that exhausts memory or crashes ends nothing else, and what a running study shares between its
//! solves stays.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use document::fault::Fault;
use documents::scene_question::{SceneQuestion, in_question};
use fem_client::scene::slips::noting;
use fem_client::solver::film_comparison::compare_film;
use fem_client::solver::{Reached, SolveError, SolveRequest, Solved, Solver};
use placement::estimate::solve_memory_bytes;

use crate::forecast::gigabytes;
use crate::solving::apart::Apart;
use crate::wire::scene_wire::SolvedScene;
use crate::work::memory_share::MemoryShare;
use crate::work::one_at_a_time::{OneAtATime, Unfinished};
use crate::work::shutdown::{Shutdown, unless_stopped};

/// Time that a scene takes at most, its wait for others included: ten times what the reference mesh takes with three derivatives.
pub const SCENE_LIMIT: Duration = Duration::from_secs(80);

/// Reason why a scene has no answer.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// A scene or a readout that the solver doesn't take.
    #[error("the document has faults")]
    Refused {
        /// Faults, at their places in the question.
        faults: Vec<Fault>,
    },
    /// A scene that would take more memory than there is.
    #[error("the scene would take about {} of memory, and {} are there; a coarser model.level takes less", gigabytes(*.needed_bytes), gigabytes(*.there_bytes))]
    TooLarge {
        /// Memory that it would take, bytes.
        needed_bytes: u64,
        /// Memory that there is, bytes.
        there_bytes: u64,
    },
    /// Loads that have no equilibrium.
    #[error("{status}: {detail}; the last equilibrium has {}", told(.reached))]
    NoEquilibrium {
        /// Name of the reason.
        status: &'static str,
        /// A sentence.
        detail: String,
        /// Loads of the last equilibrium.
        reached: Reached,
    },
    /// A solve that took too long.
    #[error("the scene took longer than {} s, with those before it: ask again, or for a coarser model.level", limit.as_secs())]
    OverTime {
        /// Time that it may take.
        limit: Duration,
    },
    /// The service ends.
    #[error("the service is stopping")]
    Stopping,
    /// A crash, a panic or no thread.
    #[error("solving the scene broke; the service's log says why")]
    Broken,
}

/// Solves scenes, one at a time in the whole service.
pub struct SceneSolver {
    solver: Arc<dyn Solver>,
    memory_bytes: u64,
    memory: Arc<MemoryShare>,
    line: OneAtATime,
}

impl SceneSolver {
    /// Solves by `solver` in the memory that it shares with studies and fits (bytes, all of it), each scene in no more than `limit`, until `shutdown`.
    pub fn new(
        solver: Arc<dyn Solver>,
        (memory_bytes, memory): (u64, Arc<MemoryShare>),
        limit: Duration,
        shutdown: Shutdown,
    ) -> Self {
        Self {
            solver,
            memory_bytes,
            memory,
            line: OneAtATime::new("scene", limit, shutdown),
        }
    }

    /// Solves one equilibrium.
    ///
    /// # Errors
    /// See [`SceneError`].
    pub async fn solve(&self, question: SceneQuestion) -> Result<SolvedScene, SceneError> {
        let SceneQuestion { scene, readout } = &question;
        let needed_bytes = solve_memory_bytes(scene, readout, self.solver.as_ref());
        let there_bytes = self.memory_bytes;
        if needed_bytes > there_bytes {
            return Err(SceneError::TooLarge {
                needed_bytes,
                there_bytes,
            });
        }
        let (solver, memory) = (self.solver.clone(), self.memory.clone());
        let runtime = tokio::runtime::Handle::current();
        let work = move |stop: &AtomicBool| {
            let taking = unless_stopped(stop, memory.take(needed_bytes));
            let Some(_memory) = runtime.block_on(taking) else {
                return Err(SceneError::Stopping);
            };
            let request = SolveRequest {
                scene: &question.scene,
                readout: &question.readout,
                start: None,
                watch: stop,
            };
            let solved =
                solved(solver, &request).map_err(|error| SceneError::of(error, &question))?;
            SolvedScene::of(&question.scene, &solved).map_err(|error| {
                tracing::error!(%error, "an answer can't be sent");
                SceneError::Broken
            })
        };
        self.line.done(work).await?
    }
}

fn solved(solver: Arc<dyn Solver>, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
    let apart = Apart::new(solver);
    let mut solved = apart.solve(request)?;
    compare_film(&apart, request, &mut solved)?;
    Ok(solved)
}

impl SceneError {
    fn of(error: SolveError, question: &SceneQuestion) -> Self {
        match error {
            SolveError::Refused { faults } => Self::Refused {
                faults: in_question(faults),
            },
            SolveError::NoEquilibrium {
                status,
                detail,
                reached,
            } => Self::NoEquilibrium {
                status: status.as_str(),
                detail: noting(detail, &question.scene.slips()),
                reached,
            },
            SolveError::Stopped => Self::Stopping,
            SolveError::OverTime { .. }
            | SolveError::Broken { .. }
            | SolveError::Crashed { .. } => {
                tracing::error!(%error, "a scene couldn't be solved");
                Self::Broken
            }
        }
    }
}

impl From<Unfinished> for SceneError {
    fn from(reason: Unfinished) -> Self {
        match reason {
            Unfinished::OverTime(limit) => Self::OverTime { limit },
            Unfinished::Stopping => Self::Stopping,
            Unfinished::Broken => Self::Broken,
        }
    }
}

/// Loads in words.
fn told(reached: &Reached) -> String {
    let pressure = format!("{} MPa", reached.pressure_mpa);
    let load = reached.load_n.map(|load| format!(" under {load} N"));
    let depths = (!reached.depths_mm.is_empty())
        .then(|| format!(" at depths of {:?} mm", reached.depths_mm));
    pressure + &load.or(depths).unwrap_or_default()
}
