//! The service itself.
//!
//! - [`health`]: is it up, can it work
//! - [`login_routes`]: lets a browser in
//! - [`metric_routes`]: how it does

pub(crate) mod health;
pub(crate) mod login_routes;
pub(crate) mod metric_routes;
