//! Solves in a process of their own.
//!
//! - `messages`: what the two processes tell each other
//! - `child`: the process that solves
//! - `parent`: the solver that starts it and waits

pub mod child;
mod messages;
pub mod parent;
