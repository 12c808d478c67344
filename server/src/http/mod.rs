//! The service's outside: routes under `/v1`, health, and the dashboard.
//!
//! - [`edge`]: what every request passes on its way to a handler and back
//! - `mount`: the path below which a proxy serves all of it
//! - `short_ids`: `latest`, and beginnings of identifiers
//! - `app_state`: what every handler may use
//! - `routes`: the handlers, each with its operation
//! - `router`: all of it, guarded

pub(crate) mod app_state;
pub mod edge;
pub(crate) mod mount;
pub(crate) mod router;
pub(crate) mod routes;
pub(crate) mod short_ids;
