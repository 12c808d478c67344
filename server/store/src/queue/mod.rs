//! Queue: what was asked, whose turn it is, what happened.
//!
//! - [`study_rows`]: what was asked, and how far it got
//! - [`turns`]: whose turn it is
//! - [`sweep_rows`]: sweeps; [`design_rows`]: which studies are their designs
//! - [`listed`]: which of them a list shows
//! - [`estimator_rows`]: estimators of forces; [`estimator_parts`]: their recordings and what was learnt; [`estimator_zeros`]: zeros that they were given
//! - [`event_rows`]: what happened, in order
//! - [`short_names`]: the newest of them, and those whose identifiers begin so
//! - [`idempotency`]: keys of repeated requests

pub mod design_rows;
pub mod engine_rows;
pub mod estimator_parts;
pub mod estimator_rows;
pub mod estimator_zeros;
pub mod event_rows;
pub mod idempotency;
pub mod listed;
pub mod short_names;
pub mod study_rows;
pub mod sweep_rows;
pub mod turns;
