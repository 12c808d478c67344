//! Observers of a solve on its way.

use std::sync::atomic::{AtomicBool, Ordering};

/// May wish a solve to stop, and hears how far it is. A flag only wishes.
pub trait Watch {
    /// Whether the solve is to end at its next iteration.
    fn is_stopped(&self) -> bool;

    /// A Newton iteration begins at this residual, relative as in [`Imbalance::worst`](crate::linear::system::Imbalance::worst).
    fn iterated(&self, _residual: f64) {}

    /// A path has come to this share of its loads.
    fn reached(&self, _share: f64) {}
}

impl Watch for AtomicBool {
    fn is_stopped(&self) -> bool {
        self.load(Ordering::Relaxed)
    }
}
