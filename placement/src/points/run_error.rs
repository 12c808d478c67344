//! Reasons why a run gave no result.

use document::fault::Fault;

use crate::points::archive::ArchiveError;
use documents::study::plan::PlanError;
use results::FailedPoint;

/// Reason why a run gave no result. What was solved is in the archive in every case.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError {
    /// The cut point has no equilibrium or none was found, or the solver refused points.
    #[error("{}", failures(.failed))]
    PointsFailed {
        /// Points in the order of the plan; at least one.
        failed: Vec<FailedPoint>,
    },
    /// Failures of so many points that the others don't give any index.
    #[error("the other points don't give any index: {}", failures(.failed))]
    TooManyFailed {
        /// Points in the order of the plan; at least one.
        failed: Vec<FailedPoint>,
    },
    /// The solver doesn't do what the scene asks for.
    #[error("the solver refuses the scene: {}", refusals(.faults))]
    Refused {
        /// Faults of the scene, each with its place.
        faults: Vec<Fault>,
    },
    /// A point that an adaptive method asked for leaves the ranges of the scene.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The caller asked to stop; the same run later goes on where this one ended.
    #[error("stopped on request")]
    Stopped,
    /// The caller asked for a pause; the same run later goes on where this one ended.
    #[error("paused on request")]
    Paused,
    /// The time allowed is over before the cheapest model has answered.
    #[error(
        "a budget of {seconds} s is over before the draft has answered; what is solved is kept"
    )]
    Budget {
        /// The budget.
        seconds: f64,
    },
    /// The archive failed.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
    /// The archive has the cut point's response but not its equilibrium, from which the others start.
    #[error(
        "the archive has the response of the cut point ({key}) but not its start state: remove the entry"
    )]
    StartMissing {
        /// Content key of the cut point.
        key: String,
    },
}

impl RunError {
    /// The points that are to blame, if any are.
    pub fn failed_points(&self) -> &[FailedPoint] {
        match self {
            Self::PointsFailed { failed } | Self::TooManyFailed { failed } => failed,
            _ => &[],
        }
    }
}

fn failures(failed: &[FailedPoint]) -> String {
    let count = failed.len();
    match failed.first() {
        Some(FailedPoint {
            ordinal,
            values,
            cause,
        }) => format!(
            "{count} {} failed; the first is point {ordinal} at {values:?}: {cause}",
            if count == 1 { "point" } else { "points" }
        ),
        None => "points failed".to_owned(),
    }
}

pub(crate) fn refusals(faults: &[Fault]) -> String {
    faults
        .iter()
        .map(Fault::to_string)
        .collect::<Vec<_>>()
        .join("; ")
}
