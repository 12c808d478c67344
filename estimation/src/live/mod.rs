//! Estimates of rows as they come in:
//!
//! - [`live_estimates`]: the rows of one run, one after another
//! - [`row_state`]: what a row of a stream is; [`row_watch`]: the same by its time

pub mod live_estimates;
pub mod row_state;
pub mod row_watch;
