//! Causes of a solve without an answer.

use serde::{Deserialize, Serialize};

use document::fault::Fault;

/// Cause of a solve without an answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// The scene asks for something that this solver doesn't do.
    #[error("the scene is refused")]
    Refused {
        /// Faults of the scene, each with its place.
        faults: Vec<Fault>,
    },
    /// The physics has no answer, or none was found.
    #[error("{}: {detail}", status.as_str())]
    NoEquilibrium {
        /// The kind of failure.
        status: NoEquilibrium,
        /// Load, and how far it got, in words.
        detail: String,
        /// Loads reached.
        reached: Reached,
    },
    /// The caller asked to stop.
    #[error("stopped on request")]
    Stopped,
    /// The solver itself failed; a retry may help.
    #[error("the solver failed: {detail}")]
    Broken {
        /// Course of the failure, in words.
        detail: String,
    },
    /// The process in which it was solved alone ended by its own fault. No solver says so, only who started that process.
    #[error("its process crashed: {detail}")]
    Crashed {
        /// End of the process, and what it said last.
        detail: String,
    },
    /// No answer came within the time that a solve may take. No solver says so, only who watches it.
    #[error("{}", over_time(*.limit_s, *.left_behind))]
    OverTime {
        /// The time that a solve may take, s.
        limit_s: f64,
        /// Whether it didn't heed its stop flag either: its thread runs on until the program ends.
        left_behind: bool,
    },
}

fn over_time(limit_s: f64, left_behind: bool) -> String {
    let heed = match left_behind {
        true => ", and it did not heed the wish to stop: its thread is left behind",
        false => "",
    };
    format!("no answer within the {limit_s} s that a solve may take{heed}")
}

impl SolveError {
    /// Error of a solver that itself failed.
    pub fn broken(error: impl std::fmt::Display) -> Self {
        Self::Broken {
            detail: error.to_string(),
        }
    }

    /// Returns the error of the mirrored ground, when asked to exchange left and right.
    pub fn mirrored(mut self, exchange: bool) -> Self {
        if let (true, Self::NoEquilibrium { reached, .. }) = (exchange, &mut self) {
            reached.depths_mm.reverse();
        }
        self
    }
}

/// Kinds of missing equilibria.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NoEquilibrium {
    /// Load control ended at a limit point.
    LimitPoint,
    /// The tire touches itself.
    SelfContact,
    /// The rubber would be stretched beyond what any rubber bears.
    Overstretched,
    /// The rubber would be squeezed or folded beyond what a mesh can follow.
    Crushed,
    /// Newton's method didn't converge at the smallest step.
    NotConverged,
    /// Equilibrium that isn't looked for any more: looking for it ended the program. No solver says so, only who keeps count.
    Quarantined,
    /// The solver broke, or took too long: whether there is one isn't known. No solver says so, only who asked it.
    SolverFailed,
}

impl NoEquilibrium {
    /// All that the physics gives.
    pub const ALL: [Self; 5] = [
        Self::LimitPoint,
        Self::SelfContact,
        Self::Overstretched,
        Self::Crushed,
        Self::NotConverged,
    ];

    /// The name in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::LimitPoint => "limit-point",
            Self::SelfContact => "self-contact",
            Self::Overstretched => "overstretched",
            Self::Crushed => "crushed",
            Self::NotConverged => "not-converged",
            Self::Quarantined => "quarantined",
            Self::SolverFailed => "solver-failed",
        }
    }
}

/// Loads that a failed solve got to.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Reached {
    /// Internal pressure of the last equilibrium, MPa.
    pub pressure_mpa: f64,
    /// Station depths of the last equilibrium, mm.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub depths_mm: Vec<f64>,
    /// Vertical force of the ground at the last equilibrium, N, where it is to press with one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub load_n: Option<f64>,
}
