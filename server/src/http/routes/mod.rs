//! The handlers, each with its operation.
//!
//! - [`study_routes`]: submit, list, look at, cancel
//! - `entry_list`: how lists are asked for
//! - [`preview_routes`]: a document's places at once
//! - [`sweep_routes`]: many designs at once
//! - [`comparison_routes`]: studies side by side
//! - [`event_routes`]: progress as server-sent events
//! - [`answers`]: what a study found
//! - [`estimators`]: forces from recordings
//! - [`preset_routes`]: studies and scenes to start from
//! - [`health`]: is it up, can it work
//! - [`login_routes`]: lets a browser in
//! - [`metric_routes`]: how it does
//! - [`openapi`]: the description of all this
//! - [`assets`]: the dashboard, and the page of the operations

pub mod answers;
pub(crate) mod assets;
pub(crate) mod comparison_routes;
mod entry_list;
pub mod estimators;
pub(crate) mod event_routes;
pub(crate) mod health;
pub(crate) mod login_routes;
pub(crate) mod metric_routes;
pub mod openapi;
pub(crate) mod preset_routes;
pub(crate) mod preview_routes;
pub(crate) mod study_routes;
pub(crate) mod sweep_routes;
