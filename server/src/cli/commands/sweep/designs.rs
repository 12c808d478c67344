//! Runs the designs of a sweep, several at once.
//!
//! While the cut point of a design is solved, one thread works and the others wait for it. So designs run side by side, each on its share of the
//! threads, as many as memory allows; their results are the same to the bit as one after the other. Designs that share points stay
//! together, in their order, so that none solves what another one is at.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use fem_client::solver::Solver;
use indicatif::ProgressBar;
use placement::estimate::Workload;
use placement::points::Event;
use tokio::runtime::Handle;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::progress::say_failed;
use service::engine::{End, Engine};
use service::forecast::many_designs::TOGETHER;
use service::forecast::memory_bytes;
use store::StoreError;
use store::queue::design_rows::DesignRow;
use store::queue::turns;
use tasks::grouping::{Groups, workloads};

/// Crew that runs designs.
pub(crate) struct Crew<'c> {
    pub runtime: &'c Handle,
    pub engine: &'c Engine,
    /// A solver for each design at work: one remembers the tire that it solved last.
    pub solver: &'c (dyn Fn() -> Result<Arc<dyn Solver>, Failure> + Sync),
    /// Memory that they may take together, bytes.
    pub memory_bytes: u64,
    pub stop: &'c AtomicBool,
}

impl Crew<'_> {
    /// Runs those of the designs that have not ended, each to its end, whatever that is; false when the user asked to stop.
    pub fn run(&self, designs: &[DesignRow], bar: &ProgressBar) -> Result<bool, Failure> {
        let open: Vec<&DesignRow> = designs.iter().filter(|d| !d.study.ended()).collect();
        let solver = self.engine.solver.as_ref();
        let (mut groups, mut largest_bytes) = (Groups::default(), 1);
        for some in open.chunks(TOGETHER) {
            let Some(works) = workloads(some, solver, self.engine.threads, self.stop) else {
                return Ok(false);
            };
            for work in &works {
                groups.add(work.iter().flat_map(Workload::keys));
                let needed = work.as_ref().map_or(1, |work| memory_bytes(work, 1));
                largest_bytes = needed.max(largest_bytes);
            }
        }
        let groups = groups.into_groups();
        let at_once = self.at_once(largest_bytes, groups.len());
        let progress = Progress::new(bar, designs.len(), open.len());
        let (next, failed) = (AtomicUsize::new(0), Mutex::new(None));
        let work = |threads: usize| {
            let engine = Engine {
                solver: (self.solver)()?,
                threads,
                ..self.engine.clone()
            };
            while let Some(group) = groups.get(next.fetch_add(1, Ordering::Relaxed)) {
                for index in group {
                    if self.stop.load(Ordering::Relaxed) {
                        return Ok(());
                    }
                    self.solve(&engine, open[*index], &|event| progress.show(*index, event))?;
                    progress.ended(*index);
                }
            }
            Ok(())
        };
        let work = |threads: usize| {
            if let Err(failure) = work(threads) {
                self.stop.store(true, Ordering::Relaxed);
                let mut failed = failed.lock().unwrap_or_else(PoisonError::into_inner);
                failed.get_or_insert(failure);
            }
        };
        let threads = self.engine.threads;
        std::thread::scope(|scope| {
            for worker in 0..at_once {
                // Threads that can't be shared out evenly go to the first.
                let share = threads / at_once + usize::from(worker < threads % at_once);
                let work = &work;
                scope.spawn(move || work(share.max(1)));
            }
        });
        match failed.into_inner().unwrap_or_else(PoisonError::into_inner) {
            Some(failure) => Err(failure),
            None => Ok(!self.stop.load(Ordering::Relaxed)),
        }
    }

    /// Designs that fit beside each other, of which the largest takes so much memory, bytes.
    fn at_once(&self, largest_bytes: u64, groups: usize) -> usize {
        let fit = usize::try_from(self.memory_bytes / largest_bytes).unwrap_or(usize::MAX);
        self.engine.threads.min(groups).min(fit).max(1)
    }

    fn solve(
        &self,
        engine: &Engine,
        design: &DesignRow,
        observer: &(dyn Fn(&Event) + Sync),
    ) -> Result<(), Failure> {
        let claimed = self.runtime.block_on(async {
            let mut transaction = engine.store.begin().await?;
            let row = turns::claim(&mut transaction, &design.study.id).await?;
            engine.store.commit(transaction, 0).await?;
            Ok::<_, StoreError>(row)
        });
        let Some(row) = claimed.map_err(Failure::other)? else {
            return Ok(());
        };
        let end = engine.run(&row, self.runtime, self.stop, None, observer);
        let settled = self.runtime.block_on(engine.settle(&row, &end));
        settled.map_err(Failure::other)?;
        match end {
            End::Unstorable(error) => Err(Failure::other(error)),
            End::Done(_) | End::Failed { .. } | End::Stopped | End::Paused => Ok(()),
        }
    }
}

/// The bar of a whole sweep, as if designs that have not begun had as many points as the largest that have.
struct Progress<'b> {
    bar: &'b ProgressBar,
    all: usize,
    before: usize,
    points: Mutex<Vec<Points>>,
}

#[derive(Debug, Clone, Copy, Default)]
struct Points {
    done: usize,
    of: usize,
    ended: bool,
}

impl<'b> Progress<'b> {
    fn new(bar: &'b ProgressBar, all: usize, open: usize) -> Self {
        Self {
            bar,
            all,
            before: all - open,
            points: Mutex::new(vec![Points::default(); open]),
        }
    }

    fn show(&self, index: usize, event: &Event) {
        match event {
            Event::Started { points, reused } => self.set(index, *reused, *points),
            Event::PointSolved { done, of, .. } => self.set(index, *done, *of),
            Event::PointFailed {
                done,
                of,
                ordinal,
                cause,
            } => {
                self.set(index, *done, *of);
                say_failed(self.bar, *ordinal, cause);
            }
            // A sweep has a bar for all of its designs.
            Event::Solving { .. } | Event::Analysing | Event::Revised(_) => {}
        }
    }

    fn set(&self, index: usize, done: usize, of: usize) {
        self.update(|points| {
            points[index].done = done;
            points[index].of = of;
        });
    }

    fn ended(&self, index: usize) {
        self.update(|points| {
            points[index].done = points[index].of;
            points[index].ended = true;
        });
    }

    fn update(&self, change: impl FnOnce(&mut Vec<Points>)) {
        let mut points = self.points.lock().unwrap_or_else(PoisonError::into_inner);
        change(&mut points);
        let largest = points.iter().map(|points| points.of).max().unwrap_or(0);
        let of = |points: &Points| if points.of == 0 { largest } else { points.of };
        let count = |number: usize| u64::try_from(number).unwrap_or(u64::MAX);
        let ended = self.before + points.iter().filter(|points| points.ended).count();
        self.bar
            .set_prefix(format!("{ended} of {} designs  ", self.all));
        self.bar.set_length(count(points.iter().map(of).sum()));
        self.bar
            .set_position(count(points.iter().map(|points| points.done).sum()));
    }
}
