//! What was asked, whose turn it is, what happened.
//!
//! - [`studies`]: what was asked, and how far it got
//! - [`turns`]: whose turn it is
//! - [`sweep_rows`]: which studies are the designs of one sweep
//! - [`events`]: what happened, in order
//! - [`idempotency`]: keys of repeated requests

pub mod events;
pub mod idempotency;
pub mod studies;
pub mod sweep_rows;
pub mod turns;
