//! The handlers, each with its operation.
//!
//! - [`study_routes`]: submit, list, look at, cancel
//! - [`sweep_routes`]: many designs at once
//! - [`comparison_routes`]: studies side by side
//! - [`event_routes`]: progress as server-sent events
//! - [`result_routes`], [`sent_result`]: result, locations, layouts, evaluations, map
//! - [`export_routes`]: answers as tables
//! - [`preset_routes`]: studies and scenes to start from
//! - [`health`]: is it up, can it work
//! - [`login_routes`]: lets a browser in
//! - [`metric_routes`]: how it does
//! - [`openapi`], [`docs`]: the description of all this
//! - [`assets`]: the dashboard

pub mod assets;
pub mod comparison_routes;
pub mod docs;
pub mod event_routes;
pub mod export_routes;
pub mod health;
pub mod login_routes;
pub mod metric_routes;
pub mod openapi;
pub mod preset_routes;
pub mod result_routes;
pub mod sent_result;
pub mod study_routes;
pub mod sweep_routes;
