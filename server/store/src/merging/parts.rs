//! Parts of a database that another one takes in, and their counts.

use serde::Serialize;

/// Extent of what is taken of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Taken {
    /// Points, runs of models that other programs serve, studies that are done or failed with their results, sweeps, measured trades, and estimators.
    Everything,
    /// Points, and studies that are done or failed with their results: what a machine hands in that was asked for these.
    Solved,
    /// Studies that are done or failed with their results, without points: the same from a machine, where points would take too much room.
    Answers,
    /// Points alone, and runs of models that other programs serve.
    Points,
    /// Results, sweeps and trades without points, runs of models and estimators: studies say how many points they had, and have none.
    Results,
}

impl Taken {
    /// Whether points come along.
    pub(super) fn has_points(self) -> bool {
        !matches!(self, Self::Answers | Self::Results)
    }
}

/// Rows of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Counted {
    /// Rows that were taken.
    pub new: u64,
    /// Rows that were there already.
    pub known: u64,
}

/// Rows that were taken of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Merged {
    /// Solved points.
    pub points: Counted,
    /// Runs of models that other programs serve.
    pub model_runs: Counted,
    /// Studies that are done or failed.
    pub studies: Counted,
    /// Studies among the new ones that were known here, and hadn't come to this end.
    pub ended: u64,
    /// Sweeps all of whose designs are here.
    pub sweeps: Counted,
    /// Measured trades.
    pub trades: Counted,
    /// Estimators that were learnt, or failed.
    pub estimators: Counted,
}
