//! Who watches a solve on its way, and what it hears.

use std::sync::atomic::{AtomicBool, Ordering};

use serde::{Deserialize, Serialize};

/// May wish a solve to stop, and hears how far it is. A flag only wishes.
pub trait Watch: Sync {
    /// Whether the solve is to end at its next Newton iteration.
    fn is_stopped(&self) -> bool;

    /// A Newton iteration begins; told by solvers that can. Takes no time.
    fn tell(&self, _progress: SolveProgress) {}
}

/// How far a solve is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct SolveProgress {
    /// What is done to the tire.
    pub stage: Stage,
    /// Share of the stage's loads at which it has been in equilibrium, 0 to 1.
    pub share: f64,
    /// Newton iterations so far.
    pub iterations: usize,
    /// Residual at which the newest one began: out-of-balance forces and volumes, relative to the tire's own; null where it has none. An equilibrium has 1e-8.
    pub residual: Option<f64>,
}

/// What is done to the tire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// It is inflated.
    Inflating,
    /// It is pressed on the ground, or dragged there.
    Pressing,
}

impl Watch for AtomicBool {
    fn is_stopped(&self) -> bool {
        self.load(Ordering::Relaxed)
    }
}
