//! Work that takes its time: when it is to stop, what memory it has, and how it is done in a process of its own.
//!
//! Such a process can be ended at any moment, what may crash or exhaust memory doesn't take the program with it, and the way it ends tells who is to blame. The parent
//! writes an order, one line, to the process's standard input. The process writes lines to standard output: how far it is, and at last its answer.
//!
//! - [`shutdown`]: the wish to stop
//! - [`memory_share`]: memory that studies and fits share
//! - `one_at_a_time`: work that somebody waits for, on a thread of its own
//! - [`own_process`]: starts a process, listens and waits; `answering`: the process's own side; `ending`: who is to blame for its end
//! - [`analysis_process`]: analyses of models that others run, in such a process

pub mod analysis_process;
pub(crate) mod answering;
mod ending;
pub mod memory_share;
pub(crate) mod one_at_a_time;
pub mod own_process;
pub mod shutdown;

/// Word in front of a line that tells how far the work is.
const TOLD: &str = "told ";
/// Word in front of the line that answers the order.
const ANSWER: &str = "answer ";
