//! Pieces of work on all cores.

use std::sync::atomic::AtomicBool;
use std::thread;

use placement::points::worker_threads::in_parallel;

/// Cores of this machine.
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Computes `of` of each number below `count`, in their order.
pub fn on_all_cores<T: Send>(count: usize, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
    in_parallel(count, cores(), &AtomicBool::new(false), of).expect("nobody stops it")
}
