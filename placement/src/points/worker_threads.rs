//! Work on threads of its own, as many as a user asks for.

use std::sync::atomic::{AtomicBool, Ordering};

use rayon::ThreadPoolBuilder;
use rayon::iter::{ParallelBridge, ParallelIterator};

use crate::points::usage::{cpu_s, credit};

/// Runs `work` on so many threads of its own, and counts their processor time with this one's.
///
/// # Panics
/// If no thread can be started, or `work` panics.
pub(crate) fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = ThreadPoolBuilder::new().num_threads(threads.max(1)).build();
    let pool = pool.expect("threads start");
    let done = pool.install(work);
    credit(pool.broadcast(|_| cpu_s()).iter().sum());
    done
}

/// Computes `of` of each number below `count`, on so many threads; `None` when it is stopped meanwhile.
///
/// # Panics
/// If no thread can be started, or `of` panics.
pub fn in_parallel<T: Send>(
    count: usize,
    threads: usize,
    stop: &AtomicBool,
    of: impl Fn(usize) -> T + Sync,
) -> Option<Vec<T>> {
    let unless_stopped = |i| (!stop.load(Ordering::Relaxed)).then(|| (i, of(i)));
    // A bridge hands them out in their order, the longest first where a caller sorts them so; a range would be cut into halves.
    let pieces = || (0..count).par_bridge().map(unless_stopped);
    let made: Option<Vec<(usize, T)>> = on_threads(threads.min(count), || pieces().collect());
    let mut made = made?;
    made.sort_unstable_by_key(|(i, _)| *i);
    Some(made.into_iter().map(|(_, made)| made).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_piece_is_made_once_and_stands_in_its_place() {
        for threads in [0, 1, 3] {
            let made = in_parallel(100, threads, &AtomicBool::new(false), |i| i * i);
            assert_eq!(made, Some((0..100).map(|i| i * i).collect()));
        }
        let none = in_parallel(0, 2, &AtomicBool::new(false), |i| i);
        assert_eq!(none, Some(Vec::new()));
    }

    #[test]
    fn a_stop_gives_nothing_and_begins_no_piece_more() {
        let stop = AtomicBool::new(false);
        let made = in_parallel(100, 1, &stop, |i| {
            assert!(i <= 10, "in their order");
            stop.store(i == 10, Ordering::Relaxed);
        });
        assert_eq!(made, None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn the_time_of_all_threads_is_counted() {
        const BUSY: f64 = 0.1;
        let before = cpu_s();
        let busy = |_| {
            let begun = cpu_s();
            while cpu_s() < begun + BUSY {
                std::hint::black_box(0);
            }
        };
        in_parallel(3, 2, &AtomicBool::new(false), busy).expect("nobody stops it");
        assert!(cpu_s() - before >= 3.0 * BUSY);
    }
}
