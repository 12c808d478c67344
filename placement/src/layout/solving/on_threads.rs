//! Work on all of a run's threads.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::run::RunContext;
use crate::run::usage::{cpu_s, credit};

/// What `of` makes of each number below `count`, on all threads; `None` when the study is stopped meanwhile.
pub(crate) fn in_parallel<T: Send>(
    count: usize,
    context: RunContext<'_>,
    of: impl Fn(usize) -> T + Sync,
) -> Option<Vec<T>> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        while !context.stop.load(Ordering::Relaxed) {
            let i = next.fetch_add(1, Ordering::Relaxed);
            if i >= count {
                break;
            }
            done.push((i, of(i)));
        }
        (done, cpu_s())
    };
    let mut all: Vec<(usize, T)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..context.threads.min(count))
            .map(|_| scope.spawn(work))
            .collect();
        let ended = threads.into_iter().flat_map(|thread| {
            let (done, cpu_s) = thread.join().unwrap_or_else(|panic| resume_unwind(panic));
            credit(cpu_s);
            done
        });
        ended.collect()
    });
    all.sort_by_key(|(i, _)| *i);
    (all.len() == count).then(|| all.into_iter().map(|(_, done)| done).collect())
}
