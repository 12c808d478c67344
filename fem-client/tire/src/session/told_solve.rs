//! Tells whoever watches a solve how far it is.

use std::cell::Cell;

use fem::newton::watch::Watch;
use fem_client::solver;
use fem_client::solver::{SolveProgress, Stage};

/// Counts a solve's iterations, and knows its stage.
pub(crate) struct ToldSolve<'w> {
    watch: &'w dyn solver::Watch,
    stage: Cell<Stage>,
    share: Cell<f64>,
    iterations: Cell<usize>,
}

impl<'w> ToldSolve<'w> {
    /// A solve that begins.
    pub(crate) fn new(watch: &'w dyn solver::Watch) -> Self {
        Self {
            watch,
            stage: Cell::new(Stage::Inflating),
            share: Cell::new(0.0),
            iterations: Cell::new(0),
        }
    }

    /// A stage begins.
    pub(crate) fn begin(&self, stage: Stage) {
        self.stage.set(stage);
        self.share.set(0.0);
    }
}

impl Watch for ToldSolve<'_> {
    fn is_stopped(&self) -> bool {
        self.watch.is_stopped()
    }

    fn iterated(&self, residual: f64) {
        self.iterations.set(self.iterations.get() + 1);
        self.watch.tell(SolveProgress {
            stage: self.stage.get(),
            share: self.share.get(),
            iterations: self.iterations.get(),
            residual: Some(residual).filter(|residual| residual.is_finite()),
        });
    }

    fn reached(&self, share: f64) {
        self.share.set(share);
    }
}
