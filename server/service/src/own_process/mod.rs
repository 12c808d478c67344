//! Work in a process of its own: it can be ended at any moment, what may crash or exhaust memory doesn't take the program with it, and the way it ends tells who is to
//! blame.
//!
//! The parent writes an order, one line, to the process's standard input. The process writes lines to standard output: how far it is, and at last its answer.
//!
//! - `child`: the process that works
//! - `ending`: who is to blame for a process's end
//! - `parent`: starts it, listens and waits

pub(crate) mod child;
mod ending;
pub mod parent;

/// Word in front of a line that tells how far the work is.
const TOLD: &str = "told ";
/// Word in front of the line that answers the order.
const ANSWER: &str = "answer ";
