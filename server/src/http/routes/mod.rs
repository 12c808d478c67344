//! The handlers, each with its operation.
//!
//! - [`study_routes`]: submit, list, look at, cancel
//! - `entry_list`: how lists are asked for
//! - [`at_once`]: a document's places, one equilibrium of a scene
//! - [`sweep_routes`]: many designs at once
//! - [`comparison_routes`]: studies side by side
//! - [`event_routes`]: progress as server-sent events
//! - [`answers`]: what a study found
//! - [`estimators`]: forces from recordings
//! - `analysis_routes`: indices of models that others run
//! - `long_body`: bodies with files in them
//! - [`preset_routes`]: studies and scenes to start from
//! - [`upkeep`]: is it up, how it does, who is let in
//! - [`openapi`]: the description of all this
//! - [`assets`]: the dashboard, and the page of the operations

pub(crate) mod analysis_routes;
pub mod answers;
pub(crate) mod assets;
pub(crate) mod at_once;
pub(crate) mod comparison_routes;
mod entry_list;
pub mod estimators;
pub(crate) mod event_routes;
mod long_body;
pub mod openapi;
pub(crate) mod preset_routes;
pub(crate) mod study_routes;
pub(crate) mod sweep_routes;
pub(crate) mod upkeep;
