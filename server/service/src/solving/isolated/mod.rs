//! Solves in a process of their own: what may crash doesn't take the program with it, and the way it ends tells who is to blame.
//!
//! - `messages`: what the two processes tell each other
//! - `child`: the process that solves
//! - `ending`: who is to blame for a process's end
//! - `parent`: the solver that starts it and waits

pub mod child;
mod ending;
mod messages;
pub mod parent;
