//! Events of a run, told to its caller on the way.

use fem_client::solver::SolveProgress;

use results::Estimate;

/// Event of a run, as it happens.
#[derive(Debug, Clone, PartialEq)]
pub enum Event {
    /// The archive was searched; the solves begin. An adaptive method may go on to a longer plan, and every run goes on to the
    /// same points on a coarser mesh: it begins again then.
    Started {
        /// Points of the run, as far as that is known.
        points: usize,
        /// Points that are there already.
        reused: usize,
    },
    /// A point was solved, and is in the archive.
    PointSolved {
        /// Ordinal in the plan.
        ordinal: usize,
        /// Points done so far, reused ones included; rises by one from event to event.
        done: usize,
        /// Points of the plan.
        of: usize,
        /// Wall-clock time of the solve, s.
        wall_s: f64,
        /// Newton iterations of the solve.
        newton_iterations: usize,
    },
    /// A point has no response: no equilibrium, which is in the archive, or its solve broke. Both count as done, a refused one
    /// doesn't.
    PointFailed {
        /// Ordinal in the plan.
        ordinal: usize,
        /// Points done, as for solved points.
        done: usize,
        /// Points of the plan.
        of: usize,
        /// Cause of the failure, in words.
        cause: String,
    },
    /// A solve that takes longer has come so far: told now and then, and by solvers that can.
    Solving {
        /// The point's ordinal in the plan.
        ordinal: usize,
        /// Progress of the solve.
        progress: SolveProgress,
    },
    /// All points are there.
    Analysing,
    /// The study takes another time than was said. No run says so, only who measures its solves.
    Revised(Box<Estimate>),
}

/// Is told of events, from the solving threads, one at a time for points.
pub type Observer<'o> = &'o (dyn Fn(Event) + Sync);
