//! The service itself.
//!
//! - [`engine_routes`]: what other machines are at for it
//! - [`health`]: is it up, can it work
//! - [`login_routes`]: lets a browser in
//! - [`metric_routes`]: how it does

pub(crate) mod engine_routes;
pub(crate) mod health;
pub(crate) mod login_routes;
pub(crate) mod metric_routes;
