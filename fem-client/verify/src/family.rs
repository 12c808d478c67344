//! Cases that are solved together, and why they may have no answer.

use std::sync::atomic::AtomicBool;

use fem::linear::setup::SetupError;
use fem::newton::iteration::Cause;
use fem_client::solver::SolveError;

use crate::known_case::Case;

/// Reason why a case has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Unsolved {
    /// The model can't be set up.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// A load has no equilibrium that Newton's method finds.
    #[error("no equilibrium beyond {reached} of the load: {cause:?}")]
    Load {
        /// Fraction of the load that was reached.
        reached: f64,
        /// Cause of the last attempt's end.
        cause: Cause,
    },
    /// A volume has none.
    #[error("no equilibrium at a volume ratio of {ratio}: {cause:?}")]
    Volume {
        /// Volume over that of the reference state.
        ratio: f64,
        /// Cause of the attempt's end.
        cause: Cause,
    },
    /// The way to the limit point can't be followed.
    #[error("no way to the limit point: {cause:?}")]
    LimitPoint {
        /// Cause of the last attempt's end.
        cause: Cause,
    },
    /// The pressure rises all the way.
    #[error("no limit point up to a volume ratio of {ratio}")]
    NoLimitPoint {
        /// Largest volume over that of the reference state.
        ratio: f64,
    },
    /// A scene has no equilibrium.
    #[error(transparent)]
    Scene(#[from] SolveError),
    /// Another reason, in words.
    #[error("{0}")]
    Other(String),
}

/// Solves the cases of a family; `true` stops it.
pub type Solve = fn(&AtomicBool) -> Result<Vec<Case>, Unsolved>;

/// Cases that are solved together.
#[derive(Debug, Clone, Copy)]
pub struct Family {
    /// Name by which the family is chosen.
    pub name: &'static str,
    solve: Solve,
}

impl Family {
    /// A family of this name.
    pub const fn new(name: &'static str, solve: Solve) -> Self {
        Self { name, solve }
    }

    /// Solves its cases. A family without an answer is one failed case.
    pub fn cases(&self, stop: &AtomicBool) -> Vec<Case> {
        (self.solve)(stop).unwrap_or_else(|failure| vec![unsolved(self.name, &failure)])
    }
}

/// Stands for a family that has no answer.
fn unsolved(family: &str, failure: &Unsolved) -> Case {
    Case::absolute(family, f64::NAN, 0.0).ended(failure.to_string())
}
