//! Service on studies, whoever asks for it: neither HTTP nor command line.
//!
//! The modules, in reading order:
//!
//! - [`own_process`]: work in a process of its own
//! - [`solving`]: which solver answers, chosen here and nowhere else, and how a solve is watched
//! - [`shutdown`]: the wish to stop
//! - [`study_document`]: study documents from files and from the database
//! - [`views`]: what a study has solved as a reader sees it
//! - [`wire`]: what goes over the wire
//! - [`metrics`]: what is counted and measured
//! - `database_archive`: the database as the place where solved points are kept
//! - [`forecast`]: what a study would cost
//! - [`previewer`]: places at once, for somebody who writes a document
//! - [`engine`]: runs one study from its document to its end
//! - [`memory_share`]: memory that studies and fits share
//! - [`queue`]: the queue of studies; sweeps; removal
//! - [`comparison`]: studies side by side
//! - [`forces`]: forces from recordings
//! - [`export`]: answers as tables for other programs

pub mod comparison;
pub(crate) mod database_archive;
pub mod engine;
pub mod export;
pub mod forces;
pub mod forecast;
pub mod memory_share;
pub mod metrics;
pub mod own_process;
pub mod previewer;
pub mod queue;
pub mod shutdown;
pub mod solving;
pub mod study_document;
pub mod views;
pub mod wire;
