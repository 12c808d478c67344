//! Previews: a study's places and layouts on the draft mesh, solved at once and forgotten.
//!
//! One at a time in the whole service, beside the queue and with a solver of its own, so that what a running study shares between its solves stays. A newer preview
//! stops the one before; so does a client that goes away.

use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use documents::study::Study;
use documents::study::plan::{PlanError, PlannedStudy};
use fem_client::solver::Solver;
use placement::ladder::climb;
use placement::ladder::preview;
use placement::points::RunContext;
use placement::points::RunError;
use placement::points::memory::MemoryArchive;
use tokio::sync::Notify;

use crate::wire::preview_wire::Preview;
use crate::work::one_at_a_time::{OneAtATime, Unfinished};
use crate::work::shutdown::Shutdown;

/// Points that a preview may ask for at first. A draft solve takes about 8 ms of a core: on two cores so many take two seconds, and on one busy core less than the limit.
const MOST_POINTS: usize = 500;

/// Reason why there is no preview.
#[derive(Debug, thiserror::Error)]
pub enum PreviewError {
    /// The design is too large.
    #[error(
        "a preview solves at most {MOST_POINTS} points, and this document asks for about {points}: submit it, or preview it with method.kind = \"mdrm\""
    )]
    TooLarge {
        /// Points that it asks for, or somewhat more.
        points: usize,
    },
    /// A document that can't be planned.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A document whose loads have no equilibrium, or which the solver refuses.
    #[error("there is no preview of this document: {cause}")]
    Unsolved {
        /// Load, and how far it got, in words.
        cause: String,
    },
    /// A newer one was asked for.
    #[error("superseded: a newer preview was asked for")]
    Superseded,
    /// A preview that took too long.
    #[error("the preview took longer than {} s: submit the document as a study", limit.as_secs())]
    OverTime {
        /// Time that it may take.
        limit: Duration,
    },
    /// The service ends.
    #[error("the service is stopping")]
    Stopping,
    /// A panic, or no thread.
    #[error("the preview broke; the service's log says why")]
    Broken,
}

/// Solves previews.
pub struct Previewer {
    solver: Arc<dyn Solver>,
    threads: usize,
    line: OneAtATime,
    /// Tells the newest that was asked for that it is so no more.
    newest: Mutex<Option<Arc<Notify>>>,
}

impl Previewer {
    /// A previewer with a solver of its own, on so many threads, each in no more than `limit`, until `shutdown`.
    pub fn new(
        solver: Arc<dyn Solver>,
        threads: usize,
        limit: Duration,
        shutdown: Shutdown,
    ) -> Self {
        Self {
            solver,
            threads,
            line: OneAtATime::new("preview", limit, shutdown),
            newest: Mutex::default(),
        }
    }

    /// Solves a study's places and layouts on the draft mesh, once the one before has ended, which it does within a Newton iteration.
    ///
    /// # Errors
    /// See [`PreviewError`].
    pub async fn preview(&self, study: &Study) -> Result<Preview, PreviewError> {
        let begun = Instant::now();
        let preview = preview::Preview::of(study);
        let points = preview.study.method.first_points(study.inputs.len());
        if points > MOST_POINTS {
            return Err(PreviewError::TooLarge { points });
        }
        let superseded = self.supersede();
        let (solver, threads) = (self.solver.clone(), self.threads);
        let work = move |stop: &AtomicBool| solved(&preview, solver.as_ref(), threads, stop, begun);
        tokio::select! {
            preview = self.line.done(work) => preview?,
            () = superseded.notified() => Err(PreviewError::Superseded),
        }
    }

    /// Tells the preview before this one; returns what tells this one.
    fn supersede(&self) -> Arc<Notify> {
        let own = Arc::new(Notify::new());
        let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(before) = newest.replace(own.clone()) {
            before.notify_one();
        }
        own
    }
}

impl From<Unfinished> for PreviewError {
    fn from(reason: Unfinished) -> Self {
        match reason {
            Unfinished::OverTime(limit) => Self::OverTime { limit },
            Unfinished::Stopping => Self::Stopping,
            Unfinished::Broken => Self::Broken,
        }
    }
}

fn solved(
    preview: &preview::Preview,
    solver: &dyn Solver,
    threads: usize,
    stop: &AtomicBool,
    begun: Instant,
) -> Result<Preview, PreviewError> {
    let PlannedStudy { study, plan } = PlannedStudy::new(preview.study.clone())?;
    let context = RunContext {
        solver,
        archive: &MemoryArchive::default(),
        threads,
        stop,
        pause: None,
        observer: &|_| {},
    };
    let result = climb::answer(&study, &plan, context).map_err(|error| match error {
        RunError::Stopped => PreviewError::Superseded,
        error => PreviewError::Unsolved {
            cause: error.to_string(),
        },
    })?;
    Ok(Preview {
        claim: "none".to_owned(),
        level: study.level.as_str().to_owned(),
        wall_s: begun.elapsed().as_secs_f64(),
        solves: result.cost.solves + result.cost.layout_solves,
        left_out: preview.left_out.clone(),
        inputs: result.inputs,
        locations: result.locations,
        answer: result.answer,
        cut_point: result.cut_point,
        map: result.map,
        notes: result.notes,
    })
}
