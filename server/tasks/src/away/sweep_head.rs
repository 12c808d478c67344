//! Head of one of a service's sweeps: the database stays open for whatever else is done.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use service::engine::Engine;
use store::merging::target::Merging;
use store::queue::design_rows::{self, Openness};
use tokio::runtime::Handle;

use super::away_report::Reports;
use crate::packing::{Given, Packer};
use crate::rounds::head::{Head, Told, Wish};
use crate::task_error::TaskError;

/// Interval at which the database is asked whether the sweep is wanted.
const LOOK: Duration = Duration::from_secs(1);

/// Head of a sweep.
pub(super) struct SweepHead<'h> {
    pub engine: &'h Engine,
    pub reports: &'h Reports,
    /// Whether the service stops.
    pub stop: &'h AtomicBool,
    pub runtime: &'h Handle,
    pub sweep: &'h str,
    /// Answer of the database, and when it was.
    pub looked: Mutex<Option<(Instant, Wish)>>,
}

impl SweepHead<'_> {
    /// Wish that the state of the sweep says; the last one where the database can't be read.
    fn looked(&self) -> Wish {
        let mut looked = self.looked.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((at, wish)) = *looked
            && at.elapsed() < LOOK
        {
            return wish;
        }
        let openness = self.runtime.block_on(async {
            let mut connection = self.engine.store.read().await?;
            design_rows::openness(&mut connection, self.sweep).await
        });
        let wish = match openness {
            Ok(Openness::Open) => Wish::GoOn,
            Ok(Openness::Ended) => Wish::End,
            Ok(Openness::Gone) => Wish::Forget,
            Err(error) => {
                tracing::warn!(%error, sweep = self.sweep, "whether a sweep is wanted isn't known");
                looked.map_or(Wish::GoOn, |(_, wish)| wish)
            }
        };
        *looked = Some((Instant::now(), wish));
        wish
    }
}

impl Head for SweepHead<'_> {
    fn lacking(&self, minutes: f64) -> Result<Vec<Given>, TaskError> {
        let packer = Packer {
            runtime: self.runtime,
            engine: self.engine,
            minutes,
            stop: self.stop,
        };
        packer.pack(self.sweep)
    }

    fn merging(&self) -> Result<Merging, TaskError> {
        let store = self.engine.store.clone();
        Ok(self.runtime.block_on(Merging::beside(store))?)
    }

    fn wish(&self) -> Wish {
        match self.stop.load(Ordering::Relaxed) {
            true => Wish::Leave,
            false => self.looked(),
        }
    }

    fn told(&self, told: Told<'_>) {
        match told {
            Told::Refused(refusal) => {
                tracing::warn!(sweep = self.sweep, because = ?refusal.because, "a node handed in nothing");
            }
            Told::Warned(words) => tracing::warn!(sweep = self.sweep, ?words, "tasks elsewhere"),
            Told::Begun { designs, tasks } => {
                tracing::info!(sweep = self.sweep, designs, tasks, "tasks given away");
            }
            Told::Standing { .. } | Told::Over => {}
        }
        self.reports.change(self.sweep, |report| report.note(told));
    }
}
