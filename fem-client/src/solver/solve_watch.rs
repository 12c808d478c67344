//! Observers of a solve on its way, and what they hear.

use std::sync::atomic::{AtomicBool, Ordering};

use serde::{Deserialize, Serialize};

/// May wish a solve to stop, and hears how far it is. A flag only wishes.
pub trait Watch: Sync {
    /// Whether the solve is to end at its next Newton iteration.
    fn is_stopped(&self) -> bool;

    /// A Newton iteration begins; told by solvers that can. Takes no time.
    fn tell(&self, _progress: SolveProgress) {}
}

/// Progress of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SolveProgress {
    /// Stage of the loads.
    pub stage: Stage,
    /// Share of the stage's loads at which it has been in equilibrium, 0 to 1.
    pub share: f64,
    /// Newton iterations so far.
    pub iterations: usize,
    /// Residual at which the newest one began: out-of-balance forces and volumes, relative to the tire's own; null where it has none. An equilibrium has 1e-8.
    pub residual: Option<f64>,
}

/// Stage of the loads on a tire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// Inflation.
    Inflating,
    /// Pressing on the ground, or dragging there.
    Pressing,
}

impl Watch for AtomicBool {
    fn is_stopped(&self) -> bool {
        self.load(Ordering::Relaxed)
    }
}
