//! Who solves, and how a solve is watched.
//!
//! - [`solver_choice`]: which solver answers
//! - [`watched`]: solves that come to an end in time
//! - [`apart`]: solves in a process of their own
//! - [`numerics`]: solves told apart by the processor's last digits
//! - [`timekeeper`]: how long they take beside what was expected
//! - [`traced`]: solves whose lines in the log say for which study

pub mod apart;
pub mod numerics;
pub mod solver_choice;
pub mod timekeeper;
pub mod traced;
pub mod watched;
