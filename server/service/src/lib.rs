//! Service on studies, whoever asks for it: neither HTTP nor command line.
//!
//! The modules, in reading order:
//!
//! - [`work`]: when work is to stop, what memory it has, and processes of its own
//! - [`solving`]: which solver answers, chosen here and nowhere else, and how a solve is watched
//! - [`study_document`]: study documents from files and from the database
//! - [`views`]: what a study has solved as a reader sees it
//! - [`wire`]: what goes over the wire
//! - [`metrics`]: what is counted and measured
//! - `database_archive`: the database as the place where solved points are kept
//! - [`forecast`]: what a study would cost
//! - [`at_once`]: previews and single scenes, beside the queue
//! - [`engine`]: runs one study from its document to its end
//! - [`queue`]: the queue of studies; sweeps; removal
//! - [`comparison`]: studies side by side
//! - [`forces`]: forces from recordings
//! - [`export`]: answers as tables for other programs

pub mod at_once;
pub mod comparison;
pub(crate) mod database_archive;
pub mod engine;
pub mod export;
pub mod forces;
pub mod forecast;
pub mod metrics;
pub mod queue;
pub mod solving;
pub mod study_document;
pub mod views;
pub mod wire;
pub mod work;
